// SPDX-License-Identifier: Apache-2.0
// Everything that can happen to the engine of a role. Source: spec 7.8.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

namespace skein::interaction {

/// The model begins: its main block waits to be activated. Once.
struct Start {};

/// The model is to end; without effect before the start and after the end.
struct Abort {};

/// What a task or a coordination action does, from who carries it out.
struct Status {
  enum class Word : std::uint8_t { kRunning, kEnded, kAborted };
  std::string componel;
  Word word = Word::kRunning;
};

/// Internal or from other UAVs.
struct Message {
  std::string text;
};

/// What the checker of spatial constraints found. Heard as the message "ID violated" and so on,
/// while a block is active in which this SCM holds.
struct ScmReport {
  enum class Finding : std::uint8_t { kViolated, kSatisfied, kUndetermined };
  std::string scm;
  Finding finding = Finding::kViolated;
};

/// Nothing but that time passes.
struct Tick {};

using Input = std::variant<Start, Abort, Status, Message, ScmReport, Tick>;

/// "violated", "satisfied", "undetermined".
std::string_view to_text(ScmReport::Finding finding);
/// "mcs2 violated".
std::string message_of(const std::string& scm, ScmReport::Finding finding);

}  // namespace skein::interaction
