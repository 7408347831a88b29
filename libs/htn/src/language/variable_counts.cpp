// SPDX-License-Identifier: Apache-2.0
#include "language/variable_counts.hpp"

#include <algorithm>

namespace skein::htn {

// The nodes inside a list stand right behind it.
void VariableCounts::add(const ReadContext& context, Expression part) {
  if (!part) return;
  const std::vector<Node>& nodes = part.document->nodes;
  const std::uint32_t end = (*part).end;
  for (NodeIndex at = part.node; at < nodes.size() && nodes[at].begin < end; ++at) {
    const Expression here{part.document, at};
    if (!context.is_variable(here)) continue;
    if (context.store.name(nodes[at].atom).starts_with("?_")) continue;
    Entry& entry = entries_[nodes[at].atom.bits()];
    if (entry.count++ == 0) entry.first = here;
  }
}

void warn_singletons(const ReadContext& context, const VariableCounts& counts,
                     const std::vector<const VariableCounts*>& others, const std::string& where) {
  if (!context.singletons) return;
  std::vector<Expression> once;
  for (const auto& [bits, entry] : counts.entries()) {
    if (entry.count > 1) continue;
    const Term variable = (*entry.first).atom;
    if (std::none_of(others.begin(), others.end(),
                     [variable](const auto* other) { return other->has(variable); })) {
      once.push_back(entry.first);
    }
  }
  if (once.empty()) return;
  std::sort(once.begin(), once.end(), [](Expression a, Expression b) { return a.node < b.node; });
  std::string names;
  for (const Expression variable : once) {
    names += (names.empty() ? "" : ", ") + context.name(variable);
  }
  context.warn(
      once.front(),
      (once.size() == 1 ? "variable " : "variables ") + names + " used only once in " + where,
      "a second use, or a name that begins with ?_");
}

}  // namespace skein::htn
