// SPDX-License-Identifier: Apache-2.0
#include "skein/scenario_text/scenario_text.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace skein::scenario_text {

namespace {

namespace fs = std::filesystem;

std::string text_of(const YAML::Node& document) {
  YAML::Emitter out;
  out << document;
  return std::string(out.c_str()) + "\n";
}

/// What is done with a scalar that names a file, given what leads there from elsewhere.
using Renaming = std::function<void(YAML::Node, const std::string& elsewhere)>;

/// Each scalar that names a file there is, relative to `from`.
void each_file_name(YAML::Node node, const fs::path& from, const fs::path& to,
                    const Renaming& rename) {
  if (!node.IsScalar()) {
    for (auto entry : node)
      each_file_name(node.IsMap() ? entry.second : YAML::Node(entry), from, to, rename);
    return;
  }
  const auto name = node.as<std::string>();
  std::error_code none;
  if (!name.empty() && fs::path(name).is_relative() && fs::is_regular_file(from / name, none))
    rename(node, fs::proximate(fs::absolute(from / name), fs::absolute(to)).string());
}

std::vector<std::size_t> line_starts(const std::string& text) {
  std::vector<std::size_t> starts{0};
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '\n') starts.push_back(i + 1);
  return starts;
}

/// Bytes of a text.
struct Span {
  std::size_t at = 0, length = 0;
};

/// Where a scalar is written, with its quotes; nothing if it is not written letter by letter.
std::optional<Span> written(const YAML::Node& node, const std::string& text,
                            const std::vector<std::size_t>& starts) {
  const YAML::Mark mark = node.Mark();
  const auto line = static_cast<std::size_t>(mark.line);
  if (mark.is_null() || line >= starts.size()) return std::nullopt;
  const std::size_t at = starts[line] + static_cast<std::size_t>(mark.column);
  if (at >= text.size()) return std::nullopt;
  for (const std::string quote : {"", "'", "\""}) {
    const std::string whole = quote + node.Scalar() + quote;
    if (text.compare(at, whole.size(), whole) == 0) return Span{at, whole.size()};
  }
  return std::nullopt;
}

std::string as_scalar(const std::string& name) {
  const auto plain = [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '/' || c == '.' || c == '_' || c == '-';
  };
  if (std::all_of(name.begin(), name.end(), plain)) return name;
  YAML::Emitter out;
  out << YAML::DoubleQuoted << name;
  return out.c_str();
}

}  // namespace

std::string moved(const std::string& yaml, const std::string& from_folder,
                  const std::string& to_folder) {
  struct Renamed {
    std::size_t length = 0;
    std::string elsewhere;
  };
  YAML::Node document = YAML::Load(yaml);
  const std::vector<std::size_t> starts = line_starts(yaml);
  std::map<std::size_t, Renamed> names;  // by place: what an anchor names is met more than once
  bool in_place = true;
  each_file_name(document, from_folder, to_folder, [&](const YAML::Node& node, const auto& name) {
    const auto span = written(node, yaml, starts);
    if (span) names[span->at] = {span->length, name};
    in_place = in_place && span;
  });
  if (!in_place) {
    each_file_name(document, from_folder, to_folder,
                   [](YAML::Node node, const std::string& name) { node = name; });
    return text_of(document);
  }
  std::string text = yaml;
  // From the end on, so that places before it stay.
  for (auto name = names.rbegin(); name != names.rend(); ++name)
    text.replace(name->first, name->second.length, as_scalar(name->second.elsewhere));
  return text;
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
