// SPDX-License-Identifier: Apache-2.0
// patrol: repeated visits to the cells of a zone, more often to cells of higher risk.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "skein/refiners/flight.hpp"
#include "skein/refiners/refinement.hpp"
#include "skein/refiners/setting.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::refiners {

enum class PatrolMode : std::uint8_t {
  kCommitted,  ///< commits to targets ranked by risk × idleness against distance, sweeps on the way
  kGradient,   ///< the seeds': steepest local gradient of the potential; leaves cells unvisited
};

/// Cells are those of world.ground whose centre is in the zone. A cell is perceived while the
/// vehicle is at most `footprint` from above its centre and the ground does not hide it. The
/// vehicle stays in the zone, except on the path to it and in the turns of a vehicle that cannot
/// hover (up to three turn radii outside), and out of every no-fly volume at its altitude. A cell
/// is hidden if it cannot be perceived from above the centre of any cell, or cannot be reached.
struct PatrolQuery {
  world::VehicleModel vehicle;
  world::Polygon zone;  ///< simple
  world::Vector3 start = world::Vector3::Zero();
  double heading = 0;    ///< at the start [rad]; binds only a vehicle that cannot hover
  double altitude = 0;   ///< over the ground [m], > 0
  double footprint = 0;  ///< σ: horizontal radius within which cells are perceived [m], > 0
  Duration duration;     ///< D, > 0
  Duration time_scale = Duration::seconds(600);  ///< τ of the potential
  double least_risk = 0.05;                      ///< r_min, (0, 1]: lower bound applied to risks
  double speed = 0;                              ///< [m/s]; 0: cruise
  PatrolMode mode = PatrolMode::kCommitted;
  MissionTime depart;  ///< volumes with a time window count from then on
};

/// Idleness of a cell: time since its last perception, or since the start [s]. The lower bounds
/// hold for every patrol of the same duration; they follow from the number of cells that come into
/// view per second. Source: docs/decisions/0008-refiners.md.
struct PatrolFigures {
  double worst_idleness = 0;             ///< [s] over the second half of the patrol
  double worst_idleness_bound = 0;       ///< [s]
  double worst_risk_idleness = 0;        ///< greatest risk × idleness [s]
  double worst_risk_idleness_bound = 0;  ///< [s]
  double mean_idleness = 0;              ///< weighted by risk [s]
  double mean_idleness_bound = 0;        ///< [s]
  std::size_t cells = 0;                 ///< number of perceivable cells
  std::size_t hidden = 0;                ///< number of hidden cells, which are left out
  std::size_t unseen = 0;                ///< number of perceivable cells that were never perceived
};

struct Patrol {
  Way way;
  PatrolFigures predicted;
  std::vector<double>
      potential;      ///< P at the end, per cell of world.ground; NaN: not a cell of the patrol
  double energy = 0;  ///< fraction of the full capacity
};

/// Refined cost: risk-weighted mean idleness [s]. Steps of the budget: visits to pieces of lanes
/// (in gradient mode: to cells) over all patrols tried, and rounds evaluated; if the budget ends
/// before the first patrol is complete, its planned part is returned, with its `duration`. Figures
/// assume still air; only `duration` includes the wind. Cost: 0.1 s for each patrol tried of 10,000
/// visits among 256 pieces; about ten patrols are tried.
Outcome<Patrol> refine(const PatrolQuery& query, const Setting& setting);

/// P = exp(-r ΔT / τ). Source: T IV.2.2, spec 4.2.
double potential(double risk, double idleness, double time_scale);
/// ΔT ← k (ΔT + dt), k = 1 - exp(-d² / σ²). Source: T IV.2.2 as corrected by spec 4.2.
double updated_idleness(double idleness, double dt, double distance, double sigma);

}  // namespace skein::refiners
