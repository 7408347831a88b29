// SPDX-License-Identifier: Apache-2.0
// Tasks that the decision node makes by itself to keep its vehicle safe.
#pragma once

#include <set>
#include <string>

#include "bus.hpp"
#include "skein/foundation/rising.hpp"

namespace skein::decision_node {

class Execution;

inline constexpr const char* kOwnIds = "ids from 500000000 are the decision node's own";

inline bool is_own(functional::TaskId id) { return id >= functional::kFirstOwnId; }

class OwnTasks {
 public:
  OwnTasks(Bus& bus, Execution& execution) : bus_(bus), execution_(execution) {}

  /// Gives the executive a new task.
  void start(const std::string& type, functional::Parameters parameters,
             executive::InsertionMode mode);
  /// Aborts all of them, the highest id first.
  void abort_all();
  /// Notes a state of a task; true: an own task is over.
  bool see(const executive::TaskEvent& event);
  /// Whether all own tasks are in terminal states.
  bool none_open() const { return open_.empty(); }
  /// Whether the own task that ended last was given up by the vehicle, without a request to stop.
  bool given_up() const { return given_up_; }

 private:
  Bus& bus_;
  Execution& execution_;
  std::set<functional::TaskId> open_, under_way_;
  bool given_up_ = false;
  Rising ids_;  ///< from kFirstOwnId on
};

}  // namespace skein::decision_node
