// SPDX-License-Identifier: Apache-2.0
#include "skein/blackboard/program_description.hpp"

#include <sstream>

#include "skein/blackboard/wire_layout.hpp"

namespace skein::blackboard {

ProgramDescription program_description() { return {SKEIN_VERSION, wire::layout_mark()}; }

std::string to_text(const ProgramDescription& description) {
  return "skein " + description.version + " layout " + description.layout;
}

std::optional<ProgramDescription> parse_program_description(std::string_view text) {
  std::istringstream words{std::string(text)};
  std::string program, layout, rest;
  ProgramDescription description;
  words >> program >> description.version >> layout >> description.layout;
  if (!words || words >> rest || program != "skein" || layout != "layout") return std::nullopt;
  return description;
}

}  // namespace skein::blackboard
