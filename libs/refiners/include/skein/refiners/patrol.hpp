// SPDX-License-Identifier: Apache-2.0
// patrol: cells visited again and again, the more often the more they are at risk.
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
/// vehicle stays in the zone, but for the way there and the turns of one that cannot hover (three
/// turn radii), and out of every no-fly volume at its altitude. A cell that is not perceived from
/// above the centre of any other, or that no way leads to, is hidden.
struct PatrolQuery {
  world::VehicleModel vehicle;
  world::Polygon zone;  ///< simple
  world::Vector3 start = world::Vector3::Zero();
  double heading = 0;    ///< at the start [rad]; only a vehicle that cannot hover minds
  double altitude = 0;   ///< over the ground [m], > 0
  double footprint = 0;  ///< σ: how far from below it a cell is perceived [m], > 0
  Duration duration;     ///< D, > 0
  Duration time_scale = Duration::seconds(600);  ///< τ of the potential
  double least_risk = 0.05;                      ///< r_min, (0, 1]: what is less counts as it
  double speed = 0;                              ///< [m/s]; 0: cruise
  PatrolMode mode = PatrolMode::kCommitted;
  MissionTime depart;  ///< volumes with a time window count from then on
};

/// Idleness of a cell: seconds since it was last perceived, or since the start. No patrol of the
/// same time has less than the lower bounds, which come from how many cells a second brings into
/// view. Source: docs/decisions/0008-refiners.md.
struct PatrolFigures {
  double worst_idleness = 0;             ///< [s] over the second half of the patrol
  double worst_idleness_bound = 0;       ///< [s]
  double worst_risk_idleness = 0;        ///< greatest risk × idleness [s]
  double worst_risk_idleness_bound = 0;  ///< [s]
  double mean_idleness = 0;              ///< weighted by risk [s]
  double mean_idleness_bound = 0;        ///< [s]
  std::size_t cells = 0;                 ///< that can be perceived
  std::size_t hidden = 0;                ///< that cannot be, ever: they attract nobody
  std::size_t unseen = 0;                ///< that could be, and were not, all along the patrol
};

struct Patrol {
  Way way;
  PatrolFigures predicted;
  std::vector<double>
      potential;      ///< P at the end, per cell of world.ground; NaN: not of the patrol
  double energy = 0;  ///< fraction of what is held when full
};

/// Refined cost: risk-weighted mean idleness [s]. Steps of the budget: visits to pieces of lanes
/// (to cells, by gradient), over all the patrols tried, and rounds judged on the way; a budget that
/// ends before the first patrol is planned gives the part that is: `duration` says how long. Still
/// air: the wind is in `duration` only. Cost: 0.1 s for each patrol tried of 10,000 visits among
/// 256 pieces, about ten of them.
Outcome<Patrol> refine(const PatrolQuery& query, const Setting& setting);

/// P = exp(-r ΔT / τ). Source: T IV.2.2, spec 4.2.
double potential(double risk, double idleness, double time_scale);
/// ΔT ← k (ΔT + dt), k = 1 - exp(-d² / σ²). Source: T IV.2.2 as corrected by spec 4.2.
double updated_idleness(double idleness, double dt, double distance, double sigma);

}  // namespace skein::refiners
