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

/// Where something was seen, and when.
struct Sighting {
  Position position{};
  MissionTime at;
  bool by_sensors = false;  ///< it is seen now and then, and counts for longer
};

/// What the observer knows of a name: an object, a point, a UAV. Absent: nothing.
using Observer = std::function<std::optional<Sighting>(const std::string& name)>;

/// What the places and numbers of an SCM stand for.
struct ScmBinding {
  /// A constraint on a place of several names (R*, a role that several hold) is one for each of
  /// them.
  std::map<std::string, std::vector<std::string>> places;
  std::map<std::string, double> numbers;
};

/// Noise and age of positions. Not negative.
struct ScmLimits {
  double distance = 1;                     ///< beyond its bound before a violation has ended [m]
  double angle = 0.02;                     ///< the same of angles [rad]
  Duration oldest = Duration::seconds(5);  ///< an older position counts as unknown
  Duration oldest_seen = Duration::seconds(30);  ///< the same of what sensors see
  /// What the place of an object that sensors follow may be off [m]: an angle at it is not violated
  /// by less than what that makes of it.
  double seen = 0;
};

/// One constraint as it was measured.
struct Measured {
  std::size_t constraint = 0;  ///< in the SCM
  std::string place;           ///< the first of its names
  Relation relation = Relation::kLess;
  double measured = 0, required = 0;  ///< [m] or [rad]
};

/// A change of what is found.
struct ScmFound {
  ScmReport report;
  std::optional<Measured> why;  ///< of a violation: the constraint that is missed by most
};

/// A violation begins when some constraint does not hold (an angle at what sensors follow: by more
/// than its place may be off), and ends when all hold by the margin of
/// the limits: positions that shake by less than half of it change the finding at most once. While
/// no constraint is known to be violated and some place is unknown, too old, or gives no direction,
/// it is undetermined. Before the first update it counts as satisfied. Each change is told once.
/// Cost of an update: O(constraints × names). Thread rule: one thread.
/// Source: T V.2.3, V.4.3, spec 7.5, 7.6.
class ScmMonitor {
 public:
  /// Every place and number of the SCM is bound.
  ScmMonitor(std::string id, Scm scm, ScmBinding binding, ScmLimits limits);

  /// From the UAV at `own`, with what the observer knows at `now`.
  std::optional<ScmFound> update(const Position& own, const Observer& observer, MissionTime now);
  ScmReport::Finding finding() const { return finding_; }

 private:
  /// What one update finds.
  struct Round {
    bool unknown = false;            ///< some place
    bool clear = true;               ///< all that is known holds by the margin
    std::optional<Measured> missed;  ///< by most
  };
  Round measure(const Position& own, const Observer& observer, MissionTime now) const;

  std::string id_;
  Scm scm_;
  ScmBinding binding_;
  ScmLimits limits_;
  ScmReport::Finding finding_ = ScmReport::Finding::kSatisfied;
};

/// Direction of a place in the celestial frame of two points [rad]: azimuth from 0 to 2π, 0 towards
/// `toward`, counter-clockwise; altitude from -π/2 to π/2. Absent where there is none: straight
/// above the origin, or a frame without direction.
std::optional<double> azimuth_in(const Position& origin, const Position& toward,
                                 const Position& place);
std::optional<double> altitude_in(const Position& origin, const Position& place);

}  // namespace skein::interaction
