// SPDX-License-Identifier: Apache-2.0
#include "feed.hpp"

#include <utility>

#include "limits.hpp"

namespace skein::console {

void Feed::set(const std::string& key, std::string json) {
  const auto known = keys_.find(key);
  if (known != keys_.end()) {
    const auto entry = entries_.find(known->second);
    if (entry->second.json == json) return;
    entries_.erase(entry);
  }
  entries_[++version_] = {std::move(json), false};
  keys_[key] = version_;
}

void Feed::add(std::string json) {
  bytes_ += json.size();
  events_[++version_] = json.size();
  entries_[version_] = {std::move(json), true};
  drop_events();
}

void Feed::begin_again(std::string json) {
  entries_.clear();
  keys_.clear();
  events_.clear();
  bytes_ = 0;
  dropped_ = 0;
  add(std::move(json));
}

void Feed::drop_events() {
  while (events_.size() > kEvents || bytes_ > kEventBytes) {
    const auto oldest = events_.begin();
    bytes_ -= oldest->second;
    dropped_ = oldest->first;
    entries_.erase(oldest->first);
    events_.erase(oldest);
  }
}

std::string Feed::take(std::uint64_t& cursor, std::size_t most) const {
  std::string text;
  if (cursor > 0 && cursor < dropped_) text += "event: gap\ndata: {}\n\n";
  auto entry = entries_.upper_bound(cursor);
  for (; entry != entries_.end() && text.size() < most; ++entry) {
    text += "data: " + entry->second.json + "\n\n";
    cursor = entry->first;
  }
  if (entry == entries_.end()) cursor = version_;
  return text;
}

}  // namespace skein::console
