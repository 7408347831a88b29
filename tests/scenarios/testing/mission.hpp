// SPDX-License-Identifier: Apache-2.0
// Plays a scenario in virtual time and keeps its event log.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skein/journal/record.hpp"
#include "skein/node/virtual_runtime.hpp"
#include "skein/scenario/scenario.hpp"
#include "skein/scenario_setup/overrides.hpp"

namespace skein::testing {

using End = node::VirtualOutcome::End;

struct Mission {
  End end = End::kFinished;
  std::vector<journal::Record> records;  ///< in order of time
  std::vector<scenario::Verdict> verdicts;
  std::string
      untrue;  ///< what breaks a law of truth (libs/laws), and words not counted, a line each

  /// The event log, byte for byte.
  std::string log() const;
  /// The expectations that are not met, with what was seen; empty when all are.
  std::string failures() const;

  /// The records in which every field given has the value given, as text ("kind" and "node" too).
  using Fields = std::vector<std::pair<std::string, std::string>>;
  std::vector<journal::Record> find(const Fields& fields) const;
  std::size_t count(const Fields& fields) const { return find(fields).size(); }
  /// When the first of them was [s].
  std::optional<double> first(const Fields& fields) const;
};

/// scenarios/NAME.yaml ("karma/detection") with these overrides. Stops the program if it cannot be
/// read.
scenario::Scenario scenario_at(const std::string& name,
                               const scenario_setup::Overrides& overrides = {});

/// scenarios/comets/NAME.yaml with these overrides. Stops the program if it cannot be read.
scenario::Scenario comets(const std::string& name, const scenario_setup::Overrides& overrides = {});

/// Overrides of a seed and degrees, as on the command line.
scenario_setup::Overrides with(std::uint64_t seed, std::vector<std::string> degrees = {});

Mission play(const scenario::Scenario& scenario);

}  // namespace skein::testing
