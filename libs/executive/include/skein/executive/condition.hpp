// SPDX-License-Identifier: Apache-2.0
// Conditions on tasks, messages and time, and formulas of them in conjunctive normal form.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "skein/executive/task_state.hpp"
#include "skein/foundation/time.hpp"

namespace skein::executive {

/// CE(T', E): the task is in this state. Source: T III.1.2.
struct TaskInState {
  TaskId task;
  TaskState state = TaskState::kEnded;
  bool operator==(const TaskInState&) const = default;
};

/// CM(m): the message has been received.
struct MessageReceived {
  std::string message;
  bool operator==(const MessageReceived&) const = default;
};

/// CT(l, …): the instant has passed (the present is at it or after it), or has not passed yet.
struct TimeIs {
  MissionTime instant;
  bool passed = true;
  bool operator==(const TimeIs&) const = default;
};

using Condition = std::variant<TaskInState, MessageReceived, TimeIs>;

/// The value of a literal that can no longer be satisfied. Source: T III.1.3.
enum class Modality : std::uint8_t {
  kMandatory,  ///< false for ever
  kOptional,   ///< true
};

std::string_view to_text(Modality modality);

/// A condition or its negation, with a modality.
struct Literal {
  Condition condition;
  bool negated = false;
  Modality modality = Modality::kMandatory;
  bool operator==(const Literal&) const = default;
};

/// A disjunction; without literals it is false for ever.
using Clause = std::vector<Literal>;

/// A conjunction. Without clauses it is satisfied as Π and never satisfied as Ξ (spec 2.2).
using Formula = std::vector<Clause>;

}  // namespace skein::executive
