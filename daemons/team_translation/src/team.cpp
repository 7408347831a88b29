// SPDX-License-Identifier: Apache-2.0
#include "skein/team_translation/team.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "skein/foundation/overloaded.hpp"
#include "skein/team/global_mission.hpp"
#include "team_needs.hpp"
#include "team_numbers.hpp"

namespace skein::translation {

namespace {

namespace a = auction;
using a::MemberNumber;
using a::TaskNumber;

static_assert(static_cast<int>(wire::TeamStage::kUnsold) == static_cast<int>(a::Stage::kUnsold));

constexpr double kUnlimited = 1e300;  ///< [J] in place of infinity
constexpr double kInfinity = std::numeric_limits<double>::infinity();

tl::unexpected<wire::Violation> wrong(std::string field, std::string why) {
  return tl::unexpected<wire::Violation>({std::move(field), std::move(why)});
}

// ---- tasks ----

wire::TeamTask wire_task(const a::Task& task, bool with_work) {
  wire::TeamTask result;
  result.number = task.number.value();
  result.duration = task.duration;
  result.needs = task.needs;
  result.needs_each = task.needs_each;
  result.least_members = task.least_members;
  result.earliest = task.earliest;
  result.has_deadline = std::isfinite(task.deadline);
  if (result.has_deadline) result.deadline = task.deadline;
  result.x = task.at.x;
  result.y = task.at.y;
  if (task.pinned) result.pinned = {task.pinned->value()};
  result.forbidden = values_of(task.forbidden);
  result.repeatable = task.repeatable;
  const team::Order* order = team::order_of(task);
  if (order == nullptr || !with_work) return result;
  result.work = {to_wire(order->task)};
  result.asked_by = order->asked_by;
  for (const interaction::Requirement& need : order->needs)
    result.needs_of_work.push_back(to_wire(need));
  return result;
}

Read<a::Task> task_of(const wire::TeamTask& task, const std::string& path) {
  a::Task result;
  result.number = TaskNumber(task.number);
  result.duration = task.duration;
  result.needs = task.needs;
  result.needs_each = task.needs_each;
  result.least_members = task.least_members;
  result.earliest = task.earliest;
  result.deadline = task.has_deadline ? task.deadline : kInfinity;
  result.at = {task.x, task.y};
  if (task.pinned.size() > 1) return wrong(path + ".pinned", "to several");
  if (!task.pinned.empty()) result.pinned = MemberNumber(task.pinned.front());
  result.forbidden = set_of<MemberNumber>(task.forbidden);
  result.repeatable = task.repeatable;
  if (task.duration < 0) return wrong(path + ".duration", "negative");
  if (task.work.size() > 1) return wrong(path + ".work", "several");
  if (task.work.empty()) return result;
  auto work = from_wire(task.work.front(), path + ".work[0]");
  if (!work) return tl::unexpected(work.error());
  interaction::Requirements needs;
  for (const wire::TeamNeed& need : task.needs_of_work) needs.push_back(from_wire(need));
  result.work =
      std::make_shared<const team::Order>(std::move(*work), task.asked_by, std::move(needs));
  return result;
}

std::vector<wire::TeamPrecedence> to_wire(const std::vector<a::Precedence>& precedences) {
  std::vector<wire::TeamPrecedence> result;
  for (const a::Precedence& one : precedences) {
    result.push_back({one.first.value(), one.then.value()});
  }
  return result;
}

std::vector<a::Precedence> from_wire(const std::vector<wire::TeamPrecedence>& precedences) {
  std::vector<a::Precedence> result;
  for (const wire::TeamPrecedence& one : precedences) {
    result.push_back({TaskNumber(one.first), TaskNumber(one.after)});
  }
  return result;
}

// What is sold says itself how long after others it begins.
void take_delay(a::Precedence& precedence, const a::Task& then) {
  const team::Order* order = team::order_of(then);
  if (order != nullptr) precedence.delay = team::delay_after(precedence.first, order->task);
}

Read<a::Lot> lot_of(const std::vector<wire::TeamTask>& tasks,
                    const std::vector<wire::TeamPrecedence>& precedences) {
  a::Lot lot;
  std::set<std::uint32_t> numbers;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const std::string path = "tasks[" + std::to_string(i) + "]";
    if (!numbers.insert(tasks[i].number).second) return wrong(path + ".number", "given twice");
    auto task = task_of(tasks[i], path);
    if (!task) return tl::unexpected(task.error());
    lot.tasks.push_back(std::move(*task));
  }
  lot.precedences = from_wire(precedences);
  for (a::Precedence& one : lot.precedences)
    for (const a::Task& task : lot.tasks)
      if (task.number == one.then) take_delay(one, task);
  return lot;
}

// ---- the ledger ----

std::vector<wire::TeamLoss> to_wire(const a::Losses& losses) {
  std::vector<wire::TeamLoss> result;
  for (const auto& [member, turns] : losses.turns()) result.push_back({member.value(), turns});
  return result;
}

a::Losses from_wire(const std::vector<wire::TeamLoss>& all) {
  a::Losses losses;
  for (const wire::TeamLoss& one : all) losses.learn(MemberNumber(one.member), one.turns);
  return losses;
}

wire::TeamLedger to_wire(const a::Ledger& ledger) {
  wire::TeamLedger result;
  result.term = ledger.term;
  result.revision = ledger.revision;
  result.missions = values_of(ledger.missions);
  for (const auto& [number, entry] : ledger.entries) {
    result.entries.push_back({wire_task(entry.task, true),
                              static_cast<wire::TeamStage>(entry.stage), values_of(entry.owners),
                              entry.sale, values_of(entry.finished), values_of(entry.stopped),
                              entry.revision, entry.why});
  }
  result.precedences = to_wire(ledger.precedences);
  for (const auto& [member, tasks] : ledger.routes) {
    result.routes.push_back({member.value(), values_of(tasks)});
  }
  result.losses = to_wire(ledger.losses);
  return result;
}

Read<std::shared_ptr<const a::Ledger>> ledger_of(const wire::TeamLedger& sample) {
  auto ledger = std::make_shared<a::Ledger>();
  ledger->term = sample.term;
  ledger->revision = sample.revision;
  ledger->missions = set_of<a::MissionNumber>(sample.missions);
  for (std::size_t i = 0; i < sample.entries.size(); ++i) {
    const wire::TeamEntry& one = sample.entries[i];
    const std::string path = "ledger[0].entries[" + std::to_string(i) + "]";
    auto task = task_of(one.task, path + ".task");
    if (!task) return tl::unexpected(task.error());
    a::LedgerEntry entry{std::move(*task),
                         static_cast<a::Stage>(one.stage),
                         list_of<MemberNumber>(one.owners),
                         one.sale,
                         set_of<MemberNumber>(one.finished),
                         set_of<MemberNumber>(one.stopped),
                         one.revision,
                         one.why};
    const TaskNumber number = entry.task.number;
    if (!ledger->entries.emplace(number, std::move(entry)).second) {
      return wrong(path + ".task.number", "given twice");
    }
  }
  ledger->precedences = from_wire(sample.precedences);
  for (a::Precedence& one : ledger->precedences) {
    const auto then = ledger->entries.find(one.then);
    if (then != ledger->entries.end()) take_delay(one, then->second.task);
  }
  for (const wire::TeamRoute& route : sample.routes) {
    ledger->routes[MemberNumber(route.member)] = list_of<TaskNumber>(route.tasks);
  }
  ledger->losses = from_wire(sample.losses);
  return std::shared_ptr<const a::Ledger>(std::move(ledger));
}

std::vector<wire::TeamClaim> to_wire(const std::vector<a::Claim>& claims,
                                     const std::vector<std::string>& why = {}) {
  std::vector<wire::TeamClaim> result;
  for (std::size_t i = 0; i < claims.size(); ++i) {
    result.push_back({claims[i].task.value(), claims[i].sale, i < why.size() ? why[i] : ""});
  }
  return result;
}

std::vector<a::Claim> from_wire(const std::vector<wire::TeamClaim>& claims) {
  std::vector<a::Claim> result;
  for (const wire::TeamClaim& one : claims) result.push_back({TaskNumber(one.task), one.sale});
  return result;
}

std::vector<wire::TeamEnd> to_wire(const std::vector<a::DoneClaim>& all) {
  std::vector<wire::TeamEnd> result;
  for (const auto& [claim, at] : all)
    result.push_back({claim.task.value(), claim.sale, at.count()});
  return result;
}

std::vector<a::DoneClaim> from_wire(const std::vector<wire::TeamEnd>& all) {
  std::vector<a::DoneClaim> result;
  for (const wire::TeamEnd& one : all)
    result.push_back({{TaskNumber(one.task), one.sale}, MissionTime::nanoseconds(one.at)});
  return result;
}

// ---- token and ledger ----

wire::TeamMessage sample_of(const a::Beat& beat) {
  wire::TeamMessage sample;
  sample.word = wire::TeamWord::kBeat;
  sample.term = beat.term;
  sample.revision = beat.committed;
  if (beat.ledger) sample.ledger = {to_wire(*beat.ledger)};
  return sample;
}

wire::TeamMessage sample_of(const a::Status& status) {
  wire::TeamMessage sample;
  sample.word = wire::TeamWord::kStatus;
  sample.term = status.term;
  sample.revision = status.revision;
  sample.bids = status.bids;
  sample.wants = to_wire(status.wants);
  sample.done = to_wire(status.done);
  sample.stopped = to_wire(status.stopped, status.stopped_why);
  for (const a::GivenMission& mission : status.missions) {
    wire::TeamMission& one = sample.missions.emplace_back();
    one.number = mission.number.value();
    for (const a::Task& task : mission.lot.tasks) one.tasks.push_back(wire_task(task, true));
    one.precedences = to_wire(mission.lot.precedences);
  }
  sample.losses = to_wire(status.losses);
  return sample;
}

wire::TeamMessage sample_of(const a::VoteRequest& request) {
  wire::TeamMessage sample;
  sample.word = wire::TeamWord::kVoteRequest;
  sample.term = request.term;
  sample.trial = request.trial;
  sample.ledger_term = request.ledger_term;
  sample.revision = request.ledger_revision;
  return sample;
}

wire::TeamMessage sample_of(const a::Vote& vote) {
  wire::TeamMessage sample;
  sample.word = wire::TeamWord::kVote;
  sample.term = vote.term;
  sample.trial = vote.trial;
  return sample;
}

wire::TeamMessage sample_of(const a::NewerTerm& newer) {
  wire::TeamMessage sample;
  sample.word = wire::TeamWord::kNewerTerm;
  sample.term = newer.term;
  return sample;
}

Read<a::TeamMessage> beat_of(const wire::TeamMessage& sample) {
  a::Beat beat{sample.term, sample.revision, nullptr};
  if (sample.ledger.size() > 1) return wrong("ledger", "several");
  if (sample.ledger.empty()) return a::TeamMessage(beat);
  auto ledger = ledger_of(sample.ledger.front());
  if (!ledger) return tl::unexpected(ledger.error());
  beat.ledger = std::move(*ledger);
  return a::TeamMessage(beat);
}

Read<a::TeamMessage> status_of(const wire::TeamMessage& sample) {
  a::Status status;
  status.term = sample.term;
  status.revision = sample.revision;
  status.bids = sample.bids;
  status.wants = from_wire(sample.wants);
  status.done = from_wire(sample.done);
  status.stopped = from_wire(sample.stopped);
  for (const wire::TeamClaim& one : sample.stopped) status.stopped_why.push_back(one.why);
  for (const wire::TeamMission& mission : sample.missions) {
    auto lot = lot_of(mission.tasks, mission.precedences);
    if (!lot) return tl::unexpected(lot.error());
    status.missions.push_back({a::MissionNumber(mission.number), std::move(*lot)});
  }
  status.losses = from_wire(sample.losses);
  return a::TeamMessage(std::move(status));
}

// ---- sales ----

wire::TeamLeg to_wire(const a::Leg& leg) { return {leg.seconds, leg.cost, leg.energy}; }
a::Leg from_wire(const wire::TeamLeg& leg) { return {leg.seconds, leg.cost, leg.energy}; }

std::vector<wire::TeamLeg> to_wire(const std::vector<a::Leg>& legs) {
  std::vector<wire::TeamLeg> result;
  for (const a::Leg& leg : legs) result.push_back(to_wire(leg));
  return result;
}

std::vector<a::Leg> from_wire(const std::vector<wire::TeamLeg>& legs) {
  std::vector<a::Leg> result;
  for (const wire::TeamLeg& leg : legs) result.push_back(from_wire(leg));
  return result;
}

void put_lot(wire::TeamSale& sample, const a::Catalogue& lot) {
  for (const a::Task& task : lot.lot().tasks) sample.tasks.push_back(wire_task(task, false));
  sample.precedences = to_wire(lot.lot().precedences);
}

wire::TeamSale sample_of(const a::ToMember& message) {
  wire::TeamSale sample;
  std::visit(Overloaded{[&](const a::Call& call) {
                          sample.word = wire::TeamSaleWord::kCall;
                          sample.fixed_tasks = call.fixed;
                          sample.items = values_of(call.items);
                          sample.gaps = call.gaps;
                          sample.between = call.between;
                        },
                        [&](const a::Award&) { sample.word = wire::TeamSaleWord::kAward; }},
             message);
  std::visit(
      [&](const auto& one) {
        sample.sale = one.sale.value();
        sample.round = one.round;
        put_lot(sample, *one.lot);
        sample.route = values_of(one.route);
      },
      message);
  return sample;
}

wire::TeamSale sample_of(const a::Offer& offer) {
  wire::TeamSale sample;
  sample.word = wire::TeamSaleWord::kOffer;
  sample.sale = offer.sale.value();
  sample.round = offer.round;
  sample.abilities = offer.abilities;
  sample.free_from = offer.free_from;
  sample.energy = std::clamp(offer.energy, -kUnlimited, kUnlimited);
  sample.legs = to_wire(offer.legs);
  for (const a::ItemPrice& price : offer.items) {
    wire::TeamPrice& one = sample.prices.emplace_back();
    one.item = price.item.value();
    one.energy = price.energy;
    for (const a::GapPrice& gap : price.gaps) {
      one.gaps.push_back({gap.gap, to_wire(gap.in), to_wire(gap.out)});
    }
    one.objection = price.objection;
  }
  sample.ways = to_wire(offer.between);
  return sample;
}

wire::TeamSale sample_of(const a::Answer& answer) {
  wire::TeamSale sample;
  sample.word = wire::TeamSaleWord::kAnswer;
  sample.sale = answer.sale.value();
  sample.round = answer.round;
  sample.refused = answer.refusal.has_value();
  sample.why = answer.refusal.value_or("");
  sample.legs = to_wire(answer.legs);
  sample.energy = std::clamp(answer.energy, -kUnlimited, kUnlimited);
  return sample;
}

double energy_of(double sent) { return sent >= kUnlimited ? kInfinity : sent; }

// A call or an award, which must be about its lot.
Read<a::TeamMessage> call_of(const wire::TeamSale& sample) {
  auto lot = lot_of(sample.tasks, sample.precedences);
  if (!lot) return tl::unexpected(lot.error());
  const auto catalogue = std::make_shared<const a::Catalogue>(std::move(*lot));
  std::set<TaskNumber> seen;
  for (const auto* list : {&sample.route, &sample.items}) {
    const char* name = list == &sample.route ? "route" : "items";
    for (const std::uint32_t number : *list) {
      if (!catalogue->has(TaskNumber(number))) return wrong(name, "a task that is not in the lot");
      if (!seen.insert(TaskNumber(number)).second) return wrong(name, "a task twice");
    }
  }
  const auto route = list_of<TaskNumber>(sample.route);
  const a::SaleNumber sale(sample.sale);
  if (sample.word == wire::TeamSaleWord::kAward) {
    return a::TeamMessage(a::ToMember(a::Award{sale, sample.round, catalogue, route}));
  }
  if (sample.fixed_tasks > route.size()) return wrong("fixed_tasks", "more than the route has");
  return a::TeamMessage(
      a::ToMember(a::Call{sale, sample.round, catalogue, route, sample.fixed_tasks,
                          list_of<TaskNumber>(sample.items), sample.gaps, sample.between}));
}

a::TeamMessage offer_of(const wire::TeamSale& sample) {
  a::Offer offer;
  offer.sale = a::SaleNumber(sample.sale);
  offer.round = sample.round;
  offer.abilities = sample.abilities;
  offer.free_from = sample.free_from;
  offer.energy = energy_of(sample.energy);
  offer.legs = from_wire(sample.legs);
  for (const wire::TeamPrice& price : sample.prices) {
    a::ItemPrice& one = offer.items.emplace_back();
    one.item = TaskNumber(price.item);
    one.energy = price.energy;
    for (const wire::TeamGap& gap : price.gaps) {
      one.gaps.push_back({gap.gap, from_wire(gap.way_in), from_wire(gap.way_out)});
    }
    one.objection = price.objection;
  }
  offer.between = from_wire(sample.ways);
  return a::ToAuctioneer(std::move(offer));
}

a::TeamMessage answer_of(const wire::TeamSale& sample) {
  a::Answer answer;
  answer.sale = a::SaleNumber(sample.sale);
  answer.round = sample.round;
  if (sample.refused) answer.refusal = sample.why;
  answer.legs = from_wire(sample.legs);
  answer.energy = energy_of(sample.energy);
  return a::ToAuctioneer(std::move(answer));
}

}  // namespace

