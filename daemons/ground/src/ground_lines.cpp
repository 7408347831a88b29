// SPDX-License-Identifier: Apache-2.0
#include "ground_lines.hpp"

#include "skein/journal/lines/mission.hpp"
#include "skein/team_translation/team_lines.hpp"

namespace skein::ground {

namespace {

namespace gs = ground_station;
namespace lines = journal::lines;
using journal::Record;
using translation::Writer;

}  // namespace

Record line_of(const Writer& writer, const gs::OperatorAsked& effect) {
  return writer.record(lines::Asked{.who = effect.who,
                                    .number = effect.number,
                                    .what = effect.what,
                                    .accepted = effect.accepted,
                                    .why = effect.why});
}

Record line_of(const Writer& writer, const gs::HandChanged& effect) {
  return writer.record(
      lines::Hand{.uav = effect.uav, .holder = effect.hand.holder, .asker = effect.hand.asker});
}

Record line_of(const Writer& writer, const gs::LocalRequestAnswered& effect) {
  return translation::request_line(writer, effect.uav, effect.reply, effect.mode);
}

Record line_of(const Writer& writer, const gs::LocalSync& effect) {
  const bool sent = effect.direction == gs::SyncDirection::kSent;
  return translation::sync_line(writer, {effect.id, effect.from, effect.to, sent, effect.word});
}

Record line_of(const Writer& writer, const gs::HeldPlanChanged& effect) {
  return writer.record(
      lines::Held{.uav = effect.uav, .tasks = effect.tasks, .state = to_text(effect.state)});
}

Record line_of(const Writer& writer, const gs::PerceptionLogged& effect) {
  return writer.record(lines::Perception{
      .uav = effect.uav, .device = effect.device, .detections = effect.detections});
}

Record line_of(const Writer& writer, const gs::StepDone& effect) {
  return writer.record(lines::Step{effect.name});
}

Record line_of(const Writer& writer, const gs::OperatorDid& effect) {
  return writer.record(lines::Operator{effect.does});
}

Record line_of(const Writer& writer, const gs::UavRestarted& effect) {
  return writer.record(
      lines::Notice{.uav = effect.uav,
                    .text = "restarted; " + std::to_string(effect.lost.size()) + " tasks lost"});
}

Record line_of(const Writer& writer, const gs::Anomaly& effect) {
  return writer.record(lines::Notice{.text = effect.why});
}

Record line_of(const Writer& writer, const gs::TeamTokenChanged& effect) {
  return translation::token_line(writer, effect.held, effect.term);
}

}  // namespace skein::ground
