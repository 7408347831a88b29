// SPDX-License-Identifier: Apache-2.0
#include "skein/decision_node/decision_node.hpp"

#include "core.hpp"

namespace skein::decision_node {

DecisionNode::DecisionNode(Config config) : core_(std::make_unique<Core>(std::move(config))) {}
DecisionNode::~DecisionNode() = default;
DecisionNode::DecisionNode(DecisionNode&&) noexcept = default;
DecisionNode& DecisionNode::operator=(DecisionNode&&) noexcept = default;

Effects DecisionNode::handle(const Input& input, MissionTime now) {
  return core_->handle(input, now);
}

std::optional<MissionTime> DecisionNode::next_wakeup() const { return core_->next_wakeup(); }

}  // namespace skein::decision_node
