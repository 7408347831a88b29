// SPDX-License-Identifier: Apache-2.0
// The results of a run, as named facts.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "skein/recording/run.hpp"

namespace skein::compare_tool {

struct Fact {
  std::string text;             ///< "ended", "3 times"; may be empty
  std::optional<double> at;     ///< [s] when it came to be so
  std::optional<double> value;  ///< of a measure
  bool operator==(const Fact&) const = default;
};

struct Section {
  std::string name;  ///< "tasks"
  std::map<std::string, Fact> facts;
};

/// Sections outcome, expectations, measures, goals, tasks, decisions; the same for every run.
std::vector<Section> facts_of(const recording::Run& run);

}  // namespace skein::compare_tool
