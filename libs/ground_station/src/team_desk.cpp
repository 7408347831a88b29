// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/team_desk.hpp"

#include <algorithm>

#include "skein/auction/lateness.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/foundation/overloaded.hpp"
#include "skein/mission/degree.hpp"
#include "skein/team/abilities.hpp"

namespace skein::ground_station {

namespace {

/// So often nobody could, one call after another, before it is said that the mission is over: who
/// was out of reach, or busy with what it was pinned to, may bid at the next.
constexpr int kCalls = 2;

}  // namespace

TeamDesk::TeamDesk(const team::Config& config, const std::string& self, MissionKnowledge knowledge,
                   std::vector<std::string> uavs)
    : roster_(config.roster),
      knowledge_(std::move(knowledge)),
      uavs_(std::move(uavs)),
      member_(setup_of(config, self)),
      ownership_(config.roster) {}

std::vector<TeamDesk::Effect> TeamDesk::handle(const Input& input, MissionTime now) {
  Effects out;
  std::visit(Overloaded{[&](const TeamHeard& heard) {
                          const auto from = roster_.number_of(heard.from);
                          if (from) tell_member(auction::Heard{*from, heard.message}, now, out);
                        },
                        [&](const Tick&) { tell_member(auction::Tick{}, now, out); },
                        [&](const auto& it) { accept(it, now, out); }},
             input);
  tell_news(now, out);
  return out;
}

// Given again it is the same mission; a task that another mission has already is none of this one.
void TeamDesk::accept(const GiveGlobalMission& given, MissionTime now, Effects& out) {
  const team::GlobalMission& mission = given.mission;
  std::vector<std::string> problems;
  if (!given_.contains(mission.id)) {
    const mission::Surroundings around{knowledge_.places, knowledge_.zones, uavs_, nullptr};
    const mission::Vocabulary vocabulary = knowledge_.vocabulary.value_or(mission::Vocabulary());
    problems = problems_of(mission, roster_, vocabulary, around, now);
    for (team::Conflict& one : team::lacks_of(mission, roster_, knowledge_.vehicles))
      problems.push_back(std::move(one.sentence));
    for (const team::GlobalTask& task : mission.tasks) {
      if (!tasks_.contains(task.task.id)) continue;
      problems.push_back("task " + skein::to_text(task.task.id) + " is one of another mission");
    }
  }
  if (!problems.empty()) {
    out.emplace_back(
        GlobalMissionChanged{mission.id, GlobalStage::kRefused, joined(problems, "; ")});
    return;
  }
  const bool again = !given_.insert(mission.id).second;
  out.emplace_back(GlobalMissionChanged{mission.id, GlobalStage::kGiven,
                                        again ? "for the second time: nothing changes" : ""});
  if (again) return;
  for (const team::GlobalTask& task : mission.tasks) {
    open_[mission.id].insert(task.task.id);
    after_[task.task.id] = task.after;
    if (task.by) pinned_[task.task.id] = *task.by;
    tasks_.insert(task.task.id);
  }
  waiting_[mission.id] = mission;
  give_what_may(mission.id, now, out);
  const auto rest = waiting_.find(mission.id);
  if (rest == waiting_.end()) return;
  for (const team::GlobalTask& task : rest->second.tasks) {
    out.emplace_back(TeamTaskChanged{{task.task.id,
                                      skein::mission::to_text(task.task),
                                      auction::Stage::kUnsold,
                                      {},
                                      0,
                                      "waits at the ground station for an alarm"}});
  }
}

void TeamDesk::accept(const PlaceKnown& known, MissionTime now, Effects& out) {
  if (!alarms_.insert(known.name).second) return;
  std::vector<mission::MissionId> missions;
  for (const auto& [id, mission] : waiting_) missions.push_back(id);
  for (const mission::MissionId id : missions) give_what_may(id, now, out);
}

void TeamDesk::accept(const DegreeChanged& changed, MissionTime, Effects&) {
  degrees_.erase(changed.uav);
  if (!mission::allocates(changed.degree)) degrees_[changed.uav] = changed.degree;
}

/// Of an unsold task: what the reasons do not say of the UAV that it is pinned to. Empty: nothing,
/// or it is pinned to nobody.
std::string TeamDesk::why_pinned_does_not_bid(const team::TaskStanding& standing) const {
  const auto pinned = pinned_.find(standing.task);
  if (pinned == pinned_.end()) return "";
  const std::string& uav = pinned->second;
  const std::string which = uav + ", which it is pinned to, ";
  if (const auto degree = degrees_.find(uav); degree != degrees_.end())
    return which + "does not bid at degree " + std::to_string(degree->second);
  if (lost_.contains(uav)) return which + "is declared lost";
  const bool answered = ("; " + standing.why).find("; " + uav + ": ") != std::string::npos;
  return answered ? "" : which + "does not answer";
}

bool TeamDesk::is_pinned_in_hand(mission::GoalId task) const {
  const auto pinned = pinned_.find(task);
  return pinned != pinned_.end() && degrees_.contains(pinned->second);
}

std::string TeamDesk::why_unsold(const team::TaskStanding& standing) const {
  const std::string pinned = why_pinned_does_not_bid(standing);
  return pinned.empty() ? standing.why : standing.why + "; " + pinned;
}

std::set<mission::GoalId> TeamDesk::not_yet(const team::GlobalMission& mission) const {
  std::set<mission::GoalId> waits;
  const auto waits_too = [&](const team::GlobalTask& task) {
    const std::vector<std::string> alarms = team::alarms_in(task.task);
    return std::any_of(alarms.begin(), alarms.end(),
                       [&](const auto& alarm) { return !alarms_.contains(alarm); }) ||
           std::any_of(task.after.begin(), task.after.end(),
                       [&](mission::GoalId before) { return waits.contains(before); });
  };
  for (std::size_t before = waits.size() + 1; before != waits.size();) {
    before = waits.size();
    for (const team::GlobalTask& task : mission.tasks)
      if (waits_too(task)) waits.insert(task.task.id);
  }
  return waits;
}

// The market knows each part as a mission of its own; what comes after tasks of an earlier part
// waits for those.
void TeamDesk::give_what_may(mission::MissionId id, MissionTime now, Effects& out) {
  constexpr std::uint64_t kNextLot = std::uint64_t{1} << 32U;
  team::GlobalMission part = waiting_.at(id);
  const std::set<mission::GoalId> waits = not_yet(part);
  const auto is_waiting = [&](const auto& task) { return waits.contains(task.task.id); };
  std::erase_if(waiting_.at(id).tasks, [&](const auto& task) { return !is_waiting(task); });
  if (waiting_.at(id).tasks.empty()) waiting_.erase(id);
  std::erase_if(part.tasks, is_waiting);
  if (part.tasks.empty()) return;
  const auto& vocabulary = knowledge_.vocabulary;
  auction::GivenMission lot =
      team::given(part, roster_, vocabulary ? *vocabulary : mission::Vocabulary());
  lot.number = auction::MissionNumber(id.value() + kNextLot * lots_[id]++);
  tell_member(auction::MissionGiven{std::move(lot)}, now, out);
}

void TeamDesk::accept(const DeclareLost& lost, MissionTime now, Effects& out) {
  lost_.insert(lost.uav);
  declare<auction::DeclaredLost>(lost.uav, now, out);
}

void TeamDesk::accept(const DeclareFound& found, MissionTime now, Effects& out) {
  lost_.erase(found.uav);
  declare<auction::DeclaredFound>(found.uav, now, out);
}

template <class Declared>
void TeamDesk::declare(const std::string& uav, MissionTime now, Effects& out) {
  const auto member = roster_.number_of(uav);
  if (!member) {
    out.emplace_back(Anomaly{"'" + uav + "' is not in the team"});
    return;
  }
  tell_member(Declared{*member}, now, out);
}

void TeamDesk::tell_member(const auction::TeamInput& input, MissionTime now, Effects& out) {
  for (auction::TeamEffect& effect : member_.handle(input, now)) {
    std::visit(
        Overloaded{
            [&](auction::Tell& it) {
              out.emplace_back(TeamTell{roster_.name_of(it.to), std::move(it.message)});
            },
            [&](auction::SaleTold& it) { out.emplace_back(TeamSaleTold{std::move(it.what)}); },
            [&](const auction::TokenTaken& it) {
              out.emplace_back(TeamTokenChanged{true, it.term});
            },
            [&](const auction::TokenLost&) {
              out.emplace_back(TeamTokenChanged{false, 0});
            },
            [](const auto&) {}},  // the node's memory has what is to be stored
        effect);
  }
}

/// None: it has an owner in the book, or somebody could still end it by its deadline.
const auction::Task* TeamDesk::too_late(mission::GoalId task, MissionTime now) const {
  const auto& entries = member_.ledger().entries;
  const auto entry = entries.find(auction::TaskNumber(static_cast<std::uint32_t>(task.value())));
  if (entry == entries.end() || entry->second.stage != auction::Stage::kUnsold) return nullptr;
  return auction::is_too_late(entry->second.task, now) ? &entry->second.task : nullptr;
}

/// What is pinned to one whose degree is low is no end: the operator has both in hand.
void TeamDesk::count_refusals(team::TaskStanding& standing, MissionTime now) {
  if (too_late(standing.task, now) != nullptr) return;  // nobody was asked
  if (standing.stage == auction::Stage::kUnsold) {
    if (!is_pinned_in_hand(standing.task)) ++refused_[standing.task];
    standing.why = why_unsold(standing);
  } else if (standing.stage != auction::Stage::kForSale) {
    refused_.erase(standing.task);
  }
}

void TeamDesk::tell_news(MissionTime now, Effects& out) {
  for (team::TaskStanding& standing : ownership_.news(member_.ledger())) {
    count_refusals(standing, now);
    if (standing.stage == auction::Stage::kDone) {
      for (auto& [mission, open] : open_) {
        if (open.erase(standing.task) == 0 || !open.empty()) continue;
        out.emplace_back(GlobalMissionChanged{mission, GlobalStage::kDone, ""});
      }
    }
    out.emplace_back(TeamTaskChanged{std::move(standing)});
  }
  tell_hopeless(now, out);
}

/// Nobody could when it was called, nor when it was called again; or its time is over; or it comes
/// after such a one. Each is looked at once a round, however many ways lead to it.
std::set<mission::GoalId> TeamDesk::hopeless_of(const std::set<mission::GoalId>& open,
                                                MissionTime now) const {
  std::set<mission::GoalId> hopeless;
  const auto is_hopeless = [&](mission::GoalId task) {
    if (too_late(task, now) != nullptr) return true;
    const auto refused = refused_.find(task);
    if (refused != refused_.end() && refused->second >= kCalls) return true;
    const auto standing = standings().find(task);
    const bool may_begin =
        standing != standings().end() && standing->second.stage == auction::Stage::kGranted;
    const std::vector<mission::GoalId>& after = after_.at(task);
    return !may_begin && std::any_of(after.begin(), after.end(), [&](mission::GoalId before) {
      return hopeless.contains(before);
    });
  };
  for (bool more = true; std::exchange(more, false);)
    for (const mission::GoalId task : open)
      if (!hopeless.contains(task) && is_hopeless(task)) more = hopeless.insert(task).second;
  return hopeless;
}

/// The end of a mission of which nobody can do what is left. It may be sold all the same, once
/// somebody comes who can; then it has another end.
void TeamDesk::tell_hopeless(MissionTime now, Effects& out) {
  for (const auto& [id, open] : open_) {
    const bool over = !open.empty() && !waiting_.contains(id) && hopeless_of(open, now) == open;
    if (!over) {
      hopeless_.erase(id);
      continue;
    }
    if (!hopeless_.insert(id).second) continue;
    std::vector<std::string> whys;
    for (const mission::GoalId task : open) {
      const auto standing = standings().find(task);
      if (standing == standings().end()) continue;
      const auction::Task* late = too_late(task, now);
      if (late == nullptr && refused_.count(task) == 0) continue;
      whys.push_back(
          "task " + skein::to_text(task) + " (" + standing->second.statement +
          "): " + (late != nullptr ? auction::why_too_late(*late) : why_unsold(standing->second)));
    }
    out.emplace_back(GlobalMissionChanged{id, GlobalStage::kRefused,
                                          "nobody can do what is left: " + joined(whys, "; ")});
  }
}

}  // namespace skein::ground_station
