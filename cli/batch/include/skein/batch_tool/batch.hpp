// SPDX-License-Identifier: Apache-2.0
// `skein batch`: scenarios times seeds in virtual time; tables, CSV and a picture of the results.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "skein/workers/workers.hpp"

namespace skein::batch_tool {

struct BatchOptions {
  std::vector<std::string> scenarios;  ///< files, at least one
  std::string seeds = "1..20";         ///< A..B: one run each, of each scenario and combination
  std::vector<std::string> degrees;    ///< as of `skein run`
  std::vector<std::string> sets;       ///< "PATH=VALUE[,VALUE…]"
  std::string out = "out/batch";       ///< folder of runs.csv, summary.json and summary.svg
  std::string csv;                     ///< the CSV goes there instead
  bool keep = false;                   ///< the folder of each run, in `out`
  bool json = false, quiet = false;
  bool on_terminal = false;  ///< progress is one line that is written over
  workers::Limits limits;
};

/// Exit codes: cli/batch/README.md.
int batch(const BatchOptions& options, std::ostream& out, std::ostream& err);

}  // namespace skein::batch_tool
