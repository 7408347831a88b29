// SPDX-License-Identifier: Apache-2.0
#include "skein/negotiation/terms.hpp"

#include <algorithm>
#include <cmath>

namespace skein::interaction {

namespace {

bool finite(const Row& row) {
  return std::all_of(row.numbers.begin(), row.numbers.end(),
                     [](double one) { return std::isfinite(one); });
}

}  // namespace

std::string to_text(const SessionId& id) {
  return id.subject + " of " + id.opener + " at " + to_text(id.opened);
}

std::vector<std::string> problems_of(const Terms& terms) {
  std::vector<std::string> problems;
  const auto& members = terms.members;
  if (terms.subject.empty()) problems.push_back("no subject");
  if (members.size() < 2 || members.size() > kMostMembers) {
    problems.push_back(std::to_string(members.size()) + " members, not from 2 to " +
                       std::to_string(kMostMembers));
  }
  if (std::adjacent_find(members.begin(), members.end(), std::greater_equal<>()) != members.end()) {
    problems.push_back("members out of order, or there twice");
  }
  if (std::find(members.begin(), members.end(), terms.opener) == members.end()) {
    problems.push_back("opened by '" + terms.opener + "', who is no member");
  }
  if (terms.deadline <= terms.opened) problems.push_back("its deadline is not after its opening");
  if (!std::all_of(terms.parameters.begin(), terms.parameters.end(), finite)) {
    problems.push_back("a figure of its parameters is not finite");
  }
  return problems;
}

std::string_view to_text(NegotiationOutcome::Kind kind) {
  constexpr std::string_view kNames[] = {"agreed", "failed", "undecided"};
  return kNames[static_cast<std::size_t>(kind)];
}

}  // namespace skein::interaction
