// SPDX-License-Identifier: Apache-2.0
// `skein series`: quantities of a recorded run over time, as CSV.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace skein::series_tool {

struct SeriesOptions {
  std::string folder;  ///< of a run
  std::vector<std::string>
      of{};  ///< quantities, also several parted by commas; none: x, y, z, energy
  std::vector<std::string> uavs;  ///< none: all
  double every = 1;               ///< [s] between two lines, > 0
  std::string csv;                ///< a file; empty: standard output
  bool list = false;              ///< says what quantities there are
  bool measures = false;          ///< figures of the whole run instead, a line each
};

/// Exit codes: cli/series/README.md.
int series(const SeriesOptions& options, std::ostream& out, std::ostream& err);

}  // namespace skein::series_tool
