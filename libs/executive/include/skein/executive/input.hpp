// SPDX-License-Identifier: Apache-2.0
// Everything that can happen to the executive.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "skein/executive/task.hpp"
#include "skein/functional/port.hpp"

namespace skein::executive {

/// How START ties a new task to those already there. Source: T III.2.1, spec 2.3.
enum class InsertionMode : std::uint8_t {
  kSeq,  ///< sequential: Π and Ξ as given
  kVut,  ///< very urgent: at once; what is incompatible and under way is interrupted
  kDep,  ///< dependent: after the end of every task not yet terminal, mandatory
  kNut,  ///< not urgent: the same, optional
};

/// "SEQ", "VUT", "DEP", "NUT".
std::string_view to_text(InsertionMode mode);
std::optional<InsertionMode> insertion_mode_from(std::string_view text);

struct Start {
  Task task;
  InsertionMode mode = InsertionMode::kSeq;
};

struct Abort {
  TaskId id;
};

struct ProcessMessage {
  std::string message;
};

/// What is absent stays as it is.
struct UpdateConditions {
  TaskId id;
  std::optional<Formula> preconditions;
  std::optional<Formula> exit;
};

struct Suppress {
  TaskId id;
};

/// From the functional layer, or for a joint task from the supervisor.
using FunctionalStatus = functional::Status;

/// What a synchronisation message says of its sender.
enum class SyncWord : std::uint8_t {
  kThere,      ///< it is there and waits; counts for Config::sync_validity
  kDone,       ///< it has synchronised, or only had to say so; counts for ever
  kWithdrawn,  ///< it has given up: what it said before counts no more
};

/// "there", "done", "withdrawn".
std::string_view to_text(SyncWord word);
std::optional<SyncWord> sync_word_from(std::string_view text);

/// A synchronisation message; `id` is the synchronisation's. One that was said before another of
/// the same sender changes nothing. Source: spec 2.6.
struct SyncReceived {
  std::uint64_t id = 0;
  std::string from;
  SyncWord word = SyncWord::kThere;
  std::optional<MissionTime> said = {};  ///< when it was sent; absent: now
};

/// This UAV can be reached again: it is sent again what it may have missed.
struct PeerReachable {
  std::string name;
};

/// Whether the vehicle flies; the executive also learns it from tasks `takeoff` and `land` that
/// end. Matters to the background routine only.
struct Flight {
  bool airborne = false;
};

/// Another executive has taken over the tasks below this id that are not terminal. They leave the
/// plan: whoever carries them out is told nothing, and there is no event but one Notice. To
/// conditions of others they count as aborted, and a START may bring each of them back. The
/// background routine is interrupted and rests until the next START. Source: spec 1.2 (hand-over).
struct Relinquish {
  TaskId below = kFirstBackgroundId;
};

/// Only time has passed.
struct Tick {};

using Input = std::variant<Start, Abort, ProcessMessage, UpdateConditions, Suppress,
                           FunctionalStatus, SyncReceived, PeerReachable, Flight, Relinquish, Tick>;

enum class RequestKind : std::uint8_t {
  kStart,
  kAbort,
  kProcessMessage,
  kUpdateConditions,
  kSuppress,
};

/// "START", "ABORT", "PROCESS-MSG", "UPDATE-COND", "SUPPRESS".
std::string_view to_text(RequestKind kind);
std::optional<RequestKind> request_kind_from(std::string_view text);

}  // namespace skein::executive
