// SPDX-License-Identifier: Apache-2.0
#include "node_lines.hpp"

#include "deliberation_lines.hpp"
#include "skein/journal/lines/mission.hpp"

namespace skein::ddn {

journal::Record line_of(const translation::Writer& writer,
                        const decision_node::RequestHandled& handled) {
  return translation::request_line(writer, writer.node, handled.reply, handled.mode);
}

journal::Record line_of(const translation::Writer& writer, const decision_node::SyncHeard& heard) {
  const decision_node::SyncMessage& message = heard.message;
  return translation::sync_line(writer,
                                {message.id, message.from, message.to, false, message.word});
}

journal::Record line_of(const translation::Writer& writer,
                        const decision_node::PolicyCarriedOut& policy) {
  return writer.record(journal::lines::Contact{
      .uav = writer.node, .policy = to_text(policy.policy), .why = policy.why});
}

journal::Record line_of(const translation::Writer& writer, const decision_node::Notice& notice) {
  return writer.record(journal::lines::Notice{.uav = writer.node, .text = notice.text});
}

journal::Record line_of(const translation::Writer& writer, const supervisor::GoalChanged& changed) {
  return goal_line(writer, changed.status);
}

}  // namespace skein::ddn
