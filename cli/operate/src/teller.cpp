// SPDX-License-Identifier: Apache-2.0
#include "teller.hpp"

#include <ostream>

namespace skein::operate_tool {

namespace {

using wire::CommandState;

// A refusal may come from the ground station itself, and then nothing was delivered.
bool was_delivered(CommandState state) {
  return state == CommandState::kDelivered || state == CommandState::kAcknowledged;
}

}  // namespace

void Teller::tell(const wire::OperatorReply& reply) {
  for (const wire::CommandEntry& one : reply.commands) {
    tell(one, CommandState::kIssued);
    if (was_delivered(one.state)) tell(one, CommandState::kDelivered);
    tell(one, one.state);
  }
  const bool is_done =
      reply.accepted && reply.complete && reply.problems.empty() && reply.commands.empty();
  if (is_done && !std::exchange(done_, true)) out_ << "done" << std::endl;
}

void Teller::tell(const wire::CommandEntry& command, CommandState state) {
  if (!told_.emplace(command.command, state).second) return;
  out_ << command.uav << ": " << command.what << ": " << name_of(state);
  if (state == command.state && !command.why.empty()) out_ << ": " << command.why;
  out_ << std::endl;
}

}  // namespace skein::operate_tool
