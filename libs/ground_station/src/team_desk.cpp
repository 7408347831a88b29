// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/team_desk.hpp"

#include "skein/foundation/joined.hpp"
#include "skein/foundation/overloaded.hpp"

namespace skein::ground_station {

std::string_view to_text(GlobalStage stage) {
  switch (stage) {
    case GlobalStage::kRefused:
      return "refused";
    case GlobalStage::kGiven:
      return "given";
    case GlobalStage::kDone:
      break;
  }
  return "done";
}

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
  tell_news(out);
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
    tasks_.insert(task.task.id);
  }
  const auto& vocabulary = knowledge_.vocabulary;
  tell_member(auction::MissionGiven{team::given(mission, roster_,
                                                vocabulary ? *vocabulary : mission::Vocabulary())},
              now, out);
}

void TeamDesk::accept(const DeclareLost& lost, MissionTime now, Effects& out) {
  const auto member = roster_.number_of(lost.uav);
  if (!member) {
    out.emplace_back(Anomaly{"'" + lost.uav + "' is not in the team"});
    return;
  }
  tell_member(auction::DeclaredLost{*member}, now, out);
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

void TeamDesk::tell_news(Effects& out) {
  for (team::TaskStanding& standing : ownership_.news(member_.ledger())) {
    if (standing.stage == auction::Stage::kDone) {
      for (auto& [mission, open] : open_) {
        if (open.erase(standing.task) == 0 || !open.empty()) continue;
        out.emplace_back(GlobalMissionChanged{mission, GlobalStage::kDone, ""});
      }
    }
    out.emplace_back(TeamTaskChanged{std::move(standing)});
  }
}

}  // namespace skein::ground_station
