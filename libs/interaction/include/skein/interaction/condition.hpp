// SPDX-License-Identifier: Apache-2.0
// Preconditions and exit conditions of blocks, in conjunctive normal form.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/interaction/componel_state.hpp"

namespace skein::interaction {

/// Index of a componel in document order (a block before its content, content as listed).
using ComponelIndex = std::size_t;

/// The componel is in this state. Source: T def. V.11.
struct ComponelIs {
  ComponelIndex componel = 0;
  AskedState state = AskedState::kEnded;
  bool operator==(const ComponelIs&) const = default;
};

/// The message is pending for the block that has this condition. Source: T def. V.12, spec 7.8.
struct MessagePending {
  std::string message;
  bool operator==(const MessagePending&) const = default;
};

/// The farthest that seconds in a condition reach [s]: just inside the range of nanoseconds.
inline constexpr double kLatestTime = 9.2e9;

/// The instant `since` + `after` has passed, i.e. is not in the future (`passed`), or has not
/// passed. An instant after an event that has not happened in this activation has not passed.
/// Source: T def. V.13, spec 7.8.
struct TimeIs {
  struct Epoch {  ///< mission time zero
    bool operator==(const Epoch&) const = default;
  };
  struct ModelStart {
    bool operator==(const ModelStart&) const = default;
  };
  /// When the componel came to this state.
  struct Event {
    ComponelIndex componel = 0;
    AskedState state = AskedState::kRunning;
    bool operator==(const Event&) const = default;
  };
  Duration after;
  std::variant<Epoch, ModelStart, Event> since;
  bool passed = true;
  /// The parameter of the role that says `after` (with_times()); empty: it is said already.
  std::string named = {};
  bool operator==(const TimeIs&) const = default;
};

/// Value of a literal that can never be true any more.
enum class Modality : std::uint8_t {
  kMandatory,  ///< impossible: only other literals can make its clause true
  kOptional,   ///< it counts as true
};

/// Effect of the exit of a loop. Source: T def. V.10.
enum class ExitEffect : std::uint8_t {
  kExit,
  kContinue,  ///< the contents are interrupted and the loop begins anew
};

/// A condition or its negation.
struct Literal {
  std::variant<ComponelIs, MessagePending, TimeIs> condition;
  bool negated = false;
  Modality modality = Modality::kMandatory;
  ExitEffect effect = ExitEffect::kExit;  ///< of literals in exits
  bool operator==(const Literal&) const = default;
};

/// A disjunction; without literals it can never be true.
using Clause = std::vector<Literal>;

/// A conjunction. Without clauses it is true as a precondition and false as an exit.
using Formula = std::vector<Clause>;

}  // namespace skein::interaction
