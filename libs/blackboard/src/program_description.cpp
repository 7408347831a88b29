// SPDX-License-Identifier: Apache-2.0
#include "skein/blackboard/program_description.hpp"

#include <sstream>
#include <utility>

#include "skein/blackboard/wire_layout.hpp"

namespace skein::blackboard {

ProgramDescription program_description(std::string scenario) {
  return {SKEIN_VERSION, wire::layout_mark(), std::move(scenario)};
}

std::string to_text(const ProgramDescription& description) {
  return "skein " + description.version + " layout " + description.layout +
         (description.scenario.empty() ? "" : " scenario " + description.scenario);
}

std::optional<ProgramDescription> parse_program_description(std::string_view text) {
  std::istringstream words{std::string(text)};
  std::string program, layout, scenario, rest;
  ProgramDescription description;
  words >> program >> description.version >> layout >> description.layout;
  if (!words || program != "skein" || layout != "layout") return std::nullopt;
  if (!(words >> scenario)) return description;
  words >> description.scenario;
  if (!words || words >> rest || scenario != "scenario") return std::nullopt;
  return description;
}

}  // namespace skein::blackboard
