// SPDX-License-Identifier: Apache-2.0
#include "skein/scenario/scenario_print.hpp"

#include <cctype>

#include "meaning.hpp"
#include "skein/interaction/model_hash.hpp"

namespace skein::scenario {

namespace {

bool is_space(char one) { return std::isspace(static_cast<unsigned char>(one)) != 0; }

/// Where the comment that begins at `at` ends.
std::size_t end_of_comment(std::string_view text, std::size_t at) {
  const bool block = text.substr(at, 2) == "#|";
  const std::size_t end = block ? text.find("|#", at + 2) : text.find('\n', at);
  if (end == std::string_view::npos) return text.size();
  return block ? end + 2 : end;
}

/// Where the text between quotes that begins at `at` ends.
std::size_t end_of_string(std::string_view text, std::size_t at) {
  for (++at; at < text.size() && text[at] != '"'; ++at)
    if (text[at] == '\\') ++at;
  return std::min(at + 1, text.size());
}

/// What a planning domain says: its text without comments, and one space wherever there is some.
std::string without_comments(std::string_view text) {
  std::string plain;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = at;
    if (text[at] == ';' || text.substr(at, 2) == "#|") {
      at = end_of_comment(text, at);
    } else if (is_space(text[at])) {
      ++at;
    } else if (text[at] == '"') {
      at = end_of_string(text, at);
      plain += text.substr(begin, at - begin);
      continue;
    } else {
      at = std::min(at + (text[at] == '\\' ? 2 : 1), text.size());
      plain += text.substr(begin, at - begin);
      continue;
    }
    if (!plain.empty() && plain.back() != ' ') plain += ' ';
  }
  if (!plain.empty() && plain.back() == ' ') plain.pop_back();
  return plain;
}

std::uint64_t vehicles_of(const Scenario& scenario) {
  std::vector<UavSpec> uavs = scenario.uavs;  // their order gives the nodes their numbers
  for (UavSpec& uav : uavs) {
    uav.model_file.clear();
    std::ranges::sort(uav.model.sensors, {}, &world::SensorModel::device);
  }
  return Meaning().all(uavs).value();
}

std::uint64_t planning_of(const Scenario& scenario) {
  std::optional<PlanningSpec> planning = scenario.planning;
  if (planning) {
    planning->domain_file.clear();
    planning->domain_path.clear();
    planning->domain = without_comments(planning->domain);
  }
  return Meaning().all(planning, scenario.separation).value();
}

std::uint64_t joint_tasks_of(const Scenario& scenario) {
  if (!scenario.interaction) return 0;
  return Meaning().all(interaction::hashes_of(*scenario.interaction)).value();
}

std::uint64_t ground_of(const GroundSpec& ground) {
  return Meaning()
      .all(ground.position, ground.pps)
      .by_name(ground.objects)
      .all(ground.script, ground.last_ids)
      .value();
}

}  // namespace

SectionPrints print_of(const Scenario& scenario) {
  const WorldSpec& world = scenario.world;
  SectionPrints prints;
  prints.add("mission",
             Meaning().all(scenario.epoch, scenario.duration_limit, scenario.seed).value());
  prints.add("vehicles", vehicles_of(scenario));
  prints.add("world", Meaning().all(world.origin, world.terrain, world.wind).value());
  prints.add("zones", Meaning().by_name(world.zones).value());
  prints.add("closed air", Meaning().by_name(world.volumes).value());
  prints.add("places", Meaning().all(world.places).value());
  prints.add("objects", Meaning().by_name(world.objects).value());
  prints.add("radio", Meaning().all(scenario.radio, scenario.slots).value());
  prints.add("planning", planning_of(scenario));
  prints.add("team", Meaning().all(scenario.team).value());
  prints.add("ground station", ground_of(scenario.ground));
  return prints;
}

std::uint64_t print_of_own(const Scenario& scenario) {
  return Meaning().all(scenario.faults, joint_tasks_of(scenario)).value();
}

std::optional<std::vector<std::string>> differing_sections(std::string_view one,
                                                           std::string_view other) {
  static const std::vector<std::string> kSections = print_of({}).sections();
  const auto read = SectionPrints::read(kSections, one);
  if (!read) return std::nullopt;
  return read->differing(other);
}

}  // namespace skein::scenario
