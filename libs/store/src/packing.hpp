// SPDX-License-Identifier: Apache-2.0
// Packing: delta compression of sample bodies against their predecessors.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "row.hpp"

namespace skein::store {

/// Compresses each body into a Zstandard frame whose prefix is the last body of the same peer and
/// slot (successive plan boards, for example, are alike). Rows have to be unpacked in the order in
/// which they were packed. The first body of each peer and slot in a Packing has no predecessor, so
/// each life of a node begins with a new Packing. A row that does not become shorter stays
/// unpacked. Each frame has a checksum, so that a missing or damaged predecessor is detected. Cost:
/// some microseconds a row; memory: the last bodies. Thread rule: one thread. Source: RFC 8878;
/// zstd.h, ZSTD_CCtx_refPrefix.
class Packing {
 public:
  Packing();
  Packing(Packing&& other) noexcept;
  Packing& operator=(Packing&& other) noexcept;
  ~Packing();

  void pack(Row& row);
  /// Inverse of pack(). Throws std::runtime_error if the body is not a result of pack().
  void unpack(Row& row);

 private:
  using Bytes = std::vector<std::uint8_t>;
  struct Contexts;

  std::unique_ptr<Contexts> contexts_;
  std::map<std::pair<std::int64_t, std::string>, Bytes> last_;  ///< by peer and slot
};

}  // namespace skein::store
