// SPDX-License-Identifier: Apache-2.0
// The data for all browsers: the last of each value, and events, in one order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

namespace skein::console {

/// The only state of a reader is its cursor: a slow reader misses values that were replaced
/// meanwhile, and is told if events were dropped before it read them. Not safe to share between
/// threads. Cost: O(log) per entry put, linear in the entries taken.
class Feed {
 public:
  /// The value under a key replaces the one before. `json`: one line.
  void set(const std::string& key, std::string json);
  /// Adds an event; the oldest are dropped beyond kEvents events or kEventBytes.
  void add(std::string json);

  /// Drops all values and events; readers get the given line, and then the new entries.
  void begin_again(std::string json);

  bool has_news(std::uint64_t cursor) const { return version_ > cursor; }
  /// The entries after the cursor, oldest first, as server-sent events, until they have at least
  /// `most` bytes; advances the cursor.
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
