// SPDX-License-Identifier: Apache-2.0
// A counter for repeated messages: they are to be logged the first, 10th, 100th, … time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace skein {

/// Counts occurrences by kind, for at most `most_kinds` kinds; further kinds are never logged.
/// Cost: a map look-up.
template <class Key>
class Tally {
 public:
  explicit Tally(std::size_t most_kinds) : most_kinds_(most_kinds) {}

  /// Counts one occurrence. Returns a suffix for the log line: "" the first time, " (10 times)" the
  /// 10th and so on; absent: not to be logged.
  std::optional<std::string> count(const Key& kind) {
    if (times_.size() >= most_kinds_ && !times_.contains(kind)) return std::nullopt;
    const std::uint64_t times = ++times_[kind];
    if (times == 1) return "";
    if (!is_power_of_ten(times)) return std::nullopt;
    return " (" + std::to_string(times) + " times)";
  }

 private:
  static bool is_power_of_ten(std::uint64_t number) {
    while (number >= 10 && number % 10 == 0) number /= 10;
    return number == 1;
  }

  std::size_t most_kinds_;
  std::map<Key, std::uint64_t> times_;
};

}  // namespace skein
