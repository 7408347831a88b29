// SPDX-License-Identifier: Apache-2.0
// `skein stn generate`.
#include <algorithm>
#include <map>
#include <ostream>

#include "skein/foundation/exit_code.hpp"
#include "skein/temporal_tool/stn.hpp"
#include "stn_file.hpp"

namespace skein::temporal_tool {

namespace {

using temporal::Arc;
using temporal::NodeIndex;
using temporal::Stnu;

// Why no network has this shape; empty when one has.
std::string shape_problem(const temporal::StnuGeneratorOptions& shape) {
  if (shape.lanes < 2) return "--lanes: at least 2";
  const std::uint32_t least = 1 + 3 * shape.lanes;
  if (shape.nodes < least) {
    return "--nodes: at least " + std::to_string(least) + " for " + std::to_string(shape.lanes) +
           " lanes";
  }
  const std::uint32_t most = (shape.nodes - 1) / 3 - shape.lanes;
  if (shape.contingent > most) {
    return "--contingent: at most " + std::to_string(most) + " among " +
           std::to_string(shape.nodes) + " nodes in " + std::to_string(shape.lanes) +
           " lanes, so that no two touch";
  }
  return "";
}

// Files have one arc for each ordered pair of nodes; one that leaves no room stays two.
std::vector<Arc> one_for_each_pair(const std::vector<Arc>& arcs) {
  std::vector<Arc> joined;
  std::map<std::pair<NodeIndex, NodeIndex>, std::size_t> place_of;
  for (const Arc& arc : arcs) {
    const auto [found, added] = place_of.emplace(std::pair(arc.from, arc.to), joined.size());
    if (added) {
      joined.push_back(arc);
      continue;
    }
    Arc& one = joined[found->second];
    const Arc both{arc.from, arc.to, std::max(one.min, arc.min), std::min(one.max, arc.max)};
    if (both.min <= both.max) {
      one = both;
    } else if (place_of.emplace(std::pair(arc.to, arc.from), joined.size()).second) {
      joined.push_back({arc.to, arc.from, -arc.max, -arc.min});
    }
  }
  return joined;
}

}  // namespace

int generate_stn(const StnGenerateOptions& options, std::ostream& out, std::ostream& err) {
  const std::optional<temporal::Format> format = format_option(options.to, err);
  const std::string problem = shape_problem(options.shape);
  if (!problem.empty()) err << problem << '\n';
  if (!format || !problem.empty()) return kExitBadInput;
  Random random(options.seed, "stn/generate");
  Stnu network = temporal::generate_stnu(options.shape, random);
  network.arcs = one_for_each_pair(network.arcs);
  const Result<std::string, Failure> text = temporal::write_network(network, *format);
  if (!text) {
    err << "cannot be written as " << options.to << ": " << text.error().why << '\n';
    return kExitBadInput;
  }
  return save_text(options.output, *text, out, err);
}

}  // namespace skein::temporal_tool
