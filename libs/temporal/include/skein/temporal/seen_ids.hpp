// SPDX-License-Identifier: Apache-2.0
// The set of handled message ids of one sender.
#pragma once

#include <cstdint>
#include <map>

namespace skein::temporal {

/// A set of ids kept as disjoint intervals: ids come nearly in order, so it stays small (one more
/// interval for each gap that a cut or another receiver leaves).
class SeenIds {
 public:
  bool contains(std::uint64_t id) const;
  void insert(std::uint64_t id);
  /// 0 when empty.
  std::uint64_t last() const { return intervals_.empty() ? 0 : intervals_.rbegin()->second; }

 private:
  std::map<std::uint64_t, std::uint64_t> intervals_;  ///< first to last
};

}  // namespace skein::temporal
