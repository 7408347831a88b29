// SPDX-License-Identifier: Apache-2.0
#include "skein/temporal_files/link_changes.hpp"

#include "link_json.hpp"

namespace skein::temporal {

namespace {

std::vector<Arc> changes_from(const JsonNode& root, const NameTable& nodes, Problems& problems) {
  std::vector<Arc> changes;
  for (const JsonNode& one : root.items()) {
    const std::optional<Arc> arc = arc_from(one, nodes);
    if (!arc) continue;
    // A table for each: the same two nodes may come as often as wanted.
    LinkTable link(nodes, problems);
    link.add(*arc, one.place());
    changes.push_back(*arc);
  }
  return changes;
}

}  // namespace

Result<std::vector<Arc>, Diagnostics> read_changes(std::string_view text, const Stnu& network,
                                                   const std::string& file) {
  Problems problems(file);
  NameTable nodes("node", problems);
  for (const std::string& name : network.nodes) nodes.add(name, {});
  std::vector<Arc> changes;
  if (const std::optional<JsonValue> value = parse_json(text, problems)) {
    changes = changes_from(JsonNode(*value, "", problems), nodes, problems);
  }
  if (!problems.none()) return tl::unexpected(problems.take());
  return changes;
}

}  // namespace skein::temporal
