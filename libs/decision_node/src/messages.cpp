// SPDX-License-Identifier: Apache-2.0
#include "skein/decision_node/messages.hpp"

namespace skein::decision_node {

Effect::Effect() = default;
Effect::Effect(const Effect& other) = default;
Effect::Effect(Effect&& other) noexcept = default;
Effect& Effect::operator=(const Effect& other) = default;
Effect& Effect::operator=(Effect&& other) noexcept = default;
Effect::~Effect() = default;

}  // namespace skein::decision_node
