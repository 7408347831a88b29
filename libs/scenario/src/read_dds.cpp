// SPDX-License-Identifier: Apache-2.0
// The part `dds` of a scenario file.
#include <algorithm>

#include "reading.hpp"
#include "skein/foundation/nearest.hpp"

namespace skein::scenario {

namespace {

std::string read_vendor(const config::Reader& reader) {
  const std::vector<std::string> names(kDdsNames.begin(), kDdsNames.end());
  const std::string name = reader.name_among(names, "whose DDS: fastdds or cyclonedds");
  return name.empty() ? kDdsNames.front() : name;
}

}  // namespace

void read_dds(const config::Reader& reader, const Names& names, Scenario& scenario) {
  if (!reader.present()) return;
  if (!reader.is_map()) {
    scenario.dds = read_vendor(reader);
    return;
  }
  std::vector<std::string> nodes = names.daemons;
  nodes.emplace_back("runner");
  for (const auto& [node, vendor] : reader.entries()) {
    if (std::ranges::find(nodes, node) == nodes.end()) {
      vendor.error("no node '" + node + "'", "a UAV, ground, sim, runner or a functional layer",
                   nearest_name(node, nodes));
      continue;
    }
    scenario.dds_by_node.insert_or_assign(node, read_vendor(vendor));
  }
}

}  // namespace skein::scenario
