// SPDX-License-Identifier: Apache-2.0
// Radio propagation between nodes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/world/grid.hpp"
#include "skein/world/terrain.hpp"

namespace skein::world {

/// The state of the radio between two places, in one direction.
struct RadioLink {
  bool up = false;
  Duration latency;     ///< one way; zero when down
  double loss = 0;      ///< fraction of samples that never arrive, [0, 1]; 1 when down
  double capacity = 0;  ///< [bit/s]; 0: unlimited, or down
  bool operator==(const RadioLink&) const = default;
};

/// Emission against reception, by the log-distance law: at d metres
///   received = emission_power - reference_loss - 10 path_loss_exponent log10(d).
/// Source: spec 4.1 (radio).
struct LinkBudget {
  double emission_power = 0;      ///< antenna gains included [dBm]
  double sensitivity = 0;         ///< the least that can be received [dBm]
  double reference_loss = 40;     ///< at 1 m [dB]; free space at 2.4 GHz: 40
  double path_loss_exponent = 2;  ///< 2 in free space, up to 4 near the ground; > 0
  bool operator==(const LinkBudget&) const = default;

  /// Distance at which the received power equals the sensitivity [m].
  double range() const;
};

/// One radio for all nodes of a scenario. Source: spec 1.3 (channels), 4.1 (radio), 8.1.
struct RadioModel {
  double range = 0;                 ///< [m], > 0; ignored if there is a budget
  bool needs_line_of_sight = true;  ///< terrain between two nodes cuts them
  Duration latency;
  double loss = 0;  ///< [0, 1)
  /// A link that is up holds until this much beyond the range, as a fraction of it, so that a
  /// vehicle on the limit does not cut and restore it at every step.
  double hysteresis = 0.05;
  /// When present, the range follows from it.
  std::optional<LinkBudget> budget = std::nullopt;
  double capacity = 0;  ///< of each link, in each direction [bit/s]; 0: unlimited
  bool operator==(const RadioModel&) const = default;

  /// Range in line of sight [m]: `range`, or that of the budget.
  double reach() const;

  /// Symmetrical in a and b [m, ENU]. `was_up`: what it was when last asked.
  RadioLink link(const Vector3& a, const Vector3& b, const Terrain& terrain, bool was_up) const;

  /// Link margin at this distance [m], the received power above the sensitivity [dB]; without
  /// terrain.
  /// 10 n log10(reach / distance) with n the exponent of the budget, 2 without one. Not below 0 up
  /// to the reach and only there; less than a metre counts as a metre (as the reach, if shorter).
  double margin(double distance) const;
  /// The same between two places; -∞ when the ground cuts them and they need sight. Symmetrical.
  /// Not below 0 exactly when a link that was down comes up.
  double margin(const Vector3& a, const Vector3& b, const Terrain& terrain) const;

  /// Margins [dB] from a point to a receiver `height` [m] over the ground at the centre of each
  /// cell, in the order of Grid::index. Cost: a line of sight for each cell within reach; the rest
  /// have the margin of their distance.
  std::vector<double> coverage(const Vector3& point, const Grid& grid, const Terrain& terrain,
                               double height) const;
};

/// What is wrong with a radio model, in sentences, all at once; empty when it can be used.
std::vector<std::string> problems_of(const RadioModel& radio);

}  // namespace skein::world
