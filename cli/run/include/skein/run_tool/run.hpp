// SPDX-License-Identifier: Apache-2.0
// `skein run`: plays a scenario, checks its expectations, writes its report.
#pragma once

#include <iosfwd>
#include <string>

#include "skein/assembly/overrides.hpp"

namespace skein::run_tool {

struct RunOptions {
  std::string scenario;
  bool virtual_time = false;
  assembly::Overrides overrides;
  std::string out;    ///< folder for the results; empty: out/<scenario>
  bool json = false;  ///< one JSON document on standard output instead of text; no progress
  bool quiet = false;
  bool check_only = false;              ///< read and check the scenario, start nothing
  std::string daemons;                  ///< folder of skein-ground, …; empty: beside this program
  std::optional<std::uint32_t> domain;  ///< DDS domain; absent: a free one
};

/// Runs to the end; returns the exit code (docs/exit-codes.md). Results go to `out`, everything
/// that is said on the way to `err`.
int run(const RunOptions& options, std::ostream& out, std::ostream& err);

/// Writes the report of a finished run's folder again.
int report(const std::string& folder, std::ostream& out, std::ostream& err);

}  // namespace skein::run_tool
