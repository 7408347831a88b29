// SPDX-License-Identifier: Apache-2.0
// Watches one spatial constraint model over observed positions.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/interaction/input.hpp"
#include "skein/interaction/model.hpp"

namespace skein::interaction {

/// East, north, up [m] in the local frame.
using Position = std::array<double, 3>;

/// A known position of an object, point or UAV, and its time.
struct Sighting {
  Position position{};
  MissionTime at;
  bool by_sensors = false;  ///< from sensors, which are rare: its age limit is oldest_seen
};

/// The last sighting of a named object, point or UAV; absent: unknown.
using Observer = std::function<std::optional<Sighting>(const std::string& name)>;

/// The values of an SCM's places and numbers.
struct ScmBinding {
  /// Names by place. A constraint on a place with several names (R*, a role with several holders)
  /// must hold for each of them.
  std::map<std::string, std::vector<std::string>> places;
  std::map<std::string, double> numbers;
};

/// Tolerances for noise and age of positions. Not negative.
struct ScmLimits {
  double distance = 1;                     ///< margin by which a violation must end, distances [m]
  double angle = 0.02;                     ///< the same for angles [rad]
  Duration oldest = Duration::seconds(5);  ///< an older position counts as unknown
  Duration oldest_seen = Duration::seconds(30);  ///< the same for positions from sensors
  /// Position error of objects tracked by sensors [m]: an angle at such an object is violated only
  /// by more than the angle that this error causes.
  double seen = 0;
};

/// A constraint with its measured value.
struct Measured {
  std::size_t constraint = 0;  ///< in the SCM
  std::string place;           ///< the first of its names
  Relation relation = Relation::kLess;
  double measured = 0, required = 0;  ///< [m] or [rad]
};

/// A change of the finding.
struct ScmFound {
  ScmReport report;
  std::optional<Measured> why;  ///< of a violation: the constraint with the greatest violation
};

/// A violation begins when some constraint does not hold (for an angle at an object tracked by
/// sensors: by more than ScmLimits::seen causes), and ends when all hold by the margins of the
/// limits: position noise of less than half a margin changes the finding at most once. The finding
/// is "undetermined" while no constraint is known to be violated and some place is unknown, too
/// old, or gives no direction. Before the first update it is "satisfied". Each change is reported
/// once. Cost of an update: O(constraints × names). Thread rule: one thread. Source: T V.2.3,
/// V.4.3, spec 7.5, 7.6.
class ScmMonitor {
 public:
  /// Precondition: every place and number of the SCM is bound.
  ScmMonitor(std::string id, Scm scm, ScmBinding binding, ScmLimits limits);

  /// Evaluates the SCM for the UAV at `own` with the observer's positions at `now`; returns the
  /// finding if it changed.
  std::optional<ScmFound> update(const Position& own, const Observer& observer, MissionTime now);
  ScmReport::Finding finding() const { return finding_; }

 private:
  /// What one update finds.
  struct Round {
    bool unknown = false;            ///< some place is unknown
    bool clear = true;               ///< all constraints with known places hold by the margin
    std::optional<Measured> missed;  ///< the constraint with the greatest violation
  };
  Round measure(const Position& own, const Observer& observer, MissionTime now) const;

  std::string id_;
  Scm scm_;
  ScmBinding binding_;
  ScmLimits limits_;
  ScmReport::Finding finding_ = ScmReport::Finding::kSatisfied;
};

/// Direction of a place in the celestial frame of two points [rad]: azimuth from 0 to 2π, 0 towards
/// `toward`, counter-clockwise; altitude from -π/2 to π/2. Absent where undefined: straight above
/// the origin, or in a frame without direction.
std::optional<double> azimuth_in(const Position& origin, const Position& toward,
                                 const Position& place);
std::optional<double> altitude_in(const Position& origin, const Position& place);

}  // namespace skein::interaction
