// SPDX-License-Identifier: Apache-2.0
#include "skein/node/agreement.hpp"

#include <algorithm>
#include <utility>

#include "skein/blackboard/program_description.hpp"
#include "skein/foundation/joined.hpp"

namespace skein::node {

namespace {

using wire::Role;

bool flies(Role role) {
  return role == Role::kGround || role == Role::kDdn || role == Role::kSim ||
         role == Role::kFunctional;
}

}  // namespace

Agreement::Agreement(const Roster& roster, const Member& self, SectionPrints own,
                     Descriptions descriptions)
    : roster_(roster),
      self_(self.number),
      own_(std::move(own)),
      descriptions_(std::move(descriptions)) {}

std::optional<std::string> Agreement::difference(NodeNumber node) const {
  const Member* member = roster_.find(node);
  return member == nullptr ? std::nullopt : difference(*member);
}

std::optional<std::string> Agreement::difference(const Member& member) const {
  if (own_.empty() || member.number == self_ || !flies(member.role)) return std::nullopt;
  const auto description = descriptions_(member.name);
  if (!description) return std::nullopt;
  const auto program = blackboard::parse_program_description(*description);
  if (!program || program->scenario.empty()) {
    if (member.role == Role::kFunctional) return std::nullopt;
    return "is not known: its program does not say it" +
           (program ? " (skein " + program->version + ")" : std::string());
  }
  const auto sections = own_.differing(program->scenario);
  if (!sections) return "cannot be compared: it is of skein " + program->version;
  if (sections->empty()) return std::nullopt;
  return "differs in " + joined(*sections, ", ");
}

std::string Agreement::differences() const {
  return sentence([](const Member&) { return true; });
}

// Who differs in the same way is named together.
std::string Agreement::sentence(const std::function<bool(const Member&)>& of) const {
  std::vector<std::pair<std::string, std::string>> groups;
  for (const Member& member : roster_.members()) {
    if (!of(member)) continue;
    const auto how = difference(member);
    if (!how) continue;
    const auto same = std::ranges::find(groups, *how, &std::pair<std::string, std::string>::first);
    if (same != groups.end()) {
      same->second += ", " + member.name;
    } else {
      groups.emplace_back(*how, member.name);
    }
  }
  std::string text;
  for (const auto& [how, names] : groups)
    text += (text.empty() ? "the scenario of " : "; that of ") + names + " " + how;
  return text;
}

MissionTime Agreement::latest(const Times& heard) const {
  MissionTime latest;
  for (const auto& [node, time] : heard)
    if (time > latest && agrees(node)) latest = time;
  return latest;
}

std::optional<std::string> Agreement::refusal(const Times& heard) const {
  const std::string those = sentence([&](const Member& member) {
    const auto time = heard.find(member.number);
    return time != heard.end() && time->second > MissionTime();
  });
  if (those.empty()) return std::nullopt;
  return "a mission is under way, and " + those + ": this node takes no part in it";
}

}  // namespace skein::node
