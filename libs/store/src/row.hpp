// SPDX-License-Identifier: Apache-2.0
// An input as a row of the state file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "skein/node/input_log.hpp"

namespace skein::store {

/// Bit of Row::flags in the file: the body is packed (packing.hpp).
inline constexpr std::int64_t kPacked = 4;

/// Members that the row's kind does not use are 0 or empty.
struct Row {
  std::int64_t at = 0;     ///< mission time [ns]
  std::string kind;        ///< "received", "wakeup", …
  std::int64_t peer = 0;   ///< number of the other node
  std::string slot;        ///< name of the slot
  std::int64_t value = 0;  ///< incarnation, sequence, job, send
  std::int64_t extra = 0;  ///< questions asked, the sender's incarnation, receipt
  /// Bit 0: first life, reachable, clock given, may have arrived; bit 1: restarted, ran out.
  std::int64_t flags = 0;
  std::vector<std::uint8_t> body;  ///< the sample as on the wire
};

Row row_of(const node::LogEntry& entry);
/// The kinds of the rows whose entries are node::is_of_lives().
std::vector<std::string> kinds_of_lives();
/// Inverse of row_of(). The failure says what is wrong with a row that is no result of row_of().
Result<node::LogEntry, Failure> entry_of(const Row& row);

}  // namespace skein::store