wire::Sample to_wire(const a::TeamMessage& message) {
  return std::visit(Overloaded{[](const a::ToAuctioneer& it) -> wire::Sample {
                                 return std::visit([](const auto& one) { return sample_of(one); },
                                                   it);
                               },
                               [](const auto& it) -> wire::Sample { return sample_of(it); }},
                    message);
}

Read<a::TeamMessage> from_wire(const wire::TeamMessage& sample) {
  switch (sample.word) {
    case wire::TeamWord::kBeat:
      return beat_of(sample);
    case wire::TeamWord::kStatus:
      return status_of(sample);
    case wire::TeamWord::kVoteRequest:
      return a::TeamMessage(
          a::VoteRequest{sample.term, sample.trial, sample.ledger_term, sample.revision});
    case wire::TeamWord::kVote:
      return a::TeamMessage(a::Vote{sample.term, sample.trial});
    default:
      return a::TeamMessage(a::NewerTerm{sample.term});
  }
}

Read<a::TeamMessage> from_wire(const wire::TeamSale& sample) {
  switch (sample.word) {
    case wire::TeamSaleWord::kOffer:
      return offer_of(sample);
    case wire::TeamSaleWord::kAnswer:
      return answer_of(sample);
    default:
      return call_of(sample);
  }
}

}  // namespace skein::translation
