// SPDX-License-Identifier: Apache-2.0
// Preparation of a patrol query: checks, closed volumes, reachable cells.
#pragma once

#include <memory>
#include <optional>

#include "common/over_ground.hpp"
#include "patrol/links.hpp"
#include "skein/refiners/patrol.hpp"

namespace skein::refiners {

/// Most cells that the ground may have, and most cell lengths that a patrol may fly, so that a
/// wrong figure cannot exhaust memory.
inline constexpr std::size_t kMostGroundCells = 4'000'000;
inline constexpr double kMostCellsFlown = 2e6;

/// Refuses invalid figures, and those that exceed the vehicle.
std::optional<Refusal> check_patrol(const PatrolQuery& query, const world::World& world);

double patrol_speed(const PatrolQuery& query);
HeightRule height_rule(const PatrolQuery& query);

/// The outlines of closed volumes: those whose height band the vehicle may enter anywhere over
/// them, at any time of the patrol.
std::vector<world::Polygon> closed_volumes(const PatrolQuery& query, const world::World& world,
                                           Deadline& deadline);

/// The parts of a patrol, in the order they depend on each other.
struct PatrolGround {
  PatrolSpace space;
  PatrolSight sight;
  PatrolField field;
  std::vector<PatrolBlock> blocks;
  std::unique_ptr<PatrolLinks> links;
};

/// Leaves out what cannot be reached from the start. Refused if nothing is left, or the time is up.
/// The deadline must outlive the result.
Result<std::unique_ptr<PatrolGround>, Refusal> make_patrol_ground(const PatrolQuery& query,
                                                                  const world::World& world,
                                                                  Deadline& deadline);

}  // namespace skein::refiners
