// SPDX-License-Identifier: Apache-2.0
// What each participant of ours says of its program to all others, in DDS's user data.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace skein::blackboard {

struct ProgramDescription {
  std::string version;  ///< of Skein: "0.1.0"
  std::string layout;   ///< wire::layout_mark()
  bool operator==(const ProgramDescription&) const = default;
};

/// Of this program.
ProgramDescription program_description();

/// "skein 0.1.0 layout 0123456789abcdef".
std::string to_text(const ProgramDescription& description);
/// Nothing where it is none: another program, or one of before there were any.
std::optional<ProgramDescription> parse_program_description(std::string_view text);

}  // namespace skein::blackboard
