// SPDX-License-Identifier: Apache-2.0
#include "sweep.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <sstream>

namespace skein::batch_tool {

namespace {

/// At commas outside of brackets and quotes.
std::vector<std::string> parted(const std::string& text) {
  std::vector<std::string> parts{""};
  int depth = 0;
  char quote = 0;
  for (const char c : text) {
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '\'' || c == '"') {
      quote = c;
    } else if (c == '[' || c == '{') {
      ++depth;
    } else if (c == ']' || c == '}') {
      --depth;
    } else if (c == ',' && depth == 0) {
      parts.emplace_back();
      continue;
    }
    parts.back() += c;
  }
  return parts;
}

std::vector<std::string> steps_of(const std::string& path) {
  std::vector<std::string> steps;
  std::istringstream in(path);
  for (std::string step; std::getline(in, step, '.');) steps.push_back(step);
  return steps;
}

bool is_path(const std::string& path) {
  const auto steps = steps_of(path);
  return !steps.empty() && path.back() != '.' &&
         std::none_of(steps.begin(), steps.end(), [](const auto& step) { return step.empty(); });
}

void read_sweep(const std::string& text, std::vector<Sweep>& sweeps, Diagnostics& wrong) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || !is_path(text.substr(0, equals))) {
    wrong.add(
        {"", 0, 0, "--set", "'" + text + "'", "PATH=VALUE[,VALUE…], as in radio.loss=0,0.1", ""});
    return;
  }
  Sweep sweep{text.substr(0, equals), parted(text.substr(equals + 1))};
  const bool again = std::any_of(sweeps.begin(), sweeps.end(),
                                 [&](const Sweep& other) { return other.path == sweep.path; });
  if (again) wrong.add({"", 0, 0, "--set", sweep.path + " is given twice", "", ""});
  for (const std::string& value : sweep.values) {
    try {
      const YAML::Node node = YAML::Load(value);
      if (node.IsNull()) wrong.add({"", 0, 0, "--set", sweep.path + ": an empty value", "", ""});
    } catch (const YAML::Exception&) {
      wrong.add({"", 0, 0, "--set", sweep.path + ": '" + value + "' is no YAML", "", ""});
    }
  }
  sweeps.push_back(std::move(sweep));
}

/// The child of a node for one step of a path; the failure says why there is none.
Result<YAML::Node, Failure> child_of(YAML::Node node, const std::string& step) {
  if (node.IsSequence()) {
    const bool digits = step.find_first_not_of("0123456789") == std::string::npos;
    if (!digits || step.size() > 6 || std::stoul(step) >= node.size()) {
      return failure("'" + step + "' is no item of a list of " + std::to_string(node.size()) +
                     ", counted from 0");
    }
    return node[std::stoul(step)];
  }
  if (node.IsDefined() && !node.IsMap() && !node.IsNull())
    return failure("'" + step + "' of what is a single value");
  return node[step];
}

}  // namespace

Result<std::vector<Sweep>, Diagnostics> read_sweeps(const std::vector<std::string>& texts) {
  std::vector<Sweep> sweeps;
  Diagnostics wrong;
  for (const std::string& text : texts) read_sweep(text, sweeps, wrong);
  if (!wrong.empty()) return tl::unexpected(std::move(wrong));
  return sweeps;
}

std::vector<Combination> combinations(const std::vector<Sweep>& sweeps) {
  std::vector<Combination> all{{}};
  for (const Sweep& sweep : sweeps) {
    std::vector<Combination> longer;
    for (const Combination& one : all) {
      for (const std::string& value : sweep.values) {
        longer.push_back(one);
        longer.back().emplace_back(sweep.path, value);
      }
    }
    all = std::move(longer);
  }
  return all;
}

std::string to_text(const Combination& combination) {
  std::string text;
  for (const auto& [path, value] : combination)
    text += (text.empty() ? "" : " ") + path + "=" + value;
  return text;
}

Result<std::string, Failure> with_values(const std::string& yaml, const Combination& combination) {
  if (combination.empty()) return yaml;
  try {
    YAML::Node document = YAML::Load(yaml);
    if (!document.IsMap()) return failure("no document with keys");
    for (const auto& [path, value] : combination) {
      YAML::Node node;
      node.reset(document);
      for (const std::string& step : steps_of(path)) {
        auto child = child_of(node, step);
        if (!child) return failure(path + ": " + child.error().why);
        node.reset(*child);
      }
      node = YAML::Load(value);
    }
    YAML::Emitter out;
    out << document;
    return std::string(out.c_str()) + "\n";
  } catch (const YAML::Exception& error) {
    return failure(error.what());
  }
}

}  // namespace skein::batch_tool
