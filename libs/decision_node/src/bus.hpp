// SPDX-License-Identifier: Apache-2.0
// Calls between the components of a decision node, and its effects.
#pragma once

#include <deque>
#include <functional>
#include <utility>

#include "skein/decision_node/messages.hpp"

namespace skein::decision_node {

/// Calls between components are carried out in the order in which they were made: an interruption
/// never overtakes the dispatch of its task.
class Bus {
 public:
  void begin(MissionTime now) {
    now_ = now;
    effects_.clear();
  }
  Effects end() { return std::move(effects_); }
  /// The time of the input being handled.
  MissionTime now() const { return now_; }

  void emit(Effect effect) { effects_.push_back(std::move(effect)); }
  /// Runs the errand at once, or after those that wait already.
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
