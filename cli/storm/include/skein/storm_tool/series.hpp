// SPDX-License-Identifier: Apache-2.0
// Results of a series of missions, counted by law.
#pragma once

#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "skein/storm_tool/judge.hpp"

namespace skein::storm_tool {

struct Series {
  struct Row {
    int violations = 0, missions = 0;
    std::vector<std::string> examples;  ///< names of missions
  };
  int missions = 0, broken = 0, goals = 0, achieved = 0, failed = 0;
  double flown = 0;     ///< [s]
  double nearest = -1;  ///< least distance of two UAVs in the air [m]; negative: never two
  std::map<std::string, Row> rows;  ///< by law

  void add(const Case& what, const Verdict& verdict);
};

/// A table for people, with that many examples for each law.
void print(std::ostream& out, const Series& series, std::size_t examples);
/// A line of JSON for each violation.
void print_json(std::ostream& out, const Case& what, const Verdict& verdict);

}  // namespace skein::storm_tool
