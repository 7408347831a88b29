// SPDX-License-Identifier: Apache-2.0
#include "skein/temporal/team_supervisor.hpp"

namespace skein::temporal {

TeamSupervisor::TeamSupervisor(std::vector<std::string> agents) {
  for (std::string& agent : agents) agents_.emplace(agent, TeamDates(agent));
}

std::vector<TeamSupervisor::Word> TeamSupervisor::hear(const std::string& agent,
                                                       const Frontier& whole) {
  if (!agents_.contains(agent)) return {};
  const Frontier left = eliminated(whole);
  for (auto& [name, dates] : agents_) dates.hear(agent, left);
  return news();
}

std::vector<TeamSupervisor::Word> TeamSupervisor::out_of_reach(const std::string& agent,
                                                               std::optional<MissionTime> since) {
  if (!agents_.contains(agent)) return {};
  for (auto& [name, dates] : agents_) dates.out_of_reach(agent, since);
  return news();
}

// What dates rest on is for those who do not know the whole.
std::vector<TeamSupervisor::Word> TeamSupervisor::news() {
  std::vector<Word> words;
  for (const auto& [about, dates] : agents_) {
    for (const auto& [to, other] : agents_) {
      if (to == about) continue;
      Frontier word = dates.bounds_for(to);
      word.bases.clear();
      Frontier& told = told_[{to, about}];
      if (word == told) continue;
      told = word;
      words.push_back({to, about, std::move(word)});
    }
  }
  return words;
}

}  // namespace skein::temporal
