// SPDX-License-Identifier: Apache-2.0
// One leg between two stations, as arcs, lines and climbing circles.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "common/deadline.hpp"
#include "flyable/lengthened.hpp"
#include "skein/refiners/dubins.hpp"
#include "skein/refiners/flight.hpp"

namespace skein::refiners {

/// A place to fly over, and where to head there.
struct Station {
  Pose pose;
  double z = 0;  ///< [m]
};

/// Limits of a vehicle that bound its paths.
struct FlightLimits {
  double radius = 1;              ///< [m], > 0
  double climb = 0, descent = 0;  ///< greatest rise and fall per level distance, > 0
  double tolerance = 0.5;         ///< of chords [m], > 0
};

class FlyableLegs {
 public:
  using IsFree = std::function<bool(const world::Vector3&, const world::Vector3&)>;

  /// Calls `is_free` at most `most_asked` times in total, and not after the time is up; from then
  /// on every segment counts as blocked. `is_free` must outlive this object.
  FlyableLegs(const FlightLimits& limits, const IsFree& is_free, std::uint64_t most_asked,
              const Budget& budget = {})
      : limits_(limits), is_free_(is_free), left_(most_asked), deadline_(budget) {}

  /// Lower bound on the horizontal length of a leg between two stations [m].
  double least_length(const Station& from, const Station& to) const;
  /// About the shortest free leg, including both stations; nothing: none found. `thorough`: tries
  /// more places for climbing circles.
  std::optional<Way> leg(const Station& from, const Station& to, bool thorough);

  bool exhausted() const { return left_ == 0; }
  /// Reports the work of comparing stations; true once the budget is exhausted.
  bool exhausted_after(std::uint32_t comparisons) {
    constexpr std::uint32_t kCompared = 1500;  // [ns]
    if (deadline_.passed_after(comparisons * kCompared)) left_ = 0;
    return exhausted();
  }

 private:
  std::optional<Way> with_turns(const Station& from, const Station& to, bool thorough);
  std::optional<Way> lifted(const LevelWay& plane, double from, double to);
  bool all_free(const Way& way);
  double same_place() const { return 1e-6 * limits_.radius; }

  FlightLimits limits_;
  const IsFree& is_free_;
  std::uint64_t left_;
  Deadline deadline_;
};

/// Horizontal length of a path [m].
double level_length(const Way& way);

}  // namespace skein::refiners
