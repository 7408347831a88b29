// SPDX-License-Identifier: Apache-2.0
// The GraphML of the CSTNU Tool (`.stnu`): writing.
#include "graphml.hpp"
#include "link_tables.hpp"
#include "readers.hpp"
#include "seconds_text.hpp"
#include "skein/foundation/markup.hpp"

namespace skein::temporal {

namespace {

constexpr const char* kHead = R"(<?xml version="1.0" encoding="UTF-8"?>
<graphml xmlns="http://graphml.graphdrawing.org/xmlns">
<key id="NetworkType" for="graph"><default>STNU</default></key>
<key id="nVertices" for="graph"><default>0</default></key>
<key id="nEdges" for="graph"><default>0</default></key>
<key id="nContingent" for="graph"><default>0</default></key>
<key id="x" for="node"><default>0</default></key>
<key id="y" for="node"><default>0</default></key>
<key id="Obs" for="node"><default></default></key>
<key id="Label" for="node"><default>⊡</default></key>
<key id="Type" for="edge"><default>requirement</default></key>
<key id="Value" for="edge"><default></default></key>
<key id="LabeledValue" for="edge"><default></default></key>
<graph edgedefault="directed">
)";

std::string data(const char* key, const std::string& text) {
  return "<data key=\"" + std::string(key) + "\">" + text + "</data>";
}

// The tool's reader wants to know where each node is, and that all of these keys are declared.
std::string node_text(std::size_t number, const std::string& name) {
  constexpr std::size_t kColumns = 12;
  constexpr std::size_t kApart = 90;  // pixels
  const auto pixels = [](std::size_t place) { return std::to_string(kApart * (place + 1)); };
  return "<node id=\"" + name + "\">" + data("x", pixels(number % kColumns)) +
         data("y", pixels(number / kColumns)) + "</node>\n";
}

std::string edge_text(std::size_t number, const Edge& edge, const char* type,
                      const std::vector<std::string>& names) {
  return "<edge id=\"e" + std::to_string(number) + "\" source=\"" + names[edge.source] +
         "\" target=\"" + names[edge.target] + "\">" + data("Type", type) +
         data("Value", seconds_text(edge.weight)) + "</edge>\n";
}

}  // namespace

namespace {

/// The text of a graph, element by element.
class GraphmlWriter {
 public:
  GraphmlWriter(std::vector<std::string> names, std::size_t contingent)
      : names_(std::move(names)), contingent_(contingent) {
    for (std::string& name : names_) name = escaped_markup(name);
  }

  void add(const Edge& edge, const char* type) {
    edges_ += edge_text(++count_, edge, type, names_);
  }

  void add(const ContingentLink& link) {
    add({link.activation, link.contingent, link.max, {}}, "contingent");
    add({link.contingent, link.activation, -link.min, {}}, "contingent");
  }

  void add_wait(const ContingentLink& link, const WaitEdge& wait) {
    edges_ +=
        "<edge id=\"e" + std::to_string(++count_) + "\" source=\"" + names_[wait.node] +
        "\" target=\"" + names_[link.activation] + "\">" + data("Type", "derived") +
        data("LabeledValue", "UC(" + names_[link.contingent] + "):" + seconds_text(-wait.delay)) +
        "</edge>\n";
  }

  std::string text() const {
    std::string nodes;
    for (std::size_t i = 0; i < names_.size(); ++i) nodes += node_text(i, names_[i]);
    return kHead + data("NetworkType", contingent_ == 0 ? "STN" : "STNU") + "\n" +
           data("nVertices", std::to_string(names_.size())) + "\n" +
           data("nEdges", std::to_string(count_)) + "\n" +
           data("nContingent", std::to_string(contingent_)) + "\n" + nodes + edges_ +
           "</graph>\n</graphml>\n";
  }

 private:
  std::vector<std::string> names_;
  std::size_t contingent_;
  std::string edges_;
  std::size_t count_ = 0;
};

}  // namespace

Result<std::string, Failure> write_graphml(const Stnu& network) {
  Result<std::vector<std::string>, Failure> names = names_with_origin(network, kGraphmlOrigin);
  if (!names) return tl::unexpected(names.error());
  GraphmlWriter writer(std::move(*names), network.contingent.size());
  for (const Edge& edge : edges_from(network.arcs)) writer.add(edge, "requirement");
  for (const ContingentLink& link : network.contingent) writer.add(link);
  return writer.text();
}

Result<std::string, Failure> write_graphml(const DispatchableNetwork& network) {
  Result<std::vector<std::string>, Failure> names = names_with_origin(network.plan, kGraphmlOrigin);
  if (!names) return tl::unexpected(names.error());
  const std::vector<ContingentLink>& links = network.plan.contingent;
  GraphmlWriter writer(std::move(*names), links.size());
  for (const DistanceEdge& edge : network.edges) {
    writer.add({edge.from, edge.to, edge.weight, {}}, "requirement");
  }
  for (const ContingentLink& link : links) writer.add(link);
  for (const WaitEdge& wait : network.waits) writer.add_wait(links[wait.link], wait);
  return writer.text();
}

}  // namespace skein::temporal
