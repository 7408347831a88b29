// SPDX-License-Identifier: Apache-2.0
#include "skein/translation/team_lines.hpp"

#include "skein/foundation/joined.hpp"
#include "skein/foundation/overloaded.hpp"

namespace skein::translation {

namespace {

using Lines = std::vector<journal::Record>;

std::string names_of(const std::vector<auction::MemberNumber>& members,
                     const team::Roster& roster) {
  std::vector<std::string> names;
  for (const auction::MemberNumber member : members) names.push_back(roster.name_of(member));
  return joined(names, ", ");
}

journal::Record told(const Writer& writer, const char* state) {
  return journal::Record(writer.at, writer.node, "sale").with("state", state);
}

Lines lines_of(const Writer& writer, const auction::Sold& sold, const team::Roster& roster) {
  journal::Record line = told(writer, sold.trade ? "traded" : "sold");
  line.with("task", static_cast<std::int64_t>(sold.task.value()))
      .with("to", names_of(sold.members, roster))
      .with("value", journal::rounded(sold.value.first));
  if (!sold.next_best) return {line.with("why", "nobody else could")};
  line.with("next_best", names_of(sold.next_best->members, roster))
      .with("next_value", journal::rounded(sold.next_best->value.first));
  return {line};
}

Lines lines_of(const Writer& writer, const auction::Unsold& unsold, const team::Roster& roster) {
  std::vector<std::string> reasons;
  if (!unsold.together.empty()) reasons.push_back(unsold.together);
  for (const auto& [member, why] : unsold.reasons) {
    reasons.push_back(roster.name_of(member) + ": " + why);
  }
  return {told(writer, "unsold")
              .with("task", static_cast<std::int64_t>(unsold.task.value()))
              .with("why", joined(reasons, "; "))};
}

Lines lines_of(const Writer& writer, const auction::Dropped& dropped, const team::Roster& roster) {
  return {
      told(writer, "dropped").with("uav", roster.name_of(dropped.member)).with("why", dropped.why)};
}

Lines lines_of(const Writer& writer, const auction::Rejected& rejected) {
  Lines lines;
  for (const auction::Contradiction& one : rejected.contradictions) {
    std::vector<std::string> chain;
    for (const auction::TaskNumber task : one.chain) chain.push_back(to_text(task));
    lines.push_back(
        told(writer, "rejected").with("tasks", joined(chain, " ")).with("why", one.why));
  }
  return lines;
}

}  // namespace

Lines sale_lines(const Writer& writer, const auction::SaleEffect& effect,
                 const team::Roster& roster) {
  return std::visit(
      Overloaded{[&](const auction::Sold& it) { return lines_of(writer, it, roster); },
                 [&](const auction::Unsold& it) { return lines_of(writer, it, roster); },
                 [&](const auction::Dropped& it) { return lines_of(writer, it, roster); },
                 [&](const auction::Rejected& it) { return lines_of(writer, it); },
                 [](const auto&) { return Lines(); }},
      effect);
}

journal::Record owner_line(const Writer& writer, const team::TaskStanding& standing) {
  journal::Record line(writer.at, writer.node, "owner");
  line.with("task", standing.task.value())
      .with("statement", standing.statement)
      .with("stage", team::to_text(standing.stage))
      .with("sale", standing.sale);
  if (!standing.owners.empty()) line.with("owners", joined(standing.owners, ", "));
  if (!standing.why.empty()) line.with("why", standing.why);
  return line;
}

journal::Record token_line(const Writer& writer, bool held, std::uint64_t term) {
  journal::Record line(writer.at, writer.node, "token");
  line.with("uav", writer.node).with("state", held ? "taken" : "lost");
  if (held) line.with("term", term);
  return line;
}

}  // namespace skein::translation
