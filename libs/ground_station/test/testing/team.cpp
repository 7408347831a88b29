// SPDX-License-Identifier: Apache-2.0
#include "testing/team.hpp"

namespace skein::ground_station::testing {

using executive::TaskId;
using executive::TaskState;

namespace {

// takeshot and wait go on until they are interrupted.
std::optional<double> seconds_of(const std::string& type) {
  if (type == "takeoff" || type == "land") return 5;
  if (type == "goto") return 20;
  return std::nullopt;
}

}  // namespace

Team::Team(const std::vector<Member>& members, Script script, double latency)
    : latency_(Duration::seconds(latency)) {
  GroundConfig config;
  config.script = std::move(script);
  for (const Member& member : members) {
    config.uavs.push_back({member.name, member.degree, {}});
    Uav& uav = uavs_[member.name];
    uav.member = member;
    make_mle(uav);
  }
  ground_ = std::make_unique<GroundControl>(config, flat_terrain());
}

void Team::make_mle(Uav& uav) {
  if (runs_at_ground(uav.member.degree)) return;
  executive::Config config;
  config.name = uav.member.name;
  uav.mle = std::make_unique<executive::Executive>(config);
}

bool Team::play(double until) {
  tell_ground(Tick{});
  while (!ground_->finished()) {
    const std::optional<MissionTime> next = next_instant();
    if (!next || *next > MissionTime::seconds(until)) return false;
    now_ = std::max(now_, *next);
    if (!queue_.empty() && queue_.begin()->first.first <= now_) {
      const Deed deed = std::move(queue_.begin()->second);
      queue_.erase(queue_.begin());
      deed();
      continue;
    }
    tell_ground(Tick{});
    for (auto& [name, uav] : uavs_) {
      if (uav.mle && uav.mle->next_wakeup() <= now_) to_mle(name, executive::Tick{});
    }
  }
  return true;
}

std::optional<MissionTime> Team::next_instant() const {
  std::optional<MissionTime> next = ground_->next_wakeup();
  if (!queue_.empty()) next = earliest(next, queue_.begin()->first.first);
  for (const auto& [name, uav] : uavs_) {
    if (uav.mle) next = earliest(next, uav.mle->next_wakeup());
  }
  return next;
}

void Team::cut(const std::string& uav, double from, double until) {
  uavs_[uav].cut_from = MissionTime::seconds(from);
  uavs_[uav].cut_until = MissionTime::seconds(until);
}

void Team::restart(const std::string& uav, double when) {
  after(MissionTime::seconds(when) - now_, [this, uav] {
    make_mle(uavs_[uav]);
    uavs_[uav].handled.clear();
    uavs_[uav].busy.clear();
    tell_ground(PeerReachable{uav, true, true});
  });
}

double Team::instant(const std::string& uav, std::uint64_t task, TaskState state) const {
  const auto found = instants_.find({uav, TaskId(task), state});
  return found == instants_.end() ? -1 : found->second.to_seconds();
}

void Team::after(Duration delay, Deed deed) {
  queue_.emplace(std::pair(now_ + delay, sequence_++), std::move(deed));
}

void Team::by_radio(const std::string& uav, Deed deed) {
  const Uav& it = uavs_[uav];
  const bool is_cut = it.cut_from <= now_ && now_ < it.cut_until;
  after(is_cut ? it.cut_until - now_ + latency_ : latency_, std::move(deed));
}

void Team::from_ground(const std::vector<GroundControl::Effect>& effects) {
  for (const auto& effect : effects) {
    std::visit([&](const auto& it) { take(it); }, effect);
  }
}

void Team::take(const SendRequest& request) {
  by_radio(request.uav, [this, request] {
    Uav& uav = uavs_[request.uav];
    if (!uav.mle || now_ > request.expires || !uav.handled.insert(request.command).second) return;
    std::visit(
        [&](const auto& it) {
          if constexpr (std::is_constructible_v<executive::Input, decltype(it)>) {
            to_mle(request.uav, it, request.command);
          }
        },
        request.request);
  });
}

void Team::take(const SendFunctional& request) {
  by_radio(request.uav, [this, request] {
    vehicle(request.uav, request.request.id, request.request.type, request.request.verb);
  });
}

void Team::take(const SendSync& message) {
  by_radio(message.to, [this, message] {
    to_mle(message.to,
           executive::SyncReceived{message.id, message.from, message.word, message.said});
  });
}

void Team::to_mle(const std::string& uav, const executive::Input& input, CommandNumber command) {
  for (const auto& effect : uavs_[uav].mle->handle(input, now_)) from_mle(uav, effect, command);
}

void Team::from_mle(const std::string& uav, const executive::Effect& effect,
                    CommandNumber command) {
  if (const auto* event = std::get_if<executive::TaskEvent>(&effect)) {
    record(uav, event->id, event->state);
    by_radio(uav, [this, uav, it = *event] {
      tell_ground(TaskEventReceived{uav, it.id, it.type, it.state, it.reason});
    });
  } else if (const auto* reply = std::get_if<executive::Reply>(&effect)) {
    by_radio(uav, [this, command, it = *reply] {
      tell_ground(RequestReplyReceived{command, it.accepted, it.why});
    });
  } else if (const auto* dispatch = std::get_if<executive::Dispatch>(&effect)) {
    const std::string type = uavs_[uav].mle->find(dispatch->id)->type;
    vehicle(uav, dispatch->id, type, functional::Verb::kDispatch);
  } else if (const auto* interrupt = std::get_if<executive::Interrupt>(&effect)) {
    vehicle(uav, interrupt->id, "", functional::Verb::kInterrupt);
  } else if (const auto* message = std::get_if<executive::SendSync>(&effect)) {
    sync(message->id, uav, message->to);
  }
}

void Team::sync(std::uint64_t sync_id, const std::string& from, const std::string& to) {
  if (synchronises_directly(uavs_[from].member.degree, uavs_[to].member.degree)) {
    after(latency_, [this, sync_id, from, to] {
      to_mle(to, executive::SyncReceived{sync_id, from});
    });
  } else {
    by_radio(from, [this, sync_id, from, to] { tell_ground(SyncReceived{sync_id, from, to}); });
  }
}

void Team::vehicle(const std::string& uav, TaskId task, const std::string& type,
                   functional::Verb verb) {
  std::set<TaskId>& busy = uavs_[uav].busy;
  if (verb == functional::Verb::kInterrupt) {
    if (busy.erase(task) > 0) report(uav, task, TaskState::kAborted);
    return;
  }
  busy.insert(task);
  report(uav, task, TaskState::kRunning);
  const std::optional<double> seconds = seconds_of(type);
  if (!seconds) return;
  after(Duration::seconds(*seconds * uavs_[uav].member.slowness), [this, uav, task] {
    if (uavs_[uav].busy.erase(task) > 0) report(uav, task, TaskState::kEnded);
  });
}

void Team::report(const std::string& uav, TaskId task, TaskState state) {
  const executive::FunctionalStatus status{task, state, ""};
  if (uavs_[uav].mle) {
    after(Duration(), [this, uav, status] { to_mle(uav, status); });
  } else {
    by_radio(uav, [this, uav, status] { tell_ground(FunctionalStatusReceived{uav, status}); });
  }
}

void Team::record(const std::string& uav, TaskId task, TaskState state) {
  history_[uav].push_back(skein::to_text(task) + " " + std::string(executive::to_text(state)));
  instants_.try_emplace({uav, task, state}, now_);
}

}  // namespace skein::ground_station::testing
