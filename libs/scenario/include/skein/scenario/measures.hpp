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

/// A figure with its context for people: " m (marvin and heliv at 617 s)".
struct Measured {
  double value = 0;
  std::string context;  ///< unit, who and when; follows the number
};

/// The figure, or the reason why it cannot be computed. If `wanted` names no UAVs: of all with
/// telemetry. Cost: linear in the records.
tl::expected<Measured, std::string> measure(const ExpectMeasure& wanted,
                                            const std::vector<journal::Record>& records);

/// A volume with the time for which it was closed.
struct Closure {
  world::Volume volume;
  world::TimeWindow when;
};

/// The volumes that were closed in a run, from the start or by the script; those that operators
/// closed are not included.
std::vector<Closure> closures_of(const Scenario& scenario,
                                 const std::vector<journal::Record>& records);

/// The name in scenario files: "energy-left".
std::string_view name_of(ExpectMeasure::Quantity quantity);
/// "m", "s", or nothing.
std::string_view unit_of(ExpectMeasure::Quantity quantity);
/// The unit of a NamedMeasure of this name; empty for other names.
std::string_view unit_of(const std::string& measure);

/// A measure as a column of a table.
struct NamedMeasure {
  std::string name;  ///< "energy-left", "minimum-separation marvin heliv"
  ExpectMeasure what;
};

/// The measures that need only an event log, each over all UAVs.
std::vector<NamedMeasure> measures_of_any_run();

/// measures_of_any_run(); the time in closed air, if the scenario closes any; and the measures in
/// the scenario's expectations. No name twice.
std::vector<NamedMeasure> measures_of(const Scenario& scenario);

}  // namespace skein::scenario
