// SPDX-License-Identifier: Apache-2.0
// Figures of joint tasks in flight, by the simulator's word: an area mapped by three UAVs however
// it is divided, and how soon a role goes elsewhere when a constraint is violated. Tables, in
// virtual time: the same on every machine. Arguments: how many seeds (50), and which
// of them: names of area-sharing, mref, or areas or central-areas alone, from a seed on (1): others
// than the scenario's (all but those); divisions: how those would be divided.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <optional>
#include <vector>

#include "testing/drawn_area.hpp"
#include "testing/mapping_ends.hpp"
#include "testing/mission.hpp"

namespace skein::testing {
namespace {

double part(std::vector<double> all, double share) {
  std::sort(all.begin(), all.end());
  return all.empty() ? 0
                     : all[static_cast<std::size_t>(share * static_cast<double>(all.size() - 1))];
}

struct Shared {
  const char* scenario;
  std::vector<std::string> together;  ///< whose ends are compared; empty: all
};

void area_sharing(std::uint64_t seeds, const std::vector<std::string>& only) {
  std::puts(
      "| area-sharing/… | seconds from the first setting out to the last end: median (most) "
      "| spread of ends: median (most) | broken expectations, laws |");
  std::puts("|---|---|---|---|");
  for (const Shared& one : {Shared{"alone", {}}, Shared{"proportional", {}}, Shared{"central", {}},
                            Shared{"negotiated", {}}, Shared{"one-leaves", {"heron", "wren"}},
                            Shared{"one-lost", {"heron", "swift"}}}) {
    if (!only.empty() && std::find(only.begin(), only.end(), one.scenario) == only.end()) continue;
    std::vector<double> makespans, spreads;
    std::size_t broken = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      const Mission mission =
          play(scenario_at(std::string("area-sharing/") + one.scenario, with(seed)));
      const MappingEnds ends = mapping_ends(mission.records);
      makespans.push_back(ends.makespan());
      spreads.push_back(100 * ends.spread(one.together));
      broken += mission.failures().empty() && mission.untrue.empty() ? 0 : 1;
    }
    std::printf("| %s | %.0f (%.0f) | %.1f %% (%.1f %%) | %zu of %zu |\n", one.scenario,
                part(makespans, 0.5), part(makespans, 1), part(spreads, 0.5), part(spreads, 1),
                broken, static_cast<std::size_t>(seeds));
  }
}

/// Over areas of all kinds, from this seed on: by negotiation, or divided on the ground.
void other_areas(std::uint64_t seeds, std::uint64_t first,
                 scenario::Scenario (&area)(std::uint64_t)) {
  std::vector<double> spreads;
  double sum = 0;
  std::size_t broken = 0, together = 0;
  for (std::uint64_t seed = first; seed < first + seeds; ++seed) {
    const Mission mission = play(area(seed));
    const MappingEnds ends = mapping_ends(mission.records);
    spreads.push_back(100 * ends.spread());
    std::printf("area %zu: %.1f %%", static_cast<std::size_t>(seed), spreads.back());
    for (const auto& [uav, end] : ends.ends)
      std::printf(", %s %.0f s", uav.c_str(), end - ends.begin);
    std::puts("");
    sum += spreads.back();
    together += spreads.back() <= 5 ? 1 : 0;
    const std::string wrong = mission.failures() + mission.untrue;
    broken += wrong.empty() ? 0 : 1;
    if (!wrong.empty())
      std::printf("area %zu: %s\n", static_cast<std::size_t>(seed), wrong.c_str());
  }
  std::puts("| areas | spread of ends: mean, median (most) | within 5 % | broken |");
  std::puts("|---|---|---|---|");
  std::printf("| %zu | %.1f %%, %.1f %% (%.1f %%) | %zu | %zu |\n", spreads.size(),
              sum / static_cast<double>(seeds), part(spreads, 0.5), part(spreads, 1), together,
              broken);
}

double latest_end(const refiners::Partition& partition) {
  double latest = 0;
  for (const refiners::Part& part : partition.parts)
    latest = std::max(latest, part.duration.expected.to_seconds());
  return latest;
}

/// As they are divided, by what is flown in thought: nothing is flown.
void divisions(std::uint64_t seeds, std::uint64_t first) {
  std::puts("| parts | spread: median, 90 % (most) | last end, mean | processor time each |");
  std::puts("|---|---|---|---|");
  for (const auto sweeping : {supervisor::Sweeping::kShared, supervisor::Sweeping::kOwn}) {
    std::vector<double> spreads;
    double ends = 0;
    const std::clock_t began = std::clock();
    for (std::uint64_t seed = first; seed < first + seeds; ++seed) {
      const auto partition = divided(drawn_area(seed), refiners::ShareMode::kBalanced, sweeping);
      spreads.push_back(100 * partition.spread);
      ends += latest_end(partition);
    }
    const double seconds = static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
    std::printf("| %s | %.1f %%, %.1f %% (%.1f %%) | %.0f s | %.2f s |\n",
                sweeping == supervisor::Sweeping::kShared ? "shared in flight" : "on the ground",
                part(spreads, 0.5), part(spreads, 0.9), part(spreads, 1),
                ends / static_cast<double>(seeds), seconds / static_cast<double>(seeds));
  }
}

/// Of each violation after which its UAV was given a goto by its role: seconds until then.
void add_reactions(const Mission& mission, std::vector<double>& reactions) {
  for (const journal::Record& violated : mission.find({{"kind", "scm"}, {"state", "violated"}})) {
    for (const journal::Record& given :
         mission.find({{"kind", "role-task"},
                       {"type", "goto"},
                       {"uav", std::string(violated.text("uav"))}})) {
      const double after = (given.at() - violated.at()).to_seconds();
      if (after < 0) continue;
      if (after < 60) reactions.push_back(after);
      break;
    }
  }
}

void reaction(std::uint64_t seeds) {
  std::puts(
      "| mref/… | violations that were reacted to | seconds to the new position commanded: "
      "median (95 %) | most |");
  std::puts("|---|---|---|---|");
  for (const char* scenario : {"larger-move", "very-large-move"}) {
    std::vector<double> reactions;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      add_reactions(play(scenario_at(std::string("mref/") + scenario, with(seed))), reactions);
    }
    std::printf("| %s | %zu | %.2f (%.2f) | %.2f |\n", scenario, reactions.size(),
                part(reactions, 0.5), part(reactions, 0.95), part(reactions, 1));
  }
}

}  // namespace
}  // namespace skein::testing

int main(int argc, char** argv) {
  const std::uint64_t seeds = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 50;
  const std::vector<std::string> only(argv + std::min(argc, 2), argv + argc);
  if (!only.empty() && only.front() == "divisions") {
    skein::testing::divisions(seeds,
                              only.size() > 1 ? std::strtoull(only[1].c_str(), nullptr, 10) : 1);
    return 0;
  }
  if (!only.empty() && (only.front() == "areas" || only.front() == "central-areas")) {
    const std::uint64_t first = only.size() > 1 ? std::strtoull(only[1].c_str(), nullptr, 10) : 1;
    skein::testing::other_areas(
        seeds, first,
        only.front() == "areas" ? skein::testing::drawn_area : skein::testing::drawn_central_area);
    return 0;
  }
  skein::testing::area_sharing(seeds, only);
  const bool reacts = std::find(only.begin(), only.end(), "mref") != only.end();
  if (only.empty() || reacts) skein::testing::reaction(seeds);
  return 0;
}
