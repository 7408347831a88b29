// SPDX-License-Identifier: Apache-2.0
// The GraphML of the CSTNU Tool (`.stnu`): writing.
#include "graphml.hpp"
#include "link_tables.hpp"
#include "readers.hpp"
#include "seconds_text.hpp"

namespace skein::temporal {

namespace {

constexpr const char* kHead = R"(<?xml version="1.0" encoding="UTF-8"?>
<graphml xmlns="http://graphml.graphdrawing.org/xmlns">
<key id="NetworkType" for="graph"><default>STNU</default></key>
<key id="nVertices" for="graph"><default>0</default></key>
<key id="nEdges" for="graph"><default>0</default></key>
<key id="nContingent" for="graph"><default>0</default></key>
<key id="Type" for="edge"><default>requirement</default></key>
<key id="Value" for="edge"><default></default></key>
<graph edgedefault="directed">
)";

std::string data(const char* key, const std::string& text) {
  return "<data key=\"" + std::string(key) + "\">" + text + "</data>";
}

std::string edge_text(std::size_t number, const Edge& edge, const char* type,
                      const std::vector<std::string>& names) {
  return "<edge id=\"e" + std::to_string(number) + "\" source=\"" + names[edge.source] +
         "\" target=\"" + names[edge.target] + "\">" + data("Type", type) +
         data("Value", seconds_text(edge.weight)) + "</edge>\n";
}

}  // namespace

std::string xml_escaped(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

Result<std::string, Failure> write_graphml(const Stnu& network) {
  Result<std::vector<std::string>, Failure> names = names_with_origin(network, kGraphmlOrigin);
  if (!names) return tl::unexpected(names.error());
  for (std::string& name : *names) name = xml_escaped(name);
  std::string nodes;
  for (const std::string& name : *names) nodes += "<node id=\"" + name + "\"/>\n";
  std::string edges;
  std::size_t count = 0;
  for (const Edge& edge : edges_from(network.arcs)) {
    edges += edge_text(++count, edge, "requirement", *names);
  }
  for (const ContingentLink& link : network.contingent) {
    const Edge out{link.activation, link.contingent, link.max, {}};
    const Edge back{link.contingent, link.activation, -link.min, {}};
    edges += edge_text(++count, out, "contingent", *names);
    edges += edge_text(++count, back, "contingent", *names);
  }
  return kHead + data("NetworkType", network.contingent.empty() ? "STN" : "STNU") + "\n" +
         data("nVertices", std::to_string(names->size())) + "\n" +
         data("nEdges", std::to_string(count)) + "\n" +
         data("nContingent", std::to_string(network.contingent.size())) + "\n" + nodes + edges +
         "</graph>\n</graphml>\n";
}

}  // namespace skein::temporal
