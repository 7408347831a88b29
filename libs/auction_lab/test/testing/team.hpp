// SPDX-License-Identifier: Apache-2.0
// Teams in the plane and their sales, for tests.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "skein/auction_lab/flat_craft.hpp"
#include "skein/auction_lab/sale_simulation.hpp"

namespace skein::auction::testing {

inline TaskNumber task_number(std::size_t n) { return TaskNumber(static_cast<std::uint32_t>(n)); }
inline MemberNumber member_number(std::size_t n) {
  return MemberNumber(static_cast<std::uint32_t>(n));
}

/// Vehicles and a lot, and what comes of selling it.
struct Team {
  std::vector<FlatVehicle> vehicles;
  Lot lot;
  Aim aim;
  SaleLimits limits;
  SaleTransport transport;
  std::uint64_t seed = 1;
  std::vector<Holding> holdings{};  ///< empty: nobody has anything
  Presence present{};

  Team& add_task(Place at, double duration = 0) {
    Task task;
    task.number = task_number(lot.tasks.size());
    task.at = at;
    task.duration = duration;
    lot.tasks.push_back(task);
    return *this;
  }
  Task& last() { return lot.tasks.back(); }

  SaleOutcome sell() const {
    SaleSetup setup{SaleNumber(1), std::make_shared<const Catalogue>(lot), holdings, aim, limits,
                    seed};
    std::vector<FlatCraft> crafts;
    for (std::size_t i = 0; i < vehicles.size(); ++i) {
      if (holdings.empty()) setup.holdings.push_back({member_number(i), {}, 0});
      crafts.emplace_back(vehicles[i], setup.lot);
    }
    std::vector<const Craft*> all;
    for (const FlatCraft& craft : crafts) all.push_back(&craft);
    return play_sale(std::move(setup), all, transport, present);
  }
};

/// All tasks that are told as `Kind`.
template <class Kind>
std::vector<Kind> told(const SaleOutcome& outcome) {
  std::vector<Kind> found;
  for (const SaleEffect& effect : outcome.told) {
    if (const auto* one = std::get_if<Kind>(&effect)) found.push_back(*one);
  }
  return found;
}

inline std::vector<MemberNumber> members_of(const SaleOutcome& outcome, TaskNumber task) {
  std::vector<MemberNumber> members;
  for (const auto& route : outcome.routes) {
    if (std::find(route.tasks.begin(), route.tasks.end(), task) != route.tasks.end()) {
      members.push_back(route.member);
    }
  }
  return members;
}

inline double start_of(const SaleOutcome& outcome, TaskNumber task) {
  for (const auto& route : outcome.routes) {
    for (std::size_t i = 0; i < route.tasks.size(); ++i) {
      if (route.tasks[i] == task) return route.starts[i];
    }
  }
  return -1;
}

/// Random vehicles and tasks in a square of 100 m.
inline Team random_team(std::size_t vehicles, std::size_t tasks, std::uint64_t seed) {
  Random random(seed, "team");
  const auto place = [&] { return Place{random.uniform(0, 100), random.uniform(0, 100)}; };
  Team team;
  for (std::size_t i = 0; i < vehicles; ++i) team.vehicles.push_back({place()});
  for (std::size_t i = 0; i < tasks; ++i) team.add_task(place());
  team.seed = seed;
  return team;
}

}  // namespace skein::auction::testing
