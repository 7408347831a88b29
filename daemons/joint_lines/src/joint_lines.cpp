// SPDX-License-Identifier: Apache-2.0
#include "skein/joint_lines/joint_lines.hpp"

#include "skein/foundation/joined.hpp"

namespace skein::joint_lines {

namespace {

void with_text(journal::Record& line, const char* key, const std::string& text) {
  if (!text.empty()) line.with(key, text);
}

/// "heliv relay 12.5, marvin perceive 3".
std::string text_of(const interaction::Rows& rows) {
  std::vector<std::string> texts;
  for (const interaction::Row& row : rows) {
    std::string text = row.name + (row.text.empty() ? "" : " " + row.text);
    for (const double number : row.numbers) {
      text += " " + to_text(Duration::milliseconds(std::llround(number * 1000)));
    }
    texts.push_back(std::move(text));
  }
  return joined(texts, ", ");
}

}  // namespace

journal::Record line_of(const translation::Writer& writer, const std::string& uav,
                        const interaction::JointTaskStatus& status) {
  journal::Record line(writer.at, writer.node, "joint");
  line.with("uav", uav).with("joint", status.subject);
  line.with("task", status.task).with("model", status.model).with("variant", status.variant);
  line.with("phase", to_text(status.phase));
  if (const auto own = status.holders.find(status.uav); own != status.holders.end()) {
    line.with("role", own->second);
  }
  std::vector<std::string> holders;
  for (const auto& [holder, role] : status.holders) holders.push_back(holder + " " + role);
  with_text(line, "holders", joined(holders, ", "));
  with_text(line, "blocks", joined(status.active_blocks, " "));
  with_text(line, "violated", joined(status.violated, " "));
  if (status.agreed_start) line.with("start", status.agreed_start->to_seconds());
  with_text(line, "why", status.why);
  return line;
}

journal::Record line_of(const translation::Writer& writer, const std::string& uav,
                        const decision_node::ComponelChanged& changed) {
  journal::Record line(writer.at, writer.node, "role");
  line.with("uav", uav).with("joint", changed.subject);
  line.with("role", changed.role)
      .with("componel", changed.componel)
      .with("state", to_text(changed.state))
      .with("block", changed.block);
  with_text(line, "because", changed.because);
  return line;
}

journal::Record line_of(const translation::Writer& writer, const std::string& uav,
                        const decision_node::RoleTaskGiven& given) {
  journal::Record line(writer.at, writer.node, "role-task");
  line.with("uav", uav).with("joint", given.subject);
  line.with("role", given.role)
      .with("componel", given.componel)
      .with("block", given.block)
      .with("task", given.task.value())
      .with("of", given.of.value())
      .with("type", given.type);
  with_text(line, "because", given.because);
  return line;
}

journal::Record line_of(const translation::Writer& writer, const std::string& uav,
                        const decision_node::PlaceComputed& computed) {
  journal::Record line(writer.at, writer.node, "place");
  line.with("uav", uav).with("joint", computed.subject);
  line.with("role", computed.role)
      .with("parameter", computed.parameter)
      .with("by", computed.initialiser);
  if (computed.at) {
    line.with("position",
              journal::rounded(std::vector<double>(computed.at->begin(), computed.at->end())));
  }
  with_text(line, "scms", joined(computed.scms, " "));
  with_text(line, "why", computed.why);
  return line;
}

journal::Record line_of(const translation::Writer& writer, const std::string& uav,
                        const decision_node::ScmNoted& noted) {
  journal::Record line(writer.at, writer.node, "scm");
  line.with("uav", uav).with("joint", noted.subject);
  line.with("role", noted.role)
      .with("scm", noted.found.report.scm)
      .with("state", to_text(noted.found.report.finding));
  if (noted.found.why) {
    line.with("place", noted.found.why->place)
        .with("relation", to_text(noted.found.why->relation))
        .with("measured", journal::rounded(noted.found.why->measured))
        .with("required", journal::rounded(noted.found.why->required));
  }
  return line;
}

journal::Record line_of(const translation::Writer& writer, const std::string& uav,
                        const decision_node::NegotiationNoted& noted) {
  journal::Record line(writer.at, writer.node, "negotiation");
  line.with("uav", uav).with("joint", noted.terms.subject);
  line.with("modality", noted.terms.modality)
      .with("opener", noted.terms.opener)
      .with("opened", noted.terms.opened.to_seconds())
      .with("state", noted.state);
  with_text(line, "rows", text_of(noted.rows));
  with_text(line, "why", noted.why);
  with_text(line, "unconfirmed", joined(noted.unconfirmed, ", "));
  return line;
}

}  // namespace skein::joint_lines
