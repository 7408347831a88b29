// SPDX-License-Identifier: Apache-2.0
// Two runs side by side.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "facts.hpp"

namespace skein::compare_tool {

/// A fact that differs between the runs.
struct Difference {
  std::string name;
  std::optional<Fact> first, second;  ///< absent: not in that run
  /// [s] when it first showed in either; nothing of what has no time.
  std::optional<double> at() const;
};

struct SectionDifference {
  std::string name;
  std::size_t facts = 0;                ///< of both together
  std::vector<Difference> differences;  ///< in the order of time, then of names
};

/// The first line in which two event logs differ; absent for a log that has ended before.
struct Divergence {
  std::size_t line = 0;  ///< from 1
  std::optional<std::string> first, second;
  bool operator==(const Divergence&) const = default;
};

struct Comparison {
  bool same_bytes = false;
  std::vector<SectionDifference> sections;
  std::optional<Divergence> divergence;  ///< of logs that are not the same

  bool same_facts() const;
};

std::optional<Divergence> divergence_of(const std::string& first, const std::string& second);

/// Times and measured seconds that differ by no more than `within` [s] are the same.
Comparison compared(const recording::Run& first, const recording::Run& second, double within);

}  // namespace skein::compare_tool
