// SPDX-License-Identifier: Apache-2.0
// Errors of the paper's pseudo-code put back, so that mutation tests can show they are caught.
#pragma once

#include <memory>

#include "skein/temporal/agent.hpp"

namespace skein::temporal {

struct Defects {
  /// DIP-L contracts while relaxations are still under way. Source: notes 5.2, 5.3.
  bool no_waiting = false;
  /// CIP: a bound that a relaxation left weaker is not sent (algorithm 2, lines 16-18). Erratum 4.
  bool literal_bound_updates = false;
  /// Algorithm 1's test applied to upper bounds as it stands: all four. Erratum 1.
  bool literal_upper_test = false;
};

Result<std::unique_ptr<Agent>, AgentRefusal> make_agent_with(const Defects& defects,
                                                             Algorithm algorithm,
                                                             const Mastn& network, AgentIndex index,
                                                             const AgentOptions& options = {});
Result<std::unique_ptr<Agent>, AgentRefusal> make_supervisor_with(const Defects& defects,
                                                                  const Mastn& network,
                                                                  const AgentOptions& options = {});

}  // namespace skein::temporal
