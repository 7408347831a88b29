// SPDX-License-Identifier: Apache-2.0
#include "skein/translation/journal_lines.hpp"

namespace skein::translation {

journal::Record task_line(const Writer& writer, const std::string& uav,
                          const executive::TaskEvent& event,
                          const executive::Parameters& parameters) {
  journal::Record line(writer.at, writer.node, "task");
  line.with("uav", uav)
      .with("task", event.id.value())
      .with("type", event.type)
      .with("state", to_text(event.state));
  with_device_and_target(line, parameters);
  if (!event.reason.empty()) line.with("reason", event.reason);
  return line;
}

void with_device_and_target(journal::Record& line, const executive::Parameters& parameters) {
  const executive::Parameter* device = parameters.find("device");
  if (device != nullptr) line.with("device", device->text);
  const executive::Parameter* target = parameters.find("target");
  if (target != nullptr) line.with("target", journal::rounded(target->numbers));
}

journal::Record request_line(const Writer& writer, const std::string& uav,
                             const executive::Reply& reply, executive::InsertionMode mode) {
  journal::Record line(writer.at, writer.node, "request");
  line.with("uav", uav).with("request", to_text(reply.request));
  if (reply.request == executive::RequestKind::kStart) line.with("mode", to_text(mode));
  if (reply.id) line.with("task", reply.id->value());
  line.with("accepted", reply.accepted);
  if (!reply.accepted) line.with("why", reply.why);
  return line;
}

journal::Record sync_line(const Writer& writer, const SyncTraffic& message) {
  journal::Record line(writer.at, writer.node, "sync");
  line.with("id", message.id)
      .with("from", message.from)
      .with("to", message.to)
      .with("direction", message.sent ? "sent" : "received");
  if (message.word != executive::SyncWord::kThere) line.with("word", to_text(message.word));
  return line;
}

}  // namespace skein::translation
