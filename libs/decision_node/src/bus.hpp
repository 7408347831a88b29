// SPDX-License-Identifier: Apache-2.0
// The ways between the components of a decision node, and out of it.
#pragma once

#include <deque>
#include <functional>
#include <utility>

#include "skein/decision_node/messages.hpp"

namespace skein::decision_node {

/// What one component asks of another comes after all that was asked before: an interruption never
/// overtakes the dispatch of its task.
class Bus {
 public:
  void begin(MissionTime now) {
    now_ = now;
    effects_.clear();
  }
  Effects end() { return std::move(effects_); }
  /// Of the call that is running.
  MissionTime now() const { return now_; }

  void emit(Effect effect) { effects_.push_back(std::move(effect)); }
  /// Done at once, or after the errands that wait already.
  void post(std::function<void()> errand) {
    errands_.push_back(std::move(errand));
    if (busy_) return;
    busy_ = true;
    while (!errands_.empty()) {
      const std::function<void()> next = std::move(errands_.front());
      errands_.pop_front();
      next();
    }
    busy_ = false;
  }

 private:
  MissionTime now_;
  Effects effects_;
  std::deque<std::function<void()>> errands_;
  bool busy_ = false;
};

}  // namespace skein::decision_node
