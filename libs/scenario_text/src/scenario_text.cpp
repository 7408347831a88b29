// SPDX-License-Identifier: Apache-2.0
#include "skein/scenario_text/scenario_text.hpp"

#include <yaml-cpp/yaml.h>

#include <filesystem>

namespace skein::scenario_text {

namespace {

namespace fs = std::filesystem;

std::string text_of(const YAML::Node& document) {
  YAML::Emitter out;
  out << document;
  return std::string(out.c_str()) + "\n";
}

void lead_elsewhere(YAML::Node node, const fs::path& from, const fs::path& to) {
  if (node.IsScalar()) {
    const auto name = node.as<std::string>();
    std::error_code none;
    if (!name.empty() && fs::path(name).is_relative() && fs::is_regular_file(from / name, none))
      node = fs::proximate(fs::absolute(from / name), fs::absolute(to)).string();
    return;
  }
  for (auto entry : node) lead_elsewhere(node.IsMap() ? entry.second : YAML::Node(entry), from, to);
}

}  // namespace

std::string moved(const std::string& yaml, const std::string& from_folder,
                  const std::string& to_folder) {
  YAML::Node document = YAML::Load(yaml);
  lead_elsewhere(document, from_folder, to_folder);
  return text_of(document);
}

Result<std::string, Failure> with_radio(const std::string& yaml, const std::string& faults) {
  try {
    YAML::Node document = YAML::Load(yaml);
    const YAML::Node script = YAML::Load(faults);
    if (!document.IsMap()) return failure("the scenario is no document with keys");
    if (!script.IsMap() || script.size() != 1 || !script["radio"] || !script["radio"].IsMap())
      return failure("a fault script has one key, radio, and under it those of a scenario's radio");
    for (const auto& entry : script["radio"]) {
      const auto key = entry.first.as<std::string>();
      if (key != "cuts") {
        document["radio"][key] = entry.second;
      } else if (!entry.second.IsSequence()) {
        return failure("cuts are a list");
      } else {
        for (const auto& cut : entry.second) document["radio"]["cuts"].push_back(YAML::Node(cut));
      }
    }
    return text_of(document);
  } catch (const YAML::Exception& error) {
    return failure(error.what());
  }
}

}  // namespace skein::scenario_text
