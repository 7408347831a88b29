// SPDX-License-Identifier: Apache-2.0
// Bodies of samples as what is new in them: a plan board is like the one before it.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "row.hpp"

namespace skein::store {

/// Packs each body against the last one of its peer and slot, as a Zstandard frame with that as its
/// prefix. Rows are unpacked in the order in which they were packed; the first of each peer and
/// slot that a Packing packs needs none before it, so that each life of a node begins with a new
/// one. A row that does not become shorter stays as it is. Each frame has a checksum: a
/// body whose predecessor is missing or damaged is not read as another. Cost: some microseconds a
/// row, memory: the last bodies. Thread rule: one thread. Source: RFC 8878; zstd.h,
/// ZSTD_CCtx_refPrefix.
class Packing {
 public:
  Packing();
  Packing(Packing&& other) noexcept;
  Packing& operator=(Packing&& other) noexcept;
  ~Packing();

  void pack(Row& row);
  /// Throws std::runtime_error at what pack() did not make.
  void unpack(Row& row);

 private:
  using Bytes = std::vector<std::uint8_t>;
  struct Contexts;

  std::unique_ptr<Contexts> contexts_;
  std::map<std::pair<std::int64_t, std::string>, Bytes> last_;  ///< by peer and slot
};

}  // namespace skein::store
