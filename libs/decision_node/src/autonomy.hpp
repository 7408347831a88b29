// SPDX-License-Identifier: Apache-2.0
// The degree of autonomy, and the hand-over of tasks when it changes. Source: spec 1.2.
#pragma once

#include <string>
#include <vector>

#include "component.hpp"

namespace skein::decision_node {

class Core;

class Autonomy final : public Component {
 public:
  /// Precondition: the configuration allows its initial degree.
  explicit Autonomy(Core& core);

  int degree() const { return degree_; }
  void start();
  void take(const Command& command) override;
  /// Emits the plan in hand: these tasks and those that the supervisor handed over.
  void hand_over(std::vector<mission::HeldTask> tasks);

 private:
  void change(const mission::ChangeDegree& change, const std::string& asked_by);
  void engage(bool resume, const std::string& cause, bool executed_here);
  void interrupt_everything();

  Core& core_;
  int degree_;
};

}  // namespace skein::decision_node
