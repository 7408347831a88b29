// SPDX-License-Identifier: Apache-2.0
#include "csv.hpp"

#include <algorithm>

#include "skein/foundation/joined.hpp"
#include "skein/foundation/shortest_text.hpp"

namespace skein::batch_tool {

namespace {

void add_new(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

/// The value of that name, or nothing.
template <class Value>
const Value* found(const std::vector<std::pair<std::string, Value>>& all, const std::string& name) {
  const auto one =
      std::find_if(all.begin(), all.end(), [&](const auto& entry) { return entry.first == name; });
  return one == all.end() ? nullptr : &one->second;
}

std::string line_of(const std::vector<std::string>& fields) {
  std::string line;
  for (const std::string& field : fields) line += csv_field(field) + ",";
  line.back() = '\n';
  return line;
}

std::vector<std::string> fields_of(const Row& row, const std::vector<std::string>& keys,
                                   const std::vector<std::string>& measures) {
  std::vector<std::string> fields{row.scenario};
  for (const std::string& key : keys) {
    const std::string* value = found(row.combination, key);
    fields.push_back(value == nullptr ? "" : *value);
  }
  const auto met = std::count_if(row.expectations.begin(), row.expectations.end(),
                                 [](const auto& one) { return one.second; });
  fields.insert(fields.end(), {std::to_string(row.seed), row.outcome, row.reason,
                               shortest_text(row.duration), std::to_string(row.goals),
                               std::to_string(row.achieved), std::to_string(row.failed),
                               std::to_string(met), std::to_string(row.expectations.size())});
  for (const std::string& name : measures) {
    const auto* value = found(row.measures, name);
    fields.push_back(value != nullptr && *value ? shortest_text(**value) : "");
  }
  fields.push_back(joined(row.laws, " "));
  return fields;
}

}  // namespace

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string to_csv(const std::vector<Row>& rows) {
  std::vector<std::string> keys, measures;
  for (const Row& row : rows) {
    for (const auto& [path, value] : row.combination) add_new(keys, path);
    for (const auto& [name, value] : row.measures) add_new(measures, name);
  }
  std::vector<std::string> names{"scenario"};
  names.insert(names.end(), keys.begin(), keys.end());
  for (const char* name : {"seed", "outcome", "reason", "duration", "goals", "goals_achieved",
                           "goals_failed", "expectations_met", "expectations"})
    names.emplace_back(name);
  names.insert(names.end(), measures.begin(), measures.end());
  names.emplace_back("laws_broken");
  std::string csv = line_of(names);
  for (const Row& row : rows) csv += line_of(fields_of(row, keys, measures));
  return csv;
}

}  // namespace skein::batch_tool
