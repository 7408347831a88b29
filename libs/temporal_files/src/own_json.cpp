// SPDX-License-Identifier: Apache-2.0
// Our own format of STN and STNU.
#include <algorithm>

#include "link_json.hpp"
#include "readers.hpp"

namespace skein::temporal {

namespace {

constexpr const char* kDefaultOrigin = "v0";

NameTable names_from(const JsonNode& root, Problems& problems) {
  NameTable nodes("node", problems);
  const std::optional<JsonNode> list = root.at("nodes");
  if (!list) return nodes;
  for (const JsonNode& one : list->items()) {
    if (const std::optional<std::string> name = one.name()) nodes.add(*name, one.place());
  }
  return nodes;
}

NodeIndex origin_from(const JsonNode& root, const NameTable& nodes, Problems& problems) {
  const std::optional<JsonNode> given = root.find("origin");
  if (given) {
    const std::optional<std::string> name = given->name();
    return name ? nodes.find(*name, given->place()).value_or(0) : 0;
  }
  const std::optional<std::uint32_t> found = nodes.find(kDefaultOrigin);
  if (!found) {
    problems.add(root.place(), "no origin", R"("origin": the name of a node, or a node "v0")");
  }
  return found.value_or(0);
}

}  // namespace

Stnu read_own_json(const JsonNode& root, Problems& problems) {
  Stnu network;
  root.is_object_of({"origin", "nodes", "arcs", "contingent", "agents"});
  NameTable nodes = names_from(root, problems);
  network.origin = origin_from(root, nodes, problems);
  LinkTable links(nodes, problems);
  links.set_origin(network.origin);
  if (const std::optional<JsonNode> arcs = root.at("arcs")) {
    for (const JsonNode& one : arcs->items()) {
      if (const std::optional<Arc> arc = arc_from(one, nodes)) links.add(*arc, one.place());
    }
  }
  if (const std::optional<JsonNode> contingent = root.find("contingent")) {
    for (const JsonNode& one : contingent->items()) {
      const std::optional<Arc> arc = arc_from(one, nodes);
      if (arc) links.add(ContingentLink{arc->from, arc->to, arc->min, arc->max}, one.place());
    }
  }
  network.nodes = nodes.names();
  network.arcs = links.take_arcs();
  network.contingent = links.take_contingent();
  return network;
}

std::string write_own_json(const Stnu& network) {
  std::vector<std::string> nodes;
  for (const std::string& name : network.nodes) nodes.push_back(json_string(name));
  std::vector<std::string> arcs;
  for (const Arc& arc : network.arcs) arcs.push_back(arc_text(arc, network.nodes));
  std::vector<std::string> contingent;
  for (const ContingentLink& link : network.contingent) {
    contingent.push_back(
        arc_text({link.activation, link.contingent, link.min, link.max}, network.nodes));
  }
  std::string text = "{\n  \"origin\": " + json_string(network.nodes[network.origin]);
  text += ",\n  \"nodes\": " + lines_text(nodes) + ",\n  \"arcs\": " + lines_text(arcs);
  if (!contingent.empty()) text += ",\n  \"contingent\": " + lines_text(contingent);
  return text + "\n}\n";
}

}  // namespace skein::temporal
