// SPDX-License-Identifier: Apache-2.0
#include "row.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "skein/assembly/assembly.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/laws/judgement.hpp"
#include "skein/laws/laws.hpp"
#include "skein/run_tool/whole_run.hpp"
#include "skein/scenario/measures.hpp"
#include "skein/scenario_setup/overrides.hpp"

namespace skein::batch_tool {

namespace {

using Json = nlohmann::ordered_json;
using run_tool::Played;
using run_tool::WholeRun;

/// To a millionth: what is measured is no finer, and instants come in seconds with a last bit of
/// noise.
double millionths(double value) { return std::round(value * 1e6) / 1e6; }

/// The word of an end that is no question of expectations; empty if it is one.
std::string early_outcome(const WholeRun& run) {
  if (run.played.end == Played::End::kInterrupted) return "interrupted";
  if (!run_tool::ended_unjudged(run)) return "";
  return run.played.end == Played::End::kTimeLimit ? "time-limit" : "idle";
}

void judge(const WholeRun& run, Row& row) {
  for (const scenario::Verdict& verdict : run.verdicts) {
    row.expectations.emplace_back(verdict.name, verdict.passed);
    if (!verdict.passed)
      row.reason += (row.reason.empty() ? "" : "; ") + verdict.name + ": " + verdict.seen;
  }
  row.outcome = early_outcome(run);
  if (row.outcome.empty())
    row.outcome = run_tool::exit_code_of(run) == kExitOk ? "passed" : "failed";
  if (row.outcome == "time-limit") row.reason = "the time limit came before the mission's end";
  if (row.outcome == "idle") row.reason = "nothing was left to happen before the mission's end";
}

void ask_laws(const scenario::Scenario& scenario, const std::vector<journal::Record>& records,
              Row& row) {
  const auto add = [&](const std::string& law, const std::string& seen) {
    if (std::find(row.laws.begin(), row.laws.end(), law) != row.laws.end()) return;
    row.laws.push_back(law);
    row.breaks.push_back(seen);
  };
  for (const laws::Violation& one : laws::judge(scenario, records))
    add(one.law, laws::to_text(one));
}

Row labelled(const Case& what) {
  Row row;
  row.scenario = what.scenario;
  row.combination = what.combination;
  row.seed = what.seed;
  return row;
}

}  // namespace

Result<scenario::Scenario, Diagnostics> scenario_of(const Case& what,
                                                    const std::vector<std::string>& degrees) {
  auto scenario = scenario::read_scenario_text(what.text, what.file);
  if (!scenario) return scenario;
  scenario_setup::Overrides overrides;
  overrides.seed = what.seed;
  overrides.degrees = degrees;
  Diagnostics wrong = scenario_setup::apply(overrides, *scenario);
  if (wrong.empty()) wrong = assembly::check_assembly(*scenario);
  if (!wrong.empty()) return tl::unexpected(std::move(wrong));
  return scenario;
}

Row play_case(const Case& what, const std::vector<std::string>& degrees) {
  Row row = labelled(what);
  const auto scenario = scenario_of(what, degrees);
  if (!scenario) {
    row.outcome = "died";
    row.reason = to_text(scenario.error());
    return row;
  }
  const WholeRun run = run_tool::play_whole(*scenario);
  const auto& records = run.played.records;
  judge(run, row);
  row.duration = records.empty() ? 0 : millionths(records.back().at().to_seconds());
  for (const scenario::NamedMeasure& one : scenario::measures_of(*scenario)) {
    const auto measured = scenario::measure(one.what, records);
    row.measures.emplace_back(one.name,
                              measured ? std::optional(millionths(measured->value)) : std::nullopt);
  }
  const laws::GoalCount goals = laws::count_goals(laws::history_of(*scenario, records));
  row.goals = goals.all;
  row.achieved = goals.achieved;
  row.failed = goals.failed;
  ask_laws(*scenario, records, row);
  if (what.folder.empty()) return row;
  if (auto kept = run_tool::keep_run(what.folder, *scenario, what.text, run); !kept) {
    row.outcome = "unwritten";
    row.reason = kept.error().why;
  }
  return row;
}

std::string to_json(const Row& row) {
  Json json{{"scenario", row.scenario},  {"set", Json::array()},
            {"seed", row.seed},          {"outcome", row.outcome},
            {"reason", row.reason},      {"duration", row.duration},
            {"goals", row.goals},        {"achieved", row.achieved},
            {"failed", row.failed},      {"expectations", Json::array()},
            {"measures", Json::array()}, {"laws", row.laws},
            {"breaks", row.breaks}};
  for (const auto& [path, value] : row.combination) json["set"].push_back({path, value});
  for (const auto& [name, met] : row.expectations) json["expectations"].push_back({name, met});
  for (const auto& [name, value] : row.measures)
    json["measures"].push_back({name, value ? Json(*value) : Json()});
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<Row> row_from_json(const std::string& text) try {
  const Json json = Json::parse(text);
  Row row;
  row.scenario = json.at("scenario");
  for (const Json& one : json.at("set")) row.combination.emplace_back(one.at(0), one.at(1));
  row.seed = json.at("seed");
  row.outcome = json.at("outcome");
  row.reason = json.at("reason");
  row.duration = json.at("duration");
  row.goals = json.at("goals");
  row.achieved = json.at("achieved");
  row.failed = json.at("failed");
  for (const Json& one : json.at("expectations"))
    row.expectations.emplace_back(one.at(0), one.at(1));
  for (const Json& one : json.at("measures")) {
    row.measures.emplace_back(
        one.at(0), one.at(1).is_null() ? std::nullopt : std::optional(one.at(1).get<double>()));
  }
  row.laws = json.at("laws").get<std::vector<std::string>>();
  row.breaks = json.at("breaks").get<std::vector<std::string>>();
  return row;
} catch (const Json::exception&) {
  return std::nullopt;
}

}  // namespace skein::batch_tool
