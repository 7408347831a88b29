// SPDX-License-Identifier: Apache-2.0
#include "settings.hpp"

#include <algorithm>
#include <cctype>

#include "skein/config/parse.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/foundation/nearest.hpp"

namespace skein::daemon_main {

namespace {

std::string key_of(const CLI::Option& option) {
  return option.get_lnames().empty() ? std::string() : option.get_lnames().front();
}

std::string variable_of(const CLI::Option& option) {
  std::string name = "SKEIN_" + key_of(option);
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) {
    return c == '-' ? '_' : static_cast<char>(std::toupper(c));
  });
  return name;
}

/// The scalars of a value that is one or a list of them; nothing of anything else.
std::optional<std::vector<std::string>> scalars_of(const config::Value& value) {
  if (value.kind == config::Value::Kind::kScalar) return std::vector{value.scalar};
  if (value.kind != config::Value::Kind::kSequence) return std::nullopt;
  std::vector<std::string> all;
  for (const config::Value& item : value.items) {
    if (item.kind != config::Value::Kind::kScalar) return std::nullopt;
    all.push_back(item.scalar);
  }
  return all;
}

bool takes_many(const CLI::Option& option) { return option.get_expected_max() > 1; }

/// As YAML reads it back as the same text.
std::string quoted(const std::string& text) {
  const bool plain = !text.empty() && text.find_first_of(":#{}[],&*!|>'\"%@`\n ") == text.npos;
  if (plain) return text;
  std::string all = "'";
  for (const char c : text) all += c == '\'' ? std::string("''") : std::string(1, c);
  return all + "'";
}

std::string value_text(const CLI::Option& option) {
  const std::vector<std::string>& results = option.results();
  if (!takes_many(option)) return quoted(results.back());
  std::vector<std::string> items;
  for (const std::string& one : results) items.push_back(quoted(one));
  return "[" + joined(items, ", ") + "]";
}

}  // namespace

Settings::Settings(CLI::App& app, std::vector<std::string> own) {
  for (CLI::Option* option : app.get_options()) {
    const std::string key = key_of(*option);
    if (key.empty() || std::find(own.begin(), own.end(), key) != own.end()) continue;
    options_.push_back(option);
    if (option->count() > 0) origins_[option] = "command line";
  }
}

Diagnostics Settings::complete(const Environment& environment, const std::string& file) {
  Diagnostics problems;
  take_environment(environment, problems);
  if (!file.empty()) take_file(file, problems);
  return problems;
}

void Settings::take_environment(const Environment& environment, Diagnostics& problems) {
  for (CLI::Option* option : options_) {
    const std::string variable = variable_of(*option);
    const char* value = environment(variable.c_str());
    if (value == nullptr || *value == '\0' || origins_.count(option) > 0) continue;
    Diagnostic place;
    place.path = variable;
    take(*option, {value}, "environment, " + variable, std::move(place), problems);
  }
}

void Settings::take_file(const std::string& file, Diagnostics& problems) {
  const auto document = config::parse_yaml_file(file);
  if (!document) return problems.append(document.error());
  if (document->kind == config::Value::Kind::kNull) return;
  if (document->kind != config::Value::Kind::kMap) {
    return problems.add({file, document->line, document->column, "", "not a map",
                         "a map of options to values", ""});
  }
  std::vector<std::string> keys;
  for (const CLI::Option* option : options_) keys.push_back(key_of(*option));
  for (const config::Entry& entry : document->entries) {
    Diagnostic place{file, entry.value.line, entry.value.column, entry.key, "", "", ""};
    const auto known = std::find(keys.begin(), keys.end(), entry.key);
    const auto values = scalars_of(entry.value);
    if (known == keys.end()) {
      place.message = "no option of this program";
      place.nearest = nearest_name(entry.key, keys);
      problems.add(std::move(place));
    } else if (!values) {
      place.message = "is " + config::describe(entry.value);
      place.expected = "a value or a list of values";
      problems.add(std::move(place));
    } else {
      CLI::Option* const option = options_[static_cast<std::size_t>(known - keys.begin())];
      if (origins_.count(option) > 0) continue;
      take(*option, *values, file + ":" + std::to_string(place.line), std::move(place), problems);
    }
  }
}

void Settings::take(CLI::Option& option, const std::vector<std::string>& values,
                    const std::string& origin, Diagnostic place, Diagnostics& problems) try {
  origins_[&option] = origin;
  if (values.size() > 1 && !takes_many(option)) {
    place.message = std::to_string(values.size()) + " values where one is taken";
    return problems.add(std::move(place));
  }
  option.add_result(values);
  option.run_callback();
} catch (const CLI::ParseError& error) {
  place.message = error.what();
  problems.add(std::move(place));
}

std::string Settings::shown() const {
  std::string text;
  for (const CLI::Option* option : options_) {
    const auto origin = origins_.find(option);
    std::string line = key_of(*option) + ": ";
    if (origin != origins_.end()) {
      line += value_text(*option);
    } else if (const std::string value = option->get_default_str(); !value.empty()) {
      line += value.front() == '[' || option->get_expected_max() == 1 ? value : quoted(value);
    } else {
      line = "# " + line;
    }
    line.resize(std::max<std::size_t>(line.size() + 2, 40), ' ');
    text += line + "# " + (origin == origins_.end() ? "default" : origin->second) + "\n";
  }
  return text;
}

}  // namespace skein::daemon_main
