// SPDX-License-Identifier: Apache-2.0
// What all browsers are told: the last of each value, and events, in one order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

namespace skein::console {

/// Every reader has a cursor and nothing else: a slow one misses what was replaced meanwhile, and
/// is told when events were thrown away before it came to them. Not safe to share between threads.
/// Cost: O(log) for what is put, linear in what is taken.
class Feed {
 public:
  /// The value under a key replaces the one before. `json`: one line.
  void set(const std::string& key, std::string json);
  /// Kept until there are more than kEvents, or kEventBytes of them.
  void add(std::string json);

  /// Forgets all values and events; readers are told the line that says so, and what is put after
  /// it.
  void begin_again(std::string json);

  bool has_news(std::uint64_t cursor) const { return version_ > cursor; }
  /// What came after the cursor, oldest first, as server-sent events, until it is at least `most`
  /// bytes; the cursor moves on.
  std::string take(std::uint64_t& cursor, std::size_t most) const;

 private:
  struct Entry {
    std::string json;
    bool is_event = false;
  };
  void drop_events();

  std::uint64_t version_ = 0;
  std::map<std::uint64_t, Entry> entries_;     ///< by version
  std::map<std::string, std::uint64_t> keys_;  ///< versions of values
  std::map<std::uint64_t, std::size_t> events_;
  std::size_t bytes_ = 0;      ///< of events
  std::uint64_t dropped_ = 0;  ///< the latest event that was thrown away
};

}  // namespace skein::console
