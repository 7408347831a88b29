// SPDX-License-Identifier: Apache-2.0
// Makes all nodes of a scenario, the same for both runtimes. Daemons, which run one node each, do
// not use this library.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "skein/deliberation_setup/knowledge.hpp"
#include "skein/node/node.hpp"
#include "skein/node/roster.hpp"
#include "skein/node/virtual_runtime.hpp"
#include "skein/scenario/scenario.hpp"
#include "skein/scenario_setup/overrides.hpp"

namespace skein::assembly {

/// The node of a name of the roster: "ground", "sim", a functional layer or a UAV. Precondition: it
/// is one of these.
std::unique_ptr<node::Node> make_node(const scenario::Scenario& scenario, const std::string& name);

/// Makes the nodes of a scenario for one process, in which they share what all know alike.
class NodeMaker {
 public:
  /// The scenario, without problems (check_assembly), outlives the maker.
  explicit NodeMaker(const scenario::Scenario& scenario);

  const node::Roster& roster() const { return roster_; }
  /// The node of a name of the roster, as make_node() makes it.
  std::unique_ptr<node::Node> operator()(const std::string& name) const;

 private:
  const scenario::Scenario& scenario_;
  node::Roster roster_;
  std::optional<deliberation_setup::CommonKnowledge> knowledge_;  ///< absent: no planning
};

/// Checks of a scenario across its parts, beyond those of its reader (a start outside the terrain,
/// a cut between unknown nodes, a planning domain with errors): all problems at once. Impossible
/// missions are no problem: a UAV refuses them in flight.
Diagnostics check_assembly(const scenario::Scenario& scenario);

/// Reads a scenario file, applies the overrides and checks that its parts fit together.
Result<scenario::Scenario, Diagnostics> load_scenario(const std::string& path,
                                                      const scenario_setup::Overrides& overrides);

/// Configuration of the virtual runtime for the scenario.
node::VirtualConfig virtual_config(const scenario::Scenario& scenario);

}  // namespace skein::assembly
