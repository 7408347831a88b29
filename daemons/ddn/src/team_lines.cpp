// SPDX-License-Identifier: Apache-2.0
#include "team_lines.hpp"

#include "skein/journal/lines/team.hpp"

#include "skein/team_translation/team_lines.hpp"

namespace skein::ddn {

journal::Record line_of(const translation::Writer& writer,
                        const decision_node::TeamTaskNoted& noted) {
  return writer.record(journal::lines::TeamTask{.uav = writer.node,
                                                .task = noted.claim.task.value(),
                                                .sale = noted.claim.sale,
                                                .state = noted.state,
                                                .goal = noted.goal.value(),
                                                .statement = noted.statement,
                                                .why = noted.why});
}

journal::Record line_of(const translation::Writer& writer, const decision_node::BidNoted& noted) {
  journal::lines::Bid line{.uav = writer.node,
                           .task = noted.claim.task.value(),
                           .sale = noted.claim.sale,
                           .why = noted.objection};
  if (noted.added) line.added = journal::rounded(*noted.added);
  return writer.record(std::move(line));
}

journal::Record line_of(const translation::Writer& writer, const decision_node::TokenNoted& noted) {
  return translation::token_line(writer, noted.held, noted.term);
}

}  // namespace skein::ddn
