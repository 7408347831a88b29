// SPDX-License-Identifier: Apache-2.0
#include "ground_lines.hpp"

#include "skein/translation/team_lines.hpp"

namespace skein::ground {

namespace {

namespace gs = ground_station;
using journal::Record;
using translation::Writer;

Record record(const Writer& writer, const char* kind) { return {writer.at, writer.node, kind}; }

}  // namespace

Record line_of(const Writer& writer, const gs::OperatorAsked& effect) {
  Record line(writer.at, writer.node, "asked");
  line.with("who", effect.who)
      .with("number", effect.number)
      .with("what", effect.what)
      .with("accepted", effect.accepted);
  if (!effect.why.empty()) line.with("why", effect.why);
  return line;
}

Record line_of(const Writer& writer, const gs::HandChanged& effect) {
  Record line(writer.at, writer.node, "hand");
  line.with("uav", effect.uav);
  if (!effect.hand.holder.empty()) line.with("holder", effect.hand.holder);
  if (!effect.hand.asker.empty()) line.with("asker", effect.hand.asker);
  return line;
}

Record line_of(const Writer& writer, const gs::LocalRequestAnswered& effect) {
  return translation::request_line(writer, effect.uav, effect.reply, effect.mode);
}

Record line_of(const Writer& writer, const gs::LocalSync& effect) {
  const bool sent = effect.direction == gs::SyncDirection::kSent;
  return translation::sync_line(writer, {effect.id, effect.from, effect.to, sent, effect.word});
}

Record line_of(const Writer& writer, const gs::HeldPlanChanged& effect) {
  return record(writer, "held")
      .with("uav", effect.uav)
      .with("tasks", static_cast<std::int64_t>(effect.tasks))
      .with("state", to_text(effect.state));
}

Record line_of(const Writer& writer, const gs::PerceptionLogged& effect) {
  return record(writer, "perception")
      .with("uav", effect.uav)
      .with("device", effect.device)
      .with("detections", static_cast<std::int64_t>(effect.detections));
}

Record line_of(const Writer& writer, const gs::StepDone& effect) {
  return record(writer, "step").with("name", effect.name);
}

Record line_of(const Writer& writer, const gs::OperatorDid& effect) {
  return record(writer, "operator").with("does", effect.does);
}

Record line_of(const Writer& writer, const gs::UavRestarted& effect) {
  return record(writer, "notice")
      .with("uav", effect.uav)
      .with("text", "restarted; " + std::to_string(effect.lost.size()) + " tasks lost");
}

Record line_of(const Writer& writer, const gs::Anomaly& effect) {
  return record(writer, "notice").with("text", effect.why);
}

Record line_of(const Writer& writer, const gs::TeamTokenChanged& effect) {
  return translation::token_line(writer, effect.held, effect.term);
}

}  // namespace skein::ground
