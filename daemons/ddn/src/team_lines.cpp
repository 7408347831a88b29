// SPDX-License-Identifier: Apache-2.0
#include "team_lines.hpp"

#include "skein/translation/team_lines.hpp"

namespace skein::ddn {

journal::Record line_of(const translation::Writer& writer,
                        const decision_node::TeamTaskNoted& noted) {
  journal::Record line(writer.at, writer.node, "team-task");
  line.with("uav", writer.node)
      .with("task", static_cast<std::int64_t>(noted.claim.task.value()))
      .with("sale", noted.claim.sale)
      .with("state", noted.state)
      .with("goal", noted.goal.value())
      .with("statement", noted.statement);
  if (!noted.why.empty()) line.with("why", noted.why);
  return line;
}

journal::Record line_of(const translation::Writer& writer, const decision_node::BidNoted& noted) {
  journal::Record line(writer.at, writer.node, "bid");
  line.with("uav", writer.node)
      .with("task", static_cast<std::int64_t>(noted.claim.task.value()))
      .with("sale", noted.claim.sale);
  if (noted.added) line.with("added", journal::rounded(*noted.added));
  if (!noted.objection.empty()) line.with("why", noted.objection);
  return line;
}

journal::Record line_of(const translation::Writer& writer, const decision_node::TokenNoted& noted) {
  return translation::token_line(writer, noted.held, noted.term);
}

}  // namespace skein::ddn
