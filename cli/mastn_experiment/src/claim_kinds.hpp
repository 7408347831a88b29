// SPDX-License-Identifier: Apache-2.0
// The three kinds of claims, each checked in its own file.
#pragma once

#include "skein/mastn_experiment/mastn_claims.hpp"

namespace skein::temporal {

std::vector<Claim> exact_claims(const std::vector<ExperimentRow>& rows);
std::vector<Claim> statistical_claims(const std::vector<ExperimentCell>& cells);
std::vector<Claim> reported_claims(const std::vector<ExperimentCell>& cells);

/// The cells of mode K.
std::vector<ExperimentCell> kept_cells(const std::vector<ExperimentCell>& cells);
/// Those of so many agents, or of so many external arcs.
std::vector<ExperimentCell> with_agents(const std::vector<ExperimentCell>& cells,
                                        std::uint32_t agents);
std::vector<ExperimentCell> with_external(const std::vector<ExperimentCell>& cells,
                                          std::uint32_t external);
/// Numbers of agents among the cells, ascending.
std::vector<std::uint32_t> agents_among(const std::vector<ExperimentCell>& cells);

}  // namespace skein::temporal
