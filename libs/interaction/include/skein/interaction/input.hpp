// SPDX-License-Identifier: Apache-2.0
// Inputs of a role's engine. Source: spec 7.8.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

namespace skein::interaction {

/// The model begins: its main block is scheduled. At most once.
struct Start {};

/// The model is to end; without effect before the start and after the end.
struct Abort {};

/// The state of a task or a coordination action, reported by the component that carries it out.
struct Status {
  enum class Word : std::uint8_t { kRunning, kEnded, kAborted };
  std::string componel;
  Word word = Word::kRunning;
};

/// A message, internal or from another UAV.
struct Message {
  std::string text;
};

/// A finding of the spatial constraint checker. Acts as the message "ID violated" (or "satisfied",
/// "undetermined") while a block that has this SCM is active.
struct ScmReport {
  enum class Finding : std::uint8_t { kViolated, kSatisfied, kUndetermined };
  std::string scm;
  Finding finding = Finding::kViolated;
};

/// Time passes.
struct Tick {};

using Input = std::variant<Start, Abort, Status, Message, ScmReport, Tick>;

/// "violated", "satisfied", "undetermined".
std::string_view to_text(ScmReport::Finding finding);
/// "mcs2 violated".
std::string message_of(const std::string& scm, ScmReport::Finding finding);

}  // namespace skein::interaction
