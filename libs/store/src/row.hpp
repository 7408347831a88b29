// SPDX-License-Identifier: Apache-2.0
// An input as a row of the state file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "skein/node/input_log.hpp"

namespace skein::store {

/// Of the flags of a row in the file: its body is packed (packing.hpp).
inline constexpr std::int64_t kPacked = 4;

/// What is 0 or empty means nothing for the row's kind.
struct Row {
  std::int64_t at = 0;     ///< mission time [ns]
  std::string kind;        ///< "received", "wakeup", …
  std::int64_t peer = 0;   ///< number of the other node
  std::string slot;        ///< its name
  std::int64_t value = 0;  ///< incarnation, sequence, job, send
  std::int64_t extra = 0;  ///< questions asked, the sender's incarnation, receipt
  std::int64_t flags =
      0;  ///< bit 0: reachable, clock given, may have arrived; bit 1: restarted, ran out
  std::vector<std::uint8_t> body;  ///< the sample as on the wire
};

Row row_of(const node::LogEntry& entry);
/// Those of node::is_of_lives().
std::vector<std::string> kinds_of_lives();
/// Reads what row_of() made; whatever else it is given, the failure says what is wrong.
Result<node::LogEntry, Failure> entry_of(const Row& row);

}  // namespace skein::store
