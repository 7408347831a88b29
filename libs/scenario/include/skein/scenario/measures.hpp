// SPDX-License-Identifier: Apache-2.0
// Figures of a whole run, computed from its event log.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/scenario/expectation.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::scenario {

/// A figure, and what a person needs to understand it: " m (marvin and heliv at 617 s)".
struct Measured {
  double value = 0;
  std::string context;  ///< unit, who and when; follows the number
};

/// The figure, or why it cannot be computed. Without UAVs: all that have telemetry. Cost: linear in
/// the records.
tl::expected<Measured, std::string> measure(const ExpectMeasure& wanted,
                                            const std::vector<journal::Record>& records);

/// A volume with the time for which it was closed.
struct Closure {
  world::Volume volume;
  world::TimeWindow when;
};

/// What air was closed in a run of a scenario: known from the start, or by its script. What
/// operators close while it runs is not told.
std::vector<Closure> closures_of(const Scenario& scenario,
                                 const std::vector<journal::Record>& records);

/// As in scenario files: "energy-left".
std::string_view name_of(ExpectMeasure::Quantity quantity);
/// "m", "s", or nothing.
std::string_view unit_of(ExpectMeasure::Quantity quantity);
/// Of a NamedMeasure by its name; nothing for other names.
std::string_view unit_of(const std::string& measure);

/// A measure as a column of a table.
struct NamedMeasure {
  std::string name;  ///< "energy-left", "minimum-separation marvin heliv"
  ExpectMeasure what;
};

/// Those that need nothing but an event log, each of all UAVs together.
std::vector<NamedMeasure> measures_of_any_run();

/// These; the time in closed air, if any air is closed in the scenario; and those of single UAVs
/// that it has expectations of. No name twice.
std::vector<NamedMeasure> measures_of(const Scenario& scenario);

}  // namespace skein::scenario
