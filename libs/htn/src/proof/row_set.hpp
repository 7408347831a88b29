// SPDX-License-Identifier: Apache-2.0
// A set of rows of terms, to detect duplicates.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "skein/htn/term.hpp"

namespace skein::htn {

/// Rows are identified by numbers of the caller, who gives access to their terms. A few rows are
/// compared one by one, many by a hash table, whose memory is reused.
class RowSet {
 public:
  /// Clears the set, for at most `most` rows.
  void begin(std::size_t most) {
    rows_.clear();
    const bool many = most > kFew;
    table_.assign(many ? std::bit_ceil(most * 2) : 0, 0);
  }
  /// Inserts a row. False: the set has an equal row.
  template <class RowAt>
  bool add(std::size_t row, RowAt row_at) {
    const std::span<const Term> wanted = row_at(row);
    const auto equal = [&](std::uint32_t other) {
      const std::span<const Term> terms = row_at(other);
      return std::equal(terms.begin(), terms.end(), wanted.begin(), wanted.end());
    };
    if (table_.empty()) {
      if (std::any_of(rows_.begin(), rows_.end(), equal)) return false;
    } else {
      const std::size_t mask = table_.size() - 1;
      std::size_t at = hash_of(wanted) & mask;
      for (; table_[at] != 0; at = (at + 1) & mask) {
        if (equal(rows_[table_[at] - 1])) return false;
      }
      table_[at] = static_cast<std::uint32_t>(rows_.size() + 1);
    }
    rows_.push_back(static_cast<std::uint32_t>(row));
    return true;
  }

 private:
  static constexpr std::size_t kFew = 8;
  static std::size_t hash_of(std::span<const Term> terms) {
    std::uint64_t hash = 0;
    for (const Term term : terms) {
      hash = (hash ^ term.bits()) * 0x9E3779B97F4A7C15ULL;
      hash ^= hash >> 32U;
    }
    return static_cast<std::size_t>(hash);
  }
  std::vector<std::uint32_t> rows_;
  std::vector<std::uint32_t> table_;  ///< open addressing; 0: free, else position in rows_ + 1
};

}  // namespace skein::htn
