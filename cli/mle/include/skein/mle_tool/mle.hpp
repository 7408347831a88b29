// SPDX-License-Identifier: Apache-2.0
// `skein mle`: replays a trace of requests and statuses through an executive.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>

#include "skein/foundation/time.hpp"

namespace skein::mle_tool {

/// Source: spec 2.8.
struct MleOptions {
  std::string uav;                   ///< --uav NAME: own name among senders and receivers
  std::optional<MissionTime> until;  ///< --until S: run time on to S after the last line
  std::string types_file;            ///< --types FILE: types declared over the elementary ones
  std::optional<Duration> timeout;  ///< --timeout S: of the functional layer, positive; absent: off
  std::optional<Duration> sync_validity;  ///< --sync-validity S, positive; absent: off
  std::optional<std::string> background;  ///< --background TYPE; absent: off
  std::string input_name;                 ///< for messages; empty: standard input
};

/// Reads JSON lines from `in` (formats: cli/mle/README.md), writes to `out` what happens and to
/// `err` what is only for the log, and again what is wrong with a line. Lines are read one by one
/// and answered at once. 0: done; 1: some line was wrong (the others were replayed); 2: the types
/// file cannot be used.
int run_mle(const MleOptions& options, std::istream& in, std::ostream& out, std::ostream& err);

}  // namespace skein::mle_tool
