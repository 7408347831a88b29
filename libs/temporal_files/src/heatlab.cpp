// SPDX-License-Identifier: Apache-2.0
// The JSON of the HEATlab (Harvey Mudd) and MIT tools: nodes by number, 0 is the origin.
#include <algorithm>

#include "link_json.hpp"
#include "readers.hpp"

namespace skein::temporal {

namespace {

constexpr const char* kOrigin = "0";

// Numbers as names; nothing, and a problem, for what is neither a whole number nor a name.
std::optional<std::string> name_from(const JsonNode& node) {
  const std::string& text = node.value().text;
  if (node.value().kind != JsonKind::kNumber) return node.name();
  if (text.size() <= 18 && text.find_first_not_of("0123456789") == std::string::npos) return text;
  node.wrong(in_quotes(text) + " is not a node", "a whole number or a name");
  return std::nullopt;
}

std::optional<Ticks> duration_from(const JsonNode& node, Problems& problems) {
  const JsonValue& value = node.value();
  if (value.kind == JsonKind::kString) {
    if (value.text == "inf" || value.text == "+inf") return kInfinite;
    if (value.text == "-inf") return kMinusInfinite;
    node.wrong(in_quotes(value.text) + " is not a duration", R"(a number, "inf" or "-inf")");
    return std::nullopt;
  }
  if (value.kind != JsonKind::kNumber) {
    node.wrong_kind(R"(a number, "inf" or "-inf")");
    return std::nullopt;
  }
  const Result<Ticks, BadSeconds> ticks = seconds_from(value.text, BelowNanosecond::kRound);
  if (ticks) return *ticks;
  add_bad_seconds(problems, node.place(), value.text, ticks.error());
  return std::nullopt;
}

std::optional<Ticks> duration_at(const JsonNode& node, std::string_view key, Ticks impossible,
                                 Problems& problems) {
  const std::optional<JsonNode> given = node.at(key);
  if (!given) return std::nullopt;
  const std::optional<Ticks> ticks = duration_from(*given, problems);
  if (ticks != impossible) return ticks;
  given->wrong("no duration satisfies this bound");
  return std::nullopt;
}

std::optional<Arc> bounds_from(const JsonNode& node, std::string_view min_key,
                               std::string_view max_key, Problems& problems) {
  const std::optional<Ticks> min = duration_at(node, min_key, kInfinite, problems);
  const std::optional<Ticks> max = duration_at(node, max_key, kMinusInfinite, problems);
  if (!min || !max) return std::nullopt;
  return Arc{0, 0, *min, *max};
}

// "min_domain" and "max_domain", if given, bound the date of a node.
void read_domain(const JsonNode& node, const std::string& name, NameTable& nodes, LinkTable& links,
                 Problems& problems) {
  if (!node.has("min_domain") && !node.has("max_domain")) return;
  std::optional<Arc> arc = bounds_from(node, "min_domain", "max_domain", problems);
  if (!arc || (arc->min == kMinusInfinite && arc->max == kInfinite)) return;
  arc->from = nodes.find_or_add(kOrigin);
  arc->to = nodes.find_or_add(name);
  links.add(*arc, node.place());
}

std::optional<NodeIndex> end_at(const JsonNode& node, std::string_view key, NameTable& nodes) {
  const std::optional<JsonNode> end = node.at(key);
  const std::optional<std::string> name = end ? name_from(*end) : std::nullopt;
  if (!name) return std::nullopt;
  return nodes.find_or_add(*name);
}

void read_constraint(const JsonNode& node, NameTable& nodes, LinkTable& links, Problems& problems) {
  if (!node.is_object()) return;
  const std::optional<NodeIndex> first = end_at(node, "first_node", nodes);
  const std::optional<NodeIndex> second = end_at(node, "second_node", nodes);
  const std::optional<Arc> bounds = bounds_from(node, "min_duration", "max_duration", problems);
  const std::optional<JsonNode> type = node.at("type");
  if (!first || !second || !bounds || !type) return;
  if (type->value().text == "stc") {
    links.add(Arc{*first, *second, bounds->min, bounds->max}, node.place());
  } else if (type->value().text == "stcu") {
    links.add(ContingentLink{*first, *second, bounds->min, bounds->max}, node.place());
  } else {
    problems.add(type->place(), "unknown type " + in_quotes(type->value().text),
                 R"("stc" or "stcu")");
  }
}

// A name that is a number without a sign or leading zeros is written as one.
std::string id_text(const std::string& name) {
  const bool number = name.size() <= 18 && (name == "0" || !name.starts_with('0')) &&
                      name.find_first_not_of("0123456789") == std::string::npos;
  return number ? name : json_string(name);
}

std::string duration_text(Ticks ticks) {
  if (ticks == kInfinite) return R"("inf")";
  return ticks == kMinusInfinite ? R"("-inf")" : seconds_text(ticks);
}

std::string constraint_text(const Arc& arc, const char* type,
                            const std::vector<std::string>& names) {
  return R"({"first_node": )" + id_text(names[arc.from]) + R"(, "second_node": )" +
         id_text(names[arc.to]) + R"(, "type": ")" + type + R"(", "min_duration": )" +
         duration_text(arc.min) + R"(, "max_duration": )" + duration_text(arc.max) + "}";
}

}  // namespace

Stnu read_heatlab(const JsonNode& root, Problems& problems) {
  NameTable nodes("node", problems);
  LinkTable links(nodes, problems, LinkRules::kOthers);
  std::vector<std::pair<JsonNode, std::string>> declared;
  if (const std::optional<JsonNode> list = root.find("nodes")) {
    for (const JsonNode& one : list->items()) {
      if (!one.is_object()) continue;
      const std::optional<JsonNode> id = one.at("node_id");
      const std::optional<std::string> name = id ? name_from(*id) : std::nullopt;
      if (!name) continue;
      nodes.add(*name, id->place());
      declared.emplace_back(one, *name);
    }
  }
  for (const auto& [node, name] : declared) read_domain(node, name, nodes, links, problems);
  if (const std::optional<JsonNode> list = root.at("constraints")) {
    for (const JsonNode& one : list->items()) read_constraint(one, nodes, links, problems);
  }
  Stnu network{nodes.names(), 0, links.take_arcs(), links.take_contingent()};
  choose_origin(network, kOrigin);
  for (const ContingentLink& link : network.contingent) {
    if (link.contingent == network.origin) {
      problems.add(root.place(), "a contingent link ends in the origin '0'");
    }
  }
  return network;
}

Result<std::string, Failure> write_heatlab(const Stnu& network) {
  const Result<std::vector<std::string>, Failure> names = names_with_origin(network, kOrigin);
  if (!names) return tl::unexpected(names.error());
  std::vector<std::string> nodes;
  std::vector<std::string> constraints;
  for (const std::string& name : *names) nodes.push_back(R"({"node_id": )" + id_text(name) + "}");
  for (const Arc& arc : network.arcs) constraints.push_back(constraint_text(arc, "stc", *names));
  for (const ContingentLink& link : network.contingent) {
    constraints.push_back(
        constraint_text({link.activation, link.contingent, link.min, link.max}, "stcu", *names));
  }
  return "{\n  \"nodes\": " + lines_text(nodes) +
         ",\n  \"constraints\": " + lines_text(constraints) + "\n}\n";
}

}  // namespace skein::temporal
