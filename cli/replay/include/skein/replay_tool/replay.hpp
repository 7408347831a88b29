// SPDX-License-Identifier: Apache-2.0
// `skein replay`: a recorded run on the operators' page.
#pragma once

#include <iosfwd>
#include <string>

namespace skein::replay_tool {

struct ReplayOptions {
  std::string folder;         ///< of the run: events.jsonl, world.json
  std::string console = "0";  ///< ADDRESS:PORT of the page; port 0: any that is free
  double speed = 1;           ///< mission seconds per second, at the start
};

/// Serves the page until SIGINT or SIGTERM; its address goes to `out`. Exit codes: 0 it was
/// stopped, 2 the folder cannot be read or the address cannot be listened at.
int replay(const ReplayOptions& options, std::ostream& out, std::ostream& err);

}  // namespace skein::replay_tool
