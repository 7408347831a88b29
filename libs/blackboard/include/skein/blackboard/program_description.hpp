// SPDX-License-Identifier: Apache-2.0
// The description of a Skein program, which its DDS participant announces as user data.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace skein::blackboard {

struct ProgramDescription {
  std::string version;  ///< of Skein: "0.1.0"
  std::string layout;   ///< wire::layout_mark()
  /// Fingerprint of the scenario that it flies, as SectionPrints::text(); empty: it says of none.
  std::string scenario = {};
  bool operator==(const ProgramDescription&) const = default;
};

/// The description of this program.
ProgramDescription program_description(std::string scenario = {});

/// "skein 0.1.0 layout 0123456789abcdef", then " scenario 189abcdef" of one that flies one.
std::string to_text(const ProgramDescription& description);
/// Nothing if the text is no description: a foreign program, or an old Skein without descriptions.
std::optional<ProgramDescription> parse_program_description(std::string_view text);

}  // namespace skein::blackboard
