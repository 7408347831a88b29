// SPDX-License-Identifier: Apache-2.0
// Between the threads of a middleware and that of a blackboard.
#pragma once

#include <functional>
#include <mutex>
#include <utility>
#include <vector>

#include "skein/blackboard/transport.hpp"

namespace skein::blackboard::rtps {

/// What listeners of any thread leave and the owner takes.
class Mailbox {
 public:
  void put(Arrival arrival) {
    const std::lock_guard lock(mutex_);
    arrivals_.push_back(std::move(arrival));
  }
  void notify() {
    const std::lock_guard lock(notify_mutex_);
    if (notify_) notify_();
  }
  std::vector<Arrival> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(arrivals_, {});
  }
  void on_arrival(std::function<void()> notify) {
    const std::lock_guard lock(notify_mutex_);
    notify_ = std::move(notify);
  }

 private:
  std::mutex mutex_;
  std::vector<Arrival> arrivals_;
  std::mutex notify_mutex_;  // apart: a notified thread may take at once
  std::function<void()> notify_;
};

}  // namespace skein::blackboard::rtps
