// SPDX-License-Identifier: Apache-2.0
// Effects of a role's engine, in the order in which they arise. Source: spec 7.8.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/interaction/componel_state.hpp"

namespace skein::interaction {

struct StateChanged {
  std::string componel;
  ComponelState state = ComponelState::kScheduled;
  bool operator==(const StateChanged&) const = default;
};

/// Compute this local parameter of a block that is being activated.
struct Compute {
  std::string parameter;
  bool operator==(const Compute&) const = default;
};

/// Carry this task out (supervisor: refine, then executive).
struct Run {
  std::string task;
  bool operator==(const Run&) const = default;
};

/// Take part in this negotiation.
struct Negotiate {
  std::string action;
  bool operator==(const Negotiate&) const = default;
};

/// Stop this task, then report its final state.
struct Interrupt {
  std::string task;
  bool operator==(const Interrupt&) const = default;
};

/// Leave this negotiation, then report its final state.
struct Withdraw {
  std::string action;
  bool operator==(const Withdraw&) const = default;
};

/// A block reads a pending message, which is then no longer pending for that block.
struct Read {
  std::string message;
  std::string by;
  bool operator==(const Read&) const = default;
};

/// The last effect: the main block is over.
struct ModelOver {
  ComponelState state = ComponelState::kEnded;  ///< ended or aborted
  std::string why;                              ///< if the engine itself aborted the model
  bool operator==(const ModelOver&) const = default;
};

/// One effect with its instant.
struct Effect {
  using What =
      std::variant<StateChanged, Compute, Run, Negotiate, Interrupt, Withdraw, Read, ModelOver>;
  MissionTime at;
  What what;
  bool operator==(const Effect&) const = default;
};
using Effects = std::vector<Effect>;

}  // namespace skein::interaction
