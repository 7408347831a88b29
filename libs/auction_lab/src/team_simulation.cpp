// SPDX-License-Identifier: Apache-2.0
#include "skein/auction_lab/team_simulation.hpp"

#include <cmath>

#include "skein/foundation/contract.hpp"
#include "skein/foundation/overloaded.hpp"

namespace skein::auction {

namespace {

std::size_t index_of(MemberNumber member) { return member.value(); }
MemberNumber number_of(std::size_t member) {
  return MemberNumber(static_cast<std::uint32_t>(member));
}

}  // namespace

TeamSimulation::TeamSimulation(TeamWorld world)
    : world_(std::move(world)),
      random_(world_.seed, "auction/team-simulation"),
      members_(world_.vehicles.size() + (world_.ground ? 1 : 0)) {
  for (std::size_t i = 0; i < members_.size(); ++i) {
    if (i < world_.vehicles.size()) members_[i].at = world_.vehicles[i].begin;
    start(i);
  }
}

void TeamSimulation::start(std::size_t member) {
  Member& one = members_[member];
  TeamSetup setup;
  setup.self = number_of(member);
  for (std::size_t i = 0; i < members_.size(); ++i) setup.roster.push_back(number_of(i));
  if (member < world_.vehicles.size()) {
    setup.craft = [this, member](std::shared_ptr<const Catalogue> lot, MissionTime) {
      FlatVehicle vehicle = world_.vehicles[member];
      vehicle.begin = members_[member].at;
      return std::make_unique<const FlatCraft>(vehicle, std::move(lot));
    };
  }
  setup.limits = world_.limits;
  setup.seed = world_.seed;
  setup.disk = one.disk;
  one.alive = std::make_unique<TeamMember>(std::move(setup));
  ++one.life;
  feed(member, Tick{});
}

void TeamSimulation::crash(std::size_t member) {
  Member& one = members_[member];
  if (!one.alive) return;
  one.alive.reset();
  ++one.life;
  if (!one.running) return;
  executions_[*one.running].end = Execution::End::kCrashed;
  executions_[*one.running].ended = now_;
  one.running.reset();
}

void TeamSimulation::restart(std::size_t member) {
  if (!members_[member].alive) start(member);
}

void TeamSimulation::give(std::size_t member, const GivenMission& mission) {
  feed(member, MissionGiven{mission});
}

void TeamSimulation::declare_lost(std::size_t told, std::size_t lost) {
  feed(told, DeclaredLost{number_of(lost)});
}

void TeamSimulation::declare_found(std::size_t told, std::size_t found) {
  feed(told, DeclaredFound{number_of(found)});
}

void TeamSimulation::fail_task(std::size_t member) {
  Member& one = members_[member];
  if (!one.alive || !one.running) return;
  Execution& execution = executions_[*one.running];
  execution.end = Execution::End::kFailed;
  execution.ended = now_;
  one.running.reset();
  feed(member, TaskPutBack{execution.claim.task});
}

void TeamSimulation::cut(std::size_t one, std::size_t other) {
  cuts_.insert(std::minmax(one, other));
}

bool TeamSimulation::linked(std::size_t one, std::size_t other) const {
  return !cuts_.contains(std::minmax(one, other));
}

void TeamSimulation::schedule(std::size_t member, Duration in, TeamInput input) {
  events_.push({now_ + in, ++events_made_, member, members_[member].life, std::move(input)});
}

void TeamSimulation::send(std::size_t from, const Tell& tell) {
  ++messages_;
  const double part = random_.uniform();
  const std::size_t to = index_of(tell.to);
  if (random_.chance(world_.loss) || !linked(from, to)) return;
  const auto span = static_cast<double>((world_.longest_delay - world_.least_delay).count());
  const auto delay =
      world_.least_delay + Duration::nanoseconds(static_cast<std::int64_t>(part * span));
  schedule(to, delay, Heard{number_of(from), tell.message});
}

// The way too begins no sooner than the task may; what would begin too late is put back.
void TeamSimulation::begin(std::size_t member, const Claim& claim) {
  Member& one = members_[member];
  SKEIN_EXPECTS(!one.running);
  const LedgerEntry& entry = one.alive->ledger().entries.at(claim.task);
  const Task& task = entry.task;
  const Place to = task.at;
  const double way = std::hypot(to.x - one.at.x, to.y - one.at.y) / world_.vehicles[member].speed;
  const MissionTime from = std::max(now_, MissionTime::seconds(task.earliest));
  const MissionTime there = from + Duration::seconds(way);
  if (there.to_seconds() > task.deadline - task.duration) {
    return schedule(member, Duration(), TaskPutBack{claim.task, "it would be too late"});
  }
  one.at = to;
  one.running = executions_.size();
  executions_.push_back({claim,
                         number_of(member),
                         from,
                         {},
                         Execution::End::kRunning,
                         entry.owners,
                         entry.why,
                         there});
  schedule(member, there + Duration::seconds(task.duration) - now_, TaskDone{claim.task});
}

void TeamSimulation::feed(std::size_t member, const TeamInput& input) {
  Member& one = members_[member];
  if (!one.alive) return;
  if (std::holds_alternative<TaskDone>(input)) {
    if (!one.running || executions_[*one.running].claim.task != std::get<TaskDone>(input).task)
      return;
    executions_[*one.running].end = Execution::End::kDone;
    executions_[*one.running].ended = now_;
    one.running.reset();
  }
  for (TeamEffect& effect : one.alive->handle(input, now_)) {
    std::visit(
        Overloaded{[&](Tell& tell) { send(member, tell); },
                   [&](Store& store) { one.disk = std::move(store.disk); },
                   [&](BeginTask& task) { begin(member, task.claim); },
                   [&](TokenTaken& token) {
                     tokens_.push_back({number_of(member), token.term, now_});
                   },
                   [&](SaleTold& told) { told_.push_back(std::move(told.what)); }, [](auto&) {}},
        effect);
  }
}

void TeamSimulation::run_until(MissionTime until) {
  while (now_ < until) {
    std::optional<std::size_t> waking;
    MissionTime next = events_.empty() ? until : std::min(until, events_.top().at);
    for (std::size_t i = 0; i < members_.size(); ++i) {
      if (!members_[i].alive) continue;
      const auto wakeup = members_[i].alive->next_wakeup();
      if (!wakeup || *wakeup >= next) continue;
      next = std::max(*wakeup, now_);
      waking = i;
    }
    now_ = next;
    if (waking) {
      feed(*waking, Tick{});
    } else if (!events_.empty() && events_.top().at <= now_) {
      const Event event = events_.top();
      events_.pop();
      if (event.life == members_[event.member].life) feed(event.member, event.input);
    }
  }
}

std::size_t TeamSimulation::token_holders() const {
  std::size_t holders = 0;
  for (const Member& member : members_)
    holders += member.alive && member.alive->holds_token() ? 1 : 0;
  return holders;
}

}  // namespace skein::auction
