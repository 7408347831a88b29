// SPDX-License-Identifier: Apache-2.0
#include "testing/mission.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <set>

#include "skein/assembly/assembly.hpp"
#include "skein/journal/kinds.hpp"
#include "skein/laws/laws.hpp"
#include "skein/scenario_setup/overrides.hpp"

namespace skein::testing {

namespace {

[[noreturn]] void give_up(const Diagnostics& diagnostics) {
  std::fputs(to_text(diagnostics).c_str(), stderr);
  std::abort();
}

struct AsText {
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(std::int64_t value) const { return std::to_string(value); }
  std::string operator()(double value) const { return std::to_string(value); }
  std::string operator()(const std::string& value) const { return value; }
  std::string operator()(const std::vector<double>&) const { return "[]"; }
};

bool has(const journal::Record& record, const std::string& key, const std::string& value) {
  if (key == "kind") return record.kind() == value;
  if (key == "node") return record.node() == value;
  const journal::Value* field = record.find(key);
  return field != nullptr && std::visit(AsText{}, *field) == value;
}

/// What records say in a field whose words are counted, and that is none of these (a scenario that
/// expects it is refused).
std::string uncounted_words(const std::vector<journal::Record>& records) {
  std::set<std::string> found;
  for (const journal::Record& record : records) {
    const journal::Kind* kind = journal::find_kind(record.kind());
    if (kind == nullptr) continue;
    for (const journal::Kind::Field& field : kind->fields) {
      const journal::Value* value = field.words.empty() ? nullptr : record.find(field.name);
      if (value == nullptr) continue;
      const std::string word = std::visit(AsText{}, *value);
      if (std::find(field.words.begin(), field.words.end(), word) == field.words.end())
        found.insert("uncounted word of " + kind->name + " " + field.name + ": " + word + "\n");
    }
  }
  return std::accumulate(found.begin(), found.end(), std::string());
}

}  // namespace

std::string Mission::log() const {
  std::string text;
  for (const journal::Record& record : records) text += journal::to_json(record) + "\n";
  return text;
}

std::string Mission::failures() const {
  std::string text;
  for (const scenario::Verdict& verdict : verdicts) {
    if (!verdict.passed) text += verdict.name + ": " + verdict.seen + "\n";
  }
  return text;
}

std::vector<journal::Record> Mission::find(const Fields& fields) const {
  std::vector<journal::Record> found;
  for (const journal::Record& record : records) {
    const bool all = std::all_of(fields.begin(), fields.end(), [&](const auto& field) {
      return has(record, field.first, field.second);
    });
    if (all) found.push_back(record);
  }
  return found;
}

std::optional<double> Mission::first(const Fields& fields) const {
  const auto found = find(fields);
  if (found.empty()) return std::nullopt;
  return found.front().at().to_seconds();
}

scenario::Scenario scenario_at(const std::string& name,
                               const scenario_setup::Overrides& overrides) {
  auto scenario = assembly::load_scenario(
      std::string(SKEIN_SOURCE_DIR) + "/scenarios/" + name + ".yaml", overrides);
  if (!scenario) give_up(scenario.error());
  return std::move(*scenario);
}

scenario::Scenario comets(const std::string& name, const scenario_setup::Overrides& overrides) {
  return scenario_at("comets/" + name, overrides);
}

scenario_setup::Overrides with(std::uint64_t seed, std::vector<std::string> degrees) {
  scenario_setup::Overrides overrides;
  overrides.seed = seed;
  overrides.degrees = std::move(degrees);
  return overrides;
}

Mission play(const scenario::Scenario& scenario) {
  Mission mission;
  const assembly::NodeMaker make_node(scenario);
  const auto outcome = node::run_virtual(
      make_node.roster(), std::cref(make_node), assembly::virtual_config(scenario),
      [&](const journal::Record& record) { mission.records.push_back(record); });
  mission.end = outcome.end;
  std::stable_sort(mission.records.begin(), mission.records.end(),
                   [](const auto& a, const auto& b) { return a.at() < b.at(); });
  mission.verdicts = scenario::check(scenario.expectations, mission.records);
  mission.untrue = laws::to_text(laws::broken_laws(scenario, mission.records)) +
                   uncounted_words(mission.records);
  return mission;
}

}  // namespace skein::testing
