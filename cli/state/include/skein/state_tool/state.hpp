// SPDX-License-Identifier: Apache-2.0
// `skein state`: inspects the persistent state of a daemon.
#pragma once

#include <iosfwd>
#include <string>

namespace skein::state_tool {

struct StateOptions {
  enum class What { kShow, kCheck, kExport };
  What what = What::kShow;
  std::string file;   ///< NODE.state
  bool json = false;  ///< kShow
};

/// kShow: whose it is and what is in it. kCheck: reads all of it; exit code 1 with the reason if it
/// cannot be gone on from. kExport: every input, one JSON object a line. 2 if it cannot be read.
int state(const StateOptions& options, std::ostream& out, std::ostream& err);

}  // namespace skein::state_tool
