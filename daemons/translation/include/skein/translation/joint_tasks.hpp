// SPDX-License-Identifier: Apache-2.0
// Negotiations and states of joint tasks: wire to domain and back.
#pragma once

#include "skein/blackboard/wire.hpp"
#include "skein/negotiation/joint_task_status.hpp"
#include "skein/negotiation/terms.hpp"

namespace skein::translation {

wire::NegotiationMessage to_wire(const interaction::SessionMessage& message, const std::string& to);
/// Does not check the content; the negotiation manager rejects invalid messages.
interaction::SessionMessage from_wire(const wire::NegotiationMessage& sample);

wire::JointTaskState to_wire(const interaction::JointTaskStatus& status);
interaction::JointTaskStatus from_wire(const wire::JointTaskState& sample);

}  // namespace skein::translation
