// SPDX-License-Identifier: Apache-2.0
#include "link_json.hpp"

namespace skein::temporal {

namespace {

std::optional<NodeIndex> node_at(const JsonNode& node, std::string_view key,
                                 const NameTable& nodes) {
  const std::optional<JsonNode> named = node.at(key);
  if (!named) return std::nullopt;
  const std::optional<std::string> name = named->name();
  return name ? nodes.find(*name, named->place()) : std::nullopt;
}

std::optional<Ticks> bound_at(const JsonNode& node, std::string_view key, Ticks open) {
  const std::optional<JsonNode> bound = node.at(key);
  return bound ? bound->bound(open) : std::nullopt;
}

}  // namespace

std::optional<Arc> arc_from(const JsonNode& node, const NameTable& nodes) {
  if (!node.is_object_of({"from", "to", "min", "max"})) return std::nullopt;
  const std::optional<NodeIndex> from = node_at(node, "from", nodes);
  const std::optional<NodeIndex> to = node_at(node, "to", nodes);
  const std::optional<Ticks> min = bound_at(node, "min", kMinusInfinite);
  const std::optional<Ticks> max = bound_at(node, "max", kInfinite);
  if (!from || !to || !min || !max) return std::nullopt;
  return Arc{*from, *to, *min, *max};
}

std::string arc_text(const Arc& arc, const std::vector<std::string>& nodes) {
  return R"({"from": )" + json_string(nodes[arc.from]) + R"(, "to": )" +
         json_string(nodes[arc.to]) + R"(, "min": )" + json_bound(arc.min) + R"(, "max": )" +
         json_bound(arc.max) + "}";
}

std::string lines_text(const std::vector<std::string>& elements) {
  if (elements.empty()) return "[]";
  std::string text = "[";
  for (const std::string& element : elements) {
    text += (text.size() > 1 ? ",\n    " : "\n    ") + element;
  }
  return text + "\n  ]";
}

}  // namespace skein::temporal
