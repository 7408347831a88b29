// SPDX-License-Identifier: Apache-2.0
// Random concurrent scenarios, the same for all algorithms, compared with the oracle when all is
// quiet.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "skein/temporal_lab/mastn_simulation.hpp"

namespace skein::temporal::testing {

struct Action {
  enum class Kind { kWait, kDisturb, kCut, kHeal, kCompare };
  Kind kind = Kind::kWait;
  Ticks wait = 0;                  ///< kWait
  std::vector<ArcUpdate> changes;  ///< kDisturb; of one agent or of several
  std::uint64_t link = 0;          ///< kCut, kHeal: any number, taken modulo the links there are
};

struct DifferentialScenario {
  Mastn network;
  TransportOptions transport;
  std::vector<Action> actions;
};

/// N 2–5, V 2–8, L 0–4, E 1–4; 15–55 % relaxations; half of them the scenarios of the experiment in
/// modes K and F, half with intervals of any kind, bounds that vanish included; batches of several
/// arcs; in half of them delays, in a third cuts and heals. Source: notes 5.3.
DifferentialScenario make_differential_scenario(std::uint64_t seed);

struct DifferentialOutcome {
  std::optional<std::string> mismatch;  ///< what went wrong, if anything; the play stops there
  std::uint64_t perturbations = 0;
  std::uint64_t comparisons = 0;
  std::uint64_t inconsistent = 0;  ///< of the comparisons
  Traffic traffic;
};

/// `out_of_order`: lets messages overtake each other, unseen from their ids, also where the
/// algorithm cannot bear it.
struct DifferentialOptions {
  AgentMaker maker = usual_agent;
  bool out_of_order = false;
};

/// Plays a scenario and compares dates and verdicts at each kCompare, after healing and quiescence.
/// DIP-G and DIP-M, which bear any order, get it in every other scenario.
DifferentialOutcome play(const DifferentialScenario& scenario, Algorithm algorithm,
                         const DifferentialOptions& options = {});

inline constexpr Algorithm kAlgorithms[] = {Algorithm::kCip, Algorithm::kDipG, Algorithm::kDipL,
                                            Algorithm::kDipM};

}  // namespace skein::temporal::testing
