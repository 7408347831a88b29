// SPDX-License-Identifier: Apache-2.0
#include "skein/joint_lines/joint_lines.hpp"

#include <cmath>

#include "skein/foundation/joined.hpp"
#include "skein/foundation/whole.hpp"
#include "skein/journal/lines/joint.hpp"

namespace skein::joint_lines {

namespace lines = journal::lines;

namespace {

/// To the millisecond.
std::string text_of(double number) {
  if (std::isnan(number)) return "not a number";
  return to_text(Duration::milliseconds(whole(std::round(number * 1000))));
}

/// "heliv relay 12.5, marvin perceive 3".
std::string text_of(const interaction::Rows& rows) {
  std::vector<std::string> texts;
  for (const interaction::Row& row : rows) {
    std::string text = row.name + (row.text.empty() ? "" : " " + row.text);
    for (const double number : row.numbers) text += " " + text_of(number);
    texts.push_back(std::move(text));
  }
  return joined(texts, ", ");
}

}  // namespace

journal::Record line_of(const translation::Writer& writer, const std::string& uav,
                        const interaction::JointTaskStatus& status) {
  std::vector<std::string> holders;
  for (const auto& [holder, role] : status.holders) holders.push_back(holder + " " + role);
  lines::Joint line{.uav = uav,
                    .joint = status.subject,
                    .task = status.task,
                    .model = status.model,
                    .variant = status.variant,
                    .phase = to_text(status.phase),
                    .holders = joined(holders, ", "),
                    .blocks = joined(status.active_blocks, " "),
                    .violated = joined(status.violated, " "),
                    .why = status.why};
  if (const auto own = status.holders.find(status.uav); own != status.holders.end())
    line.role = own->second;
  if (status.agreed_start) line.start = status.agreed_start->to_seconds();
  return writer.record(std::move(line));
}

journal::Record line_of(const translation::Writer& writer, const std::string& uav,
                        const decision_node::ComponelChanged& changed) {
  return writer.record(lines::Role{.uav = uav,
                                   .joint = changed.subject,
                                   .role = changed.role,
                                   .componel = changed.componel,
                                   .state = to_text(changed.state),
                                   .block = changed.block,
                                   .because = changed.because});
}

journal::Record line_of(const translation::Writer& writer, const std::string& uav,
                        const decision_node::RoleTaskGiven& given) {
  return writer.record(lines::RoleTask{.uav = uav,
                                       .joint = given.subject,
                                       .role = given.role,
                                       .componel = given.componel,
                                       .block = given.block,
                                       .task = given.task.value(),
                                       .of = given.of.value(),
                                       .type = given.type,
                                       .because = given.because});
}

journal::Record line_of(const translation::Writer& writer, const std::string& uav,
                        const decision_node::PlaceComputed& computed) {
  lines::Place line{.uav = uav,
                    .joint = computed.subject,
                    .role = computed.role,
                    .parameter = computed.parameter,
                    .by = computed.initialiser,
                    .scms = joined(computed.scms, " "),
                    .why = computed.why};
  if (computed.at)
    line.position = journal::rounded(std::vector<double>(computed.at->begin(), computed.at->end()));
  return writer.record(std::move(line));
}

journal::Record line_of(const translation::Writer& writer, const std::string& uav,
                        const decision_node::ScmNoted& noted) {
  lines::Scm line{.uav = uav,
                  .joint = noted.subject,
                  .role = noted.role,
                  .scm = noted.found.report.scm,
                  .state = to_text(noted.found.report.finding)};
  if (noted.found.why) {
    line.place = noted.found.why->place;
    line.relation = to_text(noted.found.why->relation);
    line.measured = journal::rounded(noted.found.why->measured);
    line.required = journal::rounded(noted.found.why->required);
  }
  return writer.record(std::move(line));
}

journal::Record line_of(const translation::Writer& writer, const std::string& uav,
                        const decision_node::NegotiationNoted& noted) {
  return writer.record(lines::Negotiation{.uav = uav,
                                          .joint = noted.terms.subject,
                                          .modality = noted.terms.modality,
                                          .opener = noted.terms.opener,
                                          .opened = noted.terms.opened.to_seconds(),
                                          .state = noted.state,
                                          .rows = text_of(noted.rows),
                                          .why = noted.why,
                                          .unconfirmed = joined(noted.unconfirmed, ", ")});
}

}  // namespace skein::joint_lines
