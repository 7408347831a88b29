// SPDX-License-Identifier: Apache-2.0
#include "skein/storm_tool/scenario_text.hpp"

#include <yaml-cpp/yaml.h>

#include <variant>

namespace skein::storm_tool {

namespace {

/// A place in a document: keys and numbers from its root on.
using Step = std::variant<std::string, std::size_t>;
using Path = std::vector<Step>;

std::string text_of(const YAML::Node& document) {
  YAML::Emitter out;
  out << document;
  return std::string(out.c_str()) + "\n";
}

void append(YAML::Node list, const std::vector<std::string>& items) {
  for (const std::string& item : items) list.push_back(YAML::Load(item));
}

YAML::Node child(const YAML::Node& node, const Step& step) {
  return std::visit([&](const auto& key) { return node[key]; }, step);
}

YAML::Node at(YAML::Node node, const Path& path) {
  for (const Step& step : path) node.reset(child(node, step));
  return node;
}

/// Items of lists whose items are maps, and entries of the maps that name things.
void find_parts(const YAML::Node& node, const Path& here, std::vector<Path>& parts) {
  const auto visit = [&](Step step, bool is_part) {
    Path path = here;
    path.push_back(std::move(step));
    const YAML::Node inner = child(node, path.back());
    if (is_part) parts.push_back(path);
    find_parts(inner, path, parts);
  };
  if (node.IsSequence()) {
    for (std::size_t i = node.size(); i-- > 0;) visit(i, node[i].IsMap());
  } else if (node.IsMap()) {
    const bool names_things =
        !here.empty() && here.size() <= 2 && std::holds_alternative<std::string>(here.back());
    for (const auto& entry : node)
      visit(entry.first.as<std::string>(), names_things && !entry.second.IsScalar());
  }
}

/// What is most likely not to matter comes first.
int rank(const Path& path) {
  const auto* first = std::get_if<std::string>(&path.front());
  if (first == nullptr) return 3;
  if (*first == "faults" || *first == "radio") return 0;
  return *first == "expect" ? 1 : *first == "ground" ? 2 : 3;
}

void remove(YAML::Node document, const Path& path) {
  const Path above(path.begin(), path.end() - 1);
  YAML::Node parent = at(document, above);
  std::visit([&](const auto& key) { parent.remove(key); }, path.back());
}

}  // namespace

Result<std::string, Failure> with_troubles(const std::string& yaml, std::uint64_t seed,
                                           const mission_lab::Troubles& troubles) {
  try {
    YAML::Node document = YAML::Load(yaml);
    if (!document.IsMap()) return failure("no document with keys");
    document["seed"] = seed;
    append(document["faults"], troubles.faults);
    if (!troubles.cuts.empty()) append(document["radio"]["cuts"], troubles.cuts);
    if (troubles.loss) document["radio"]["loss"] = *troubles.loss;
    if (troubles.planning_takes)
      document["planning"]["takes"] = std::vector<double>{0.05, *troubles.planning_takes};
    return text_of(document);
  } catch (const YAML::Exception& error) {
    return failure(error.what());
  }
}

std::vector<std::string> smaller(const std::string& yaml) {
  std::vector<Path> parts;
  find_parts(YAML::Load(yaml), {}, parts);
  std::stable_sort(parts.begin(), parts.end(),
                   [](const Path& a, const Path& b) { return rank(a) < rank(b); });
  std::vector<std::string> result;
  for (const Path& part : parts) {
    YAML::Node document = YAML::Load(yaml);
    remove(document, part);
    result.push_back(text_of(document));
  }
  return result;
}

}  // namespace skein::storm_tool
