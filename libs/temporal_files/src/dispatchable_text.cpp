// SPDX-License-Identifier: Apache-2.0
#include "skein/temporal_files/dispatchable_text.hpp"

#include "link_json.hpp"
#include "readers.hpp"

namespace skein::temporal {

namespace {

std::string field(const char* key, const std::string& value) {
  return "\"" + std::string(key) + "\": " + value;
}

std::string name_field(const char* key, const Stnu& plan, NodeIndex node) {
  return field(key, json_string(plan.nodes[node]));
}

std::string edge_text(const DistanceEdge& edge, const Stnu& plan) {
  return "{" + name_field("from", plan, edge.from) + ", " + name_field("to", plan, edge.to) + ", " +
         field("max", json_bound(edge.weight)) + "}";
}

std::string wait_text(const WaitEdge& wait, const Stnu& plan) {
  const ContingentLink& link = plan.contingent[wait.link];
  return "{" + name_field("node", plan, wait.node) + ", " +
         name_field("from", plan, link.activation) + ", " +
         name_field("to", plan, link.contingent) + ", " + field("delay", json_bound(wait.delay)) +
         "}";
}

std::string json_of(const DispatchableNetwork& network) {
  const Stnu& plan = network.plan;
  std::vector<std::string> nodes, edges, contingent, waits;
  for (const std::string& name : plan.nodes) nodes.push_back(json_string(name));
  for (const DistanceEdge& edge : network.edges) edges.push_back(edge_text(edge, plan));
  for (const ContingentLink& link : plan.contingent) {
    contingent.push_back(
        arc_text({link.activation, link.contingent, link.min, link.max}, plan.nodes));
  }
  for (const WaitEdge& wait : network.waits) waits.push_back(wait_text(wait, plan));
  return "{\n  " + name_field("origin", plan, plan.origin) + ",\n  " +
         field("nodes", lines_text(nodes)) + ",\n  " + field("edges", lines_text(edges)) + ",\n  " +
         field("contingent", lines_text(contingent)) + ",\n  " + field("waits", lines_text(waits)) +
         "\n}\n";
}

}  // namespace

Result<std::string, Failure> write_dispatchable(const DispatchableNetwork& network, Format format) {
  if (format == Format::kJson) return json_of(network);
  if (format == Format::kGraphml) return write_graphml(network);
  return failure("the format has no waits; json and graphml have");
}

}  // namespace skein::temporal
