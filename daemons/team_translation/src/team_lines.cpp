// SPDX-License-Identifier: Apache-2.0
#include "skein/team_translation/team_lines.hpp"

#include "skein/foundation/joined.hpp"
#include "skein/foundation/overloaded.hpp"
#include "skein/journal/lines/team.hpp"

namespace skein::translation {

namespace {

namespace lines = journal::lines;
using Lines = std::vector<journal::Record>;

std::string names_of(const std::vector<auction::MemberNumber>& members,
                     const team::Roster& roster) {
  std::vector<std::string> names;
  for (const auction::MemberNumber member : members) names.push_back(roster.name_of(member));
  return joined(names, ", ");
}

Lines lines_of(const Writer& writer, const auction::Sold& sold, const team::Roster& roster) {
  lines::Sale line{.state = sold.trade ? "traded" : "sold",
                   .task = sold.task.value(),
                   .to = names_of(sold.members, roster),
                   .value = journal::rounded(sold.value.first)};
  if (sold.next_best) {
    line.next_best = names_of(sold.next_best->members, roster);
    line.next_value = journal::rounded(sold.next_best->value.first);
  } else {
    line.why = "nobody else could";
  }
  return {writer.record(std::move(line))};
}

Lines lines_of(const Writer& writer, const auction::Unsold& unsold, const team::Roster& roster) {
  std::vector<std::string> reasons;
  if (!unsold.together.empty()) reasons.push_back(unsold.together);
  for (const auto& [member, why] : unsold.reasons) {
    reasons.push_back(roster.name_of(member) + ": " + why);
  }
  return {writer.record(
      lines::Sale{.state = "unsold", .task = unsold.task.value(), .why = joined(reasons, "; ")})};
}

Lines lines_of(const Writer& writer, const auction::Dropped& dropped, const team::Roster& roster) {
  return {writer.record(
      lines::Sale{.state = "dropped", .uav = roster.name_of(dropped.member), .why = dropped.why})};
}

Lines lines_of(const Writer& writer, const auction::Rejected& rejected) {
  Lines all;
  for (const auction::Contradiction& one : rejected.contradictions) {
    std::vector<std::string> chain;
    for (const auction::TaskNumber task : one.chain) chain.push_back(to_text(task));
    all.push_back(writer.record(
        lines::Sale{.state = "rejected", .tasks = joined(chain, " "), .why = one.why}));
  }
  return all;
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
  return writer.record(lines::Owner{.task = standing.task.value(),
                                    .statement = standing.statement,
                                    .stage = team::to_text(standing.stage),
                                    .sale = standing.sale,
                                    .owners = joined(standing.owners, ", "),
                                    .why = standing.why});
}

journal::Record token_line(const Writer& writer, bool held, std::uint64_t term) {
  lines::Token line{.uav = writer.node, .state = held ? "taken" : "lost"};
  if (held) line.term = term;
  return writer.record(std::move(line));
}

}  // namespace skein::translation
