// SPDX-License-Identifier: Apache-2.0
// Expectations of a scenario, checked on the event log of a run.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/journal/record.hpp"
#include "skein/world/volume.hpp"

namespace skein::scenario {

/// Matches a record when, for every key, the record's field equals one of the values. `node` and
/// `kind` are keys like the others; whole and fractional numbers compare by value.
struct Pattern {
  std::vector<std::pair<std::string, std::vector<journal::Value>>> fields;
  bool matches(const journal::Record& record) const;
  bool operator==(const Pattern&) const = default;
};

/// "{kind: task, uav: marvin, state: ended}": as a user would write it.
std::string to_text(const Pattern& pattern);

/// The time window in which matches count: [from, until], and, if `after` is given, from the first
/// record that matches `after` until `within` later. Without such a record no match counts.
struct Window {
  MissionTime from;
  MissionTime until = MissionTime::max();
  std::optional<Pattern> after;
  std::optional<Duration> within;
  /// If given, matches count only strictly before the first record that matches `before`; without
  /// such a record at any time.
  std::optional<Pattern> before;
};

/// At least `at_least` and at most `at_most` matching records in the window.
struct ExpectEvent {
  Pattern event;
  Window window;
  std::size_t at_least = 1;
  std::optional<std::size_t> at_most;
};

/// The last record that matches `of` also matches `is`.
struct ExpectFinally {
  Pattern of;
  Pattern is;
};

/// A volume that is closed from the first record that matches `closed_by` on (absent: from the
/// start) until the first one after it that matches `opened_by`, during the volume's own time.
struct ClosedAir {
  world::Volume volume;
  std::optional<Pattern> closed_by;
  std::optional<Pattern> opened_by;
};

/// A figure of the whole run within bounds.
struct ExpectMeasure {
  enum class Quantity {
    kMinimumSeparation,  ///< [m] between any two of the UAVs while both are airborne, from
                         ///< telemetry
    kDistanceFlown,      ///< [m] by all of the UAVs together
    kMissionDuration,    ///< [s] until the mission finished
    kEnergyLeft,         ///< [0, 1], the least of the UAVs' at the end
    kTimeInVolume        ///< [s] that the UAVs together flew in closed air, from telemetry
  };
  Quantity quantity = Quantity::kMinimumSeparation;
  std::vector<std::string> uavs;
  std::optional<double> at_least;
  std::optional<double> at_most;
  std::vector<ClosedAir> air = {};  ///< of kTimeInVolume: all that is closed in the scenario
};

/// One named expectation. "never" is an event expected at most zero times. Source: spec 8.1.
struct Expectation {
  std::string name;
  std::variant<ExpectEvent, ExpectFinally, ExpectMeasure> what;
};

struct Verdict {
  std::string name;
  bool passed = false;
  std::string seen;  ///< for people: the matching record or figure, or what was found instead
};

/// One verdict per expectation, in order. `records` are in the order of the log, times never
/// decreasing. An expected event may come up to `allowed_late` (>= 0) after the end of its window,
/// and the verdict then says so; the begin of windows and "never" expectations have no tolerance.
/// Cost: O(expectations × records).
std::vector<Verdict> check(const std::vector<Expectation>& expectations,
                           const std::vector<journal::Record>& records,
                           Duration allowed_late = Duration());

}  // namespace skein::scenario
