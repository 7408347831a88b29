// SPDX-License-Identifier: Apache-2.0
// What a scenario expects of a run, checked on its event log.
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

/// When a match counts: within [from, until], and, if `after` is given, not before the first record
/// that matches it and no later than `within` of it. If that record never comes nothing counts.
struct Window {
  MissionTime from;
  MissionTime until = MissionTime::max();
  std::optional<Pattern> after;
  std::optional<Duration> within;
  /// Earlier than the first record that matches it: not at the same instant, and any time if no
  /// record does.
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
  std::string seen;  ///< for people: what was found, or what was there instead
};

/// One verdict per expectation, in order. `records` are in the order of the log, times never
/// decreasing. What is to come in its window may come by `allowed_late` [>= 0] after its end, which
/// the verdict then says; what must not come, and the window's begin, are as they are.
/// Cost: O(expectations × records).
std::vector<Verdict> check(const std::vector<Expectation>& expectations,
                           const std::vector<journal::Record>& records,
                           Duration allowed_late = Duration());

}  // namespace skein::scenario
