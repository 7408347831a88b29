// SPDX-License-Identifier: Apache-2.0
// Builders and pickers shared by the tests.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "skein/ground_orders/messages.hpp"
#include "skein/ground_orders/script.hpp"
#include "skein/world/terrain.hpp"

namespace skein::ground_station::testing {

inline MissionTime at(double seconds) { return MissionTime::seconds(seconds); }

inline executive::TaskId id(std::uint64_t value) { return executive::TaskId(value); }

/// Level ground at 0, 2 km × 2 km.
inline const world::Terrain& flat_terrain() {
  static const world::Terrain terrain(world::TerrainSpec{.west = -1000,
                                                         .south = -1000,
                                                         .east = 1000,
                                                         .north = 1000,
                                                         .cell = 100,
                                                         .base = 0,
                                                         .hills = {},
                                                         .elevations = {}});
  return terrain;
}

inline executive::Task a_task(std::uint64_t task, const std::string& type = "goto") {
  executive::Task out;
  out.id = id(task);
  out.type = type;
  return out;
}

inline Request start_of(std::uint64_t task, const std::string& type = "goto") {
  return executive::Start{a_task(task, type), executive::InsertionMode::kSeq};
}

inline Request abort_of(std::uint64_t task) { return executive::Abort{id(task)}; }

/// A literal on a task's state, mandatory unless said otherwise, as a clause of its own.
inline executive::Clause in_state(std::uint64_t task, executive::TaskState state,
                                  executive::Modality modality = executive::Modality::kMandatory) {
  return {executive::Literal{executive::TaskInState{id(task), state}, false, modality}};
}

inline Step a_step(const std::string& name, Trigger when, std::vector<Action> actions = {}) {
  return Step{name, "", std::move(when), Duration(), std::move(actions), true};
}

/// The effects of one kind, in order.
template <class What, class Effect>
std::vector<What> only(const std::vector<Effect>& effects) {
  std::vector<What> out;
  for (const Effect& effect : effects) {
    if (const auto* what = std::get_if<What>(&effect)) out.push_back(*what);
  }
  return out;
}

/// The first effect of one kind; a default one when there is none.
template <class What, class Effect>
What first(const std::vector<Effect>& effects) {
  const std::vector<What> all = only<What>(effects);
  return all.empty() ? What() : all.front();
}

}  // namespace skein::ground_station::testing
