// SPDX-License-Identifier: Apache-2.0
// The inputs of the executive.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "skein/executive/task.hpp"
#include "skein/functional/port.hpp"

namespace skein::executive {

/// How START relates a new task to the tasks of the plan. Source: T III.2.1, spec 2.3.
enum class InsertionMode : std::uint8_t {
  kSeq,  ///< sequential: Π and Ξ as given
  kVut,  ///< very urgent: starts at once; incompatible active tasks are interrupted
  kDep,  ///< dependent: Π also requires the end of every task not yet terminal, as mandatory
  kNut,  ///< not urgent: like kDep, as optional
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

/// Replaces formulas of a task; an absent one stays as it is.
struct UpdateConditions {
  TaskId id;
  std::optional<Formula> preconditions;
  std::optional<Formula> exit;
};

struct Suppress {
  TaskId id;
};

/// A status from the functional layer, or for a joint task from the supervisor.
using FunctionalStatus = functional::Status;

/// What a synchronisation message says of its sender.
enum class SyncWord : std::uint8_t {
  kThere,      ///< the sender has arrived and waits; valid for Config::sync_validity
  kDone,       ///< the sender has synchronised, or is a sender only; valid for ever
  kWithdrawn,  ///< the sender has given up: its earlier messages are void
};

/// "there", "done", "withdrawn".
std::string_view to_text(SyncWord word);
std::optional<SyncWord> sync_word_from(std::string_view text);

/// A synchronisation message arrived, for synchronisation `id`. A message that was sent before
/// another one of the same sender is ignored. Source: spec 2.6.
struct SyncReceived {
  std::uint64_t id = 0;
  std::string from;
  SyncWord word = SyncWord::kThere;
  std::optional<MissionTime> said = {};  ///< when it was sent; absent: now
};

/// The UAV `name` is reachable again; synchronisation messages that it may have missed are
/// repeated.
struct PeerReachable {
  std::string name;
};

/// Whether the vehicle flies, for the background routine. The executive also learns it from tasks
/// that end (`takeoff`, `land`).
struct Flight {
  bool airborne = false;
};

/// Another executive has taken over the non-terminal tasks with ids below `below`. They leave the
/// plan without an Interrupt and without events other than one Notice. In conditions of other tasks
/// they count as aborted, and a START may insert each of them again. The background routine is
/// interrupted and rests until the next START. Source: spec 1.2 (hand-over).
struct Relinquish {
  TaskId below = kFirstBackgroundId;
};

/// Only time has passed.
struct Tick {
  /// Nothing was heard until now, as after a restart: the time-outs of Config::functional_timeout
  /// that run begin anew.
  bool after_silence = false;
};

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
