// SPDX-License-Identifier: Apache-2.0
// `skein run`: plays a scenario, checks its expectations, writes its report.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "skein/scenario_setup/overrides.hpp"

namespace skein::run_tool {

struct RunOptions {
  std::string scenario;
  bool virtual_time = false;
  scenario_setup::Overrides overrides;
  std::string out;    ///< folder for the results; empty: out/<scenario>
  bool json = false;  ///< one JSON document on standard output instead of text; no progress
  bool quiet = false;
  std::vector<std::string> explain;     ///< "karma", "karma:104": said after the run
  bool check_only = false;              ///< read and check the scenario, start nothing
  std::string daemons;                  ///< folder of skein-ground, …; empty: beside this program
  std::optional<std::uint32_t> domain;  ///< DDS domain; absent: a free one
  std::vector<std::string> without;     ///< nodes that somebody else starts, over DDS
  /// Addresses of this machine where the run itself listens to its daemons; empty: on this machine.
  std::vector<std::string> interfaces;
  std::string security;               ///< folder of make-keys, over DDS; empty: none
  bool types = false;                 ///< nodes on Cyclone DDS announce the types of their samples
  std::string mcap;                   ///< file for the run as MCAP; empty: none
  std::string console;                ///< ADDRESS:PORT of the operators' page; empty: none
  std::optional<std::uint32_t> ros2;  ///< domain of ROS 2, over DDS; none: it is not told
  double allow_late = 0;    ///< [s] on the wall by which what is expected may be late, over DDS
  std::string mavlink_out;  ///< address of a MAVLink station, over DDS; empty: none
};

/// Runs to the end; returns the exit code (docs/exit-codes.md). Results go to `out`, everything
/// that is said on the way to `err`.
int run(const RunOptions& options, std::ostream& out, std::ostream& err);

struct ReportOptions {
  std::string folder;
  std::vector<std::string> explain;  ///< "karma", "karma:104"; then no report is written
};

/// Writes the report of a finished run's folder again, or explains what UAVs did in it.
int report(const ReportOptions& options, std::ostream& out, std::ostream& err);

}  // namespace skein::run_tool
