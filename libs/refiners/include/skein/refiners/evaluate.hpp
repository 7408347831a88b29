// SPDX-License-Identifier: Apache-2.0
// evaluate: what a given way takes; what one more task in a plan takes.
#pragma once

#include <optional>
#include <vector>

#include "skein/refiners/path.hpp"

namespace skein::refiners {

struct EvaluateQuery {
  world::VehicleModel vehicle;
  Way way;               ///< at least two points
  double clearance = 0;  ///< [m]
  double speed = 0;      ///< [m/s]; 0: cruise
  MissionTime depart;
  std::vector<world::Volume> reserved;
};

/// What stands in the way of a way, at the first place it does.
struct Obstruction {
  std::size_t leg = 0;  ///< from way[leg] to way[leg + 1]
  world::Vector3 at = world::Vector3::Zero();
  std::string by;  ///< "ground", or the name of a volume
};

struct Evaluation {
  double length = 0;                      ///< [m]
  double energy = 0;                      ///< fraction of what is held when full
  double climb = 0;                       ///< sum of what it climbs [m]
  double least_height = 0;                ///< over the ground, anywhere along it [m]
  std::vector<Obstruction> obstructions;  ///< one per leg and obstacle
  std::vector<std::string> limits;        ///< of the vehicle that it breaks, in sentences
};

/// Refined cost: expected seconds. A way that is closed is evaluated all the same: see
/// `obstructions`.
Outcome<Evaluation> refine(const EvaluateQuery& query, const Setting& setting);

/// A task of a plan, for what it does to the places: it begins at one and ends at another.
struct PlannedTask {
  world::Vector3 from = world::Vector3::Zero(), to = world::Vector3::Zero();
  Duration duration;
};

struct InsertionQuery {
  world::VehicleModel vehicle;
  world::Vector3 start = world::Vector3::Zero();
  std::vector<PlannedTask> plan;      ///< in order; may be empty
  PlannedTask task;                   ///< to be inserted
  std::optional<world::Vector3> end;  ///< where the plan must end
  double clearance = 0;               ///< of the ways in between [m]
  double speed = 0;                   ///< [m/s]; 0: cruise
  MissionTime depart;
};

struct Insertion {
  std::size_t position = 0;   ///< before plan[position]; plan.size(): at the end
  std::vector<double> added;  ///< seconds that it adds at each position; infinite: no way there, or
                              ///< none found before the time was up (Effort::cut_short)
  Way to, from;               ///< ways to the task and on from it, at the best position
};

/// Refined cost: seconds added at the best position. When the time is up before all positions were
/// tried, the best of those that were; kBudgetExhausted when none was. Steps: positions. Cost: the
/// airspace is built once; then at most three ways for each position.
Outcome<Insertion> refine(const InsertionQuery& query, const Setting& setting);

}  // namespace skein::refiners
