// SPDX-License-Identifier: Apache-2.0
#include "skein/translation/journal_lines.hpp"

#include "skein/journal/lines/execution.hpp"

namespace skein::translation {

namespace lines = journal::lines;

journal::Record task_line(const Writer& writer, const std::string& uav,
                          const executive::TaskEvent& event,
                          const executive::Parameters& parameters) {
  return writer.record(lines::Task{.uav = uav,
                                   .task = event.id.value(),
                                   .type = event.type,
                                   .state = to_text(event.state),
                                   .device = device_of(parameters),
                                   .target = target_of(parameters),
                                   .reason = event.reason});
}

journal::OptionalText device_of(const executive::Parameters& parameters) {
  const executive::Parameter* device = parameters.find("device");
  return device == nullptr ? journal::OptionalText() : device->text;
}

journal::OptionalNumbers target_of(const executive::Parameters& parameters) {
  const executive::Parameter* target = parameters.find("target");
  return target == nullptr ? journal::OptionalNumbers() : journal::rounded(target->numbers);
}

journal::Record request_line(const Writer& writer, const std::string& uav,
                             const executive::Reply& reply, executive::InsertionMode mode) {
  lines::Request line{.uav = uav,
                      .request = to_text(reply.request),
                      .accepted = reply.accepted,
                      .why = reply.accepted ? "" : reply.why};
  if (reply.request == executive::RequestKind::kStart) line.mode = to_text(mode);
  if (reply.id) line.task = reply.id->value();
  return writer.record(std::move(line));
}

journal::Record sync_line(const Writer& writer, const SyncTraffic& message) {
  const bool waits = message.word == executive::SyncWord::kThere;
  return writer.record(lines::Sync{.id = message.id,
                                   .from = message.from,
                                   .to = message.to,
                                   .direction = message.sent ? "sent" : "received",
                                   .word = waits ? "" : to_text(message.word)});
}

}  // namespace skein::translation
