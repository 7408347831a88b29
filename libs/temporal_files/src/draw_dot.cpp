// SPDX-License-Identifier: Apache-2.0
#include "drawn_links.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::temporal {

namespace {

std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

// Names may have backslashes; the line break between a name and its window must not be escaped.
std::string node_label(const Stnu& network, const DrawingOptions& options, NodeIndex node) {
  std::string label = quoted(network.nodes[node]);
  if (options.windows.empty()) return label;
  label.pop_back();
  return label + "\\n" + window_text(options.windows[node]) + "\"";
}

std::string node_line(const Stnu& network, const DrawingOptions& options, NodeIndex node,
                      const DrawnNode& drawn) {
  std::string line = "  n" + std::to_string(node) + " [label=" + node_label(network, options, node);
  if (node == network.origin) line += ", style=\"rounded,filled\", fillcolor=\"#e3e9ed\"";
  if (drawn.contingent) line += ", shape=ellipse, style=dashed, color=" + quoted(kContingentInk);
  if (drawn.in_conflict) line += ", penwidth=2, color=" + quoted(kConflictInk);
  return line + "];\n";
}

std::string link_line(const DrawnLink& link) {
  const bool back = link.is_backwards();
  std::string line = "  n" + std::to_string(back ? link.to : link.from) + " -> n" +
                     std::to_string(back ? link.from : link.to) +
                     " [label=" + quoted(bounds_text(link.min, link.max)) +
                     ", color=" + quoted(link.colour()) + ", fontcolor=" + quoted(link.colour());
  if (back) line += ", dir=back";
  if (link.contingent) line += ", style=dashed";
  if (link.in_conflict) line += ", penwidth=2.5";
  return line + "];\n";
}

}  // namespace

std::string draw_dot(const Stnu& network, const DrawingOptions& options) {
  SKEIN_EXPECTS(options.windows.empty() || options.windows.size() == network.nodes.size());
  const std::vector<DrawnLink> links = drawn_links(network, options.conflict);
  const std::vector<DrawnNode> nodes = drawn_nodes(network, links);
  std::string text = "digraph network {\n  rankdir=LR;\n";
  if (!options.title.empty()) text += "  label=" + quoted(options.title) + "; labelloc=t;\n";
  text += "  node [shape=box, style=rounded, fontname=\"Helvetica\", fontsize=12];\n";
  text += "  edge [fontname=\"Helvetica\", fontsize=10];\n";
  for (NodeIndex i = 0; i < nodes.size(); ++i) text += node_line(network, options, i, nodes[i]);
  for (const DrawnLink& link : links) text += link_line(link);
  return text + "}\n";
}

}  // namespace skein::temporal
