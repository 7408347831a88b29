// SPDX-License-Identifier: Apache-2.0
// The multi-agent format of spec 5.5.
#include <algorithm>

#include "link_json.hpp"
#include "readers.hpp"
#include "skein/temporal_files/network_text.hpp"

namespace skein::temporal {

namespace {

constexpr const char* kOrigin = "v0";

/// A declared node whose owner is still a name.
struct DeclaredNode {
  std::string name;
  std::string owner;
  Place place;  ///< of the declaration
  Place owner_place;
};

NameTable agents_from(const JsonNode& root, Problems& problems) {
  NameTable agents("agent", problems);
  const std::optional<JsonNode> list = root.at("agents");
  if (!list) return agents;
  for (const JsonNode& one : list->items()) {
    if (const std::optional<std::string> name = one.name()) agents.add(*name, one.place());
  }
  return agents;
}

std::optional<DeclaredNode> declared_from(const JsonNode& node) {
  if (!node.is_object_of({"name", "agent"})) return std::nullopt;
  const std::optional<JsonNode> name_node = node.at("name");
  const std::optional<JsonNode> owner_node = node.at("agent");
  if (!name_node || !owner_node) return std::nullopt;
  const std::optional<std::string> name = name_node->name();
  const std::optional<std::string> owner = owner_node->name();
  if (!name || !owner) return std::nullopt;
  if (*name == kOrigin) {
    name_node->wrong("'v0' is the origin: nobody owns it and it is not declared");
    return std::nullopt;
  }
  return DeclaredNode{*name, *owner, name_node->place(), owner_node->place()};
}

// The message for a node whose owner is no agent but a node: whom one owner after the other leads
// to.
std::string owned_by_node(const DeclaredNode& node, const std::vector<DeclaredNode>& all,
                          const NameTable& nodes) {
  std::string chain = in_quotes(node.name);
  const DeclaredNode* at = &node;
  for (std::size_t steps = 0; steps <= all.size(); ++steps) {
    const std::optional<std::uint32_t> next = nodes.find(at->owner);
    if (!next || *next == 0) break;
    if (steps < 8) chain += " → " + in_quotes(at->owner);
    at = &all[*next - 1];
    if (at == &node) return "cyclic ownership: " + chain;
  }
  return "the owner " + in_quotes(node.owner) + " of " + in_quotes(node.name) + " is a node";
}

void read_nodes(const JsonNode& root, Mastn& network, NameTable& nodes, Problems& problems) {
  NameTable agents = agents_from(root, problems);
  network.agents = agents.names();
  nodes.find_or_add(kOrigin);
  network.owner.push_back(0);
  const std::optional<JsonNode> list = root.at("nodes");
  if (!list) return;
  std::vector<DeclaredNode> declared;
  for (const JsonNode& one : list->items()) {
    std::optional<DeclaredNode> node = declared_from(one);
    if (!node) continue;
    const std::size_t before = nodes.names().size();
    nodes.add(node->name, node->place);
    if (nodes.names().size() > before) declared.push_back(std::move(*node));
  }
  for (const DeclaredNode& node : declared) {
    const bool by_node = !agents.find(node.owner) && nodes.find(node.owner);
    if (by_node && !problems.full()) {
      problems.add(node.owner_place, owned_by_node(node, declared, nodes), "the name of an agent");
    }
    network.owner.push_back(by_node ? 0 : agents.find(node.owner, node.owner_place).value_or(0));
  }
}

std::optional<Step> step_from(const JsonNode& node, std::size_t arcs, Problems& problems) {
  if (!node.is_object_of({"at", "arc", "min", "max"})) return std::nullopt;
  const std::optional<JsonNode> at = node.at("at");
  const std::optional<JsonNode> arc = node.at("arc");
  const std::optional<JsonNode> min = node.at("min");
  const std::optional<JsonNode> max = node.at("max");
  if (!at || !arc || !min || !max) return std::nullopt;
  if (arcs == 0) {
    arc->wrong("a step, and there are no arcs");
    return std::nullopt;
  }
  const std::optional<Ticks> instant = at->seconds();
  const std::optional<std::uint32_t> position = arc->position(arcs - 1);
  const std::optional<Ticks> lower = min->bound(kMinusInfinite);
  const std::optional<Ticks> upper = max->bound(kInfinite);
  if (!instant || !position || !lower || !upper) return std::nullopt;
  if (*lower > *upper) {
    problems.add(node.place(),
                 "min " + seconds_text(*lower) + " is greater than max " + seconds_text(*upper));
  }
  return Step{*instant, *position, *lower, *upper};
}

}  // namespace

Mastn read_mastn_json(const JsonNode& root, Problems& problems) {
  Mastn network;
  root.is_object_of({"agents", "nodes", "arcs", "steps"});
  NameTable nodes("node", problems);
  read_nodes(root, network, nodes, problems);
  network.nodes = nodes.names();
  LinkTable links(nodes, problems);
  std::size_t arcs_given = 0;
  if (const std::optional<JsonNode> arcs = root.at("arcs")) {
    for (const JsonNode& one : arcs->items()) {
      ++arcs_given;
      if (const std::optional<Arc> arc = arc_from(one, nodes)) links.add(*arc, one.place());
    }
  }
  network.arcs = links.take_arcs();
  if (const std::optional<JsonNode> steps = root.find("steps")) {
    for (const JsonNode& one : steps->items()) {
      const std::optional<Step> step = step_from(one, arcs_given, problems);
      if (step) network.steps.push_back(*step);
    }
  }
  std::stable_sort(network.steps.begin(), network.steps.end(),
                   [](const Step& a, const Step& b) { return a.at < b.at; });
  return network;
}

std::string write_mastn(const Mastn& network) {
  std::vector<std::string> agents, nodes, arcs, steps;
  for (const std::string& agent : network.agents) agents.push_back(json_string(agent));
  for (std::size_t i = 1; i < network.nodes.size(); ++i) {
    nodes.push_back(R"({"name": )" + json_string(network.nodes[i]) + R"(, "agent": )" +
                    json_string(network.agents[network.owner[i]]) + "}");
  }
  for (const Arc& arc : network.arcs) arcs.push_back(arc_text(arc, network.nodes));
  for (const Step& step : network.steps) {
    steps.push_back(R"({"at": )" + seconds_text(step.at) + R"(, "arc": )" +
                    std::to_string(step.arc) + R"(, "min": )" + json_bound(step.min) +
                    R"(, "max": )" + json_bound(step.max) + "}");
  }
  return "{\n  \"agents\": " + lines_text(agents) + ",\n  \"nodes\": " + lines_text(nodes) +
         ",\n  \"arcs\": " + lines_text(arcs) + ",\n  \"steps\": " + lines_text(steps) + "\n}\n";
}

Stnu without_agents(const Mastn& network) { return {network.nodes, 0, network.arcs, {}}; }

}  // namespace skein::temporal
