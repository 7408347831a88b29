// SPDX-License-Identifier: Apache-2.0
// Whether all nodes fly the same scenario.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "skein/foundation/section_prints.hpp"
#include "skein/foundation/time.hpp"
#include "skein/node/roster.hpp"

namespace skein::node {

/// Compares the scenario of this node with those that the programs of the others say they fly.
///
/// Nobody begins to live by the mission time of a node whose scenario differs, and the clock does
/// not begin while somebody's differs: so all that live fly one scenario. A node whose program is
/// not known (it is heard through a relay alone) is taken to agree: whoever passes it on has
/// compared. A ground station, UAV or simulator that says nothing of a scenario, as an older Skein,
/// differs; a functional layer that says nothing needs none (docs/functional-layer.md). Source:
/// docs/decisions/0130-one-scenario.md.
class Agreement {
 public:
  /// The description of a node's program; nothing: it is not known.
  using Descriptions = std::function<std::optional<std::string>(const std::string& node)>;
  using Times = std::map<NodeNumber, MissionTime>;

  /// The roster must outlive it. Own prints that are empty agree with everything.
  Agreement(const Roster& roster, const Member& self, SectionPrints own, Descriptions descriptions);

  /// What is wrong with the node's scenario: "differs in zones, places"; nothing: it agrees.
  std::optional<std::string> difference(NodeNumber node) const;
  bool agrees(NodeNumber node) const { return !difference(node); }
  /// All that differ, as a sentence: "the scenario of marvin, heliv differs in zones"; empty: none.
  std::string differences() const;

  /// The latest mission time of those that agree.
  MissionTime latest(const Times& heard) const;
  /// Why this node must not begin to live: a mission is under way at nodes whose scenario differs.
  std::optional<std::string> refusal(const Times& heard) const;

 private:
  std::optional<std::string> difference(const Member& member) const;
  std::string sentence(const std::function<bool(const Member&)>& of) const;

  const Roster& roster_;
  NodeNumber self_;
  SectionPrints own_;
  Descriptions descriptions_;
};

}  // namespace skein::node
