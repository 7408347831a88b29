// SPDX-License-Identifier: Apache-2.0
// evaluate: cost and validity of a given path; cost of inserting a task into a plan.
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

/// An obstacle on a leg of the path, at the first point of contact.
struct Obstruction {
  std::size_t leg = 0;  ///< from way[leg] to way[leg + 1]
  world::Vector3 at = world::Vector3::Zero();
  std::string by;  ///< "ground", or the name of a volume
};

struct Evaluation {
  double length = 0;                      ///< [m]
  double energy = 0;                      ///< fraction of the full capacity
  double climb = 0;                       ///< total height gained [m]
  double least_height = 0;                ///< least height over the ground along the path [m]
  std::vector<Obstruction> obstructions;  ///< one per leg and obstacle
  std::vector<std::string> limits;        ///< violated limits of the vehicle, in sentences
};

/// Refined cost: expected seconds. An obstructed path is evaluated too: see `obstructions`.
Outcome<Evaluation> refine(const EvaluateQuery& query, const Setting& setting);

/// A task of a plan, reduced to its places and duration: it begins at one place and ends at
/// another.
struct PlannedTask {
  world::Vector3 from = world::Vector3::Zero(), to = world::Vector3::Zero();
  Duration duration;
};

struct InsertionQuery {
  world::VehicleModel vehicle;
  world::Vector3 start = world::Vector3::Zero();
  std::vector<PlannedTask> plan;      ///< in order; may be empty
  PlannedTask task;                   ///< to be inserted
  std::optional<world::Vector3> end;  ///< required end of the plan
  double clearance = 0;               ///< of the paths between tasks [m]
  double speed = 0;                   ///< [m/s]; 0: cruise
  MissionTime depart;
};

struct Insertion {
  std::size_t position = 0;   ///< before plan[position]; plan.size(): at the end
  std::vector<double> added;  ///< seconds added by the task at each position; infinite: no path, or
                              ///< none found before the time was up (Effort::cut_short)
  Way to, from;               ///< paths to the task and from it, at the best position
};

/// Refined cost: seconds added at the best position. If the time is up before all positions were
/// tried, the best of those tried; kBudgetExhausted if there is none. Steps: positions. Cost: the
/// airspace is built once; then at most three paths for each position.
Outcome<Insertion> refine(const InsertionQuery& query, const Setting& setting);

}  // namespace skein::refiners
