// SPDX-License-Identifier: Apache-2.0
#include "drops.hpp"

namespace skein::blackboard {
namespace {

/// "tasks[12].state" -> "tasks[].state": one kind, whatever the element.
std::string without_indices(const std::string& field) {
  std::string kind;
  bool inside = false;
  for (const char c : field) {
    if (c == ']') inside = false;
    if (!inside) kind.push_back(c);
    if (c == '[') inside = true;
  }
  return kind;
}

}  // namespace

void Drops::tell(wire::Slot slot, const wire::SampleHeader& header,
                 const wire::Violation& violation, std::vector<Incoming>& out) {
  const NodeNumber origin(header.origin);
  const auto count = times_.count({slot, origin, without_indices(violation.field)});
  out.emplace_back(Dropped{slot, origin, violation.field, violation.why + count.value_or(""),
                           count.has_value()});
}

}  // namespace skein::blackboard
