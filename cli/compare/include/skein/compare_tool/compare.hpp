// SPDX-License-Identifier: Apache-2.0
// `skein compare`: what differs between two runs.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>

namespace skein::compare_tool {

struct CompareOptions {
  std::string first, second;     ///< folders of runs
  std::optional<double> within;  ///< [s] times that differ by less are the same
  bool all = false;              ///< every difference, not the first of each section
  bool json = false;
};

/// Exit codes: cli/compare/README.md.
int compare(const CompareOptions& options, std::ostream& out, std::ostream& err);

}  // namespace skein::compare_tool
