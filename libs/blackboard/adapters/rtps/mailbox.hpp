// SPDX-License-Identifier: Apache-2.0
// Between the threads of a middleware and that of a blackboard.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <mutex>
#include <utility>
#include <vector>

#include "skein/blackboard/transport.hpp"

namespace skein::blackboard::rtps {

/// What listeners of any thread leave and the owner takes; of more than `most`, the newest.
template <class Item>
class MailboxOf {
 public:
  explicit MailboxOf(std::size_t most = std::numeric_limits<std::size_t>::max()) : most_(most) {}

  void put(Item item) {
    const std::lock_guard lock(mutex_);
    if (items_.size() == most_) items_.erase(items_.begin());
    items_.push_back(std::move(item));
  }
  void notify() {
    const std::lock_guard lock(notify_mutex_);
    if (notify_) notify_();
  }
  std::vector<Item> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(items_, {});
  }
  void on_arrival(std::function<void()> notify) {
    const std::lock_guard lock(notify_mutex_);
    notify_ = std::move(notify);
  }

 private:
  const std::size_t most_;
  std::mutex mutex_;
  std::vector<Item> items_;
  std::mutex notify_mutex_;  // apart: a notified thread may take at once
  std::function<void()> notify_;
};

using Mailbox = MailboxOf<Arrival>;

}  // namespace skein::blackboard::rtps
