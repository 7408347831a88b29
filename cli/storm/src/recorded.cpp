// SPDX-License-Identifier: Apache-2.0
#include "skein/storm_tool/recorded.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <ostream>

#include "skein/assembly/assembly.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/laws/laws.hpp"
#include "skein/scenario_setup/overrides.hpp"
#include "violation_json.hpp"

namespace skein::storm_tool {

namespace {

using Json = nlohmann::ordered_json;

scenario_setup::Overrides overrides_of(const report::RunInfo& info) {
  scenario_setup::Overrides overrides;
  overrides.seed = info.seed;
  if (info.rate > 0) overrides.rate = info.rate;
  for (const report::UavInfo& uav : info.uavs)
    overrides.degrees.push_back(uav.name + "=" + std::to_string(uav.degree));
  return overrides;
}

Json json_of(const std::string& folder, const Verdict& verdict) {
  Json told{{"folder", folder},
            {"mission_seconds", verdict.flown},
            {"goals",
             {{"all", verdict.goals}, {"achieved", verdict.achieved}, {"failed", verdict.failed}}},
            {"violations", json_of_violations(verdict.violations)}};
  if (verdict.nearest >= 0) told["nearest"] = verdict.nearest;
  return told;
}

void print(const std::string& folder, const Verdict& verdict, std::ostream& out) {
  for (const laws::Violation& one : verdict.violations)
    out << folder << ": " << laws::to_text(one) << '\n';
  out << folder << ": " << verdict.goals << " goals, " << verdict.achieved << " achieved, "
      << verdict.failed << " failed in " << static_cast<long>(verdict.flown) << " s";
  if (verdict.nearest >= 0) out << "; least distance in the air " << verdict.nearest << " m";
  out << "; "
      << (verdict.violations.empty()
              ? "no law was broken"
              : std::to_string(verdict.violations.size()) + " times a law was broken")
      << '\n';
}

/// Those that could be read, in their order; all errors of the others.
std::vector<Recorded> read_all(const std::vector<std::string>& folders, Diagnostics& wrong) {
  std::vector<Recorded> all;
  for (const std::string& folder : folders) {
    auto recorded = read_recorded(folder);
    if (recorded) {
      all.push_back(std::move(*recorded));
    } else {
      wrong.append(recorded.error());
    }
  }
  return all;
}

}  // namespace

Result<Recorded, Diagnostics> read_recorded(const std::string& folder) {
  auto run = recording::read_run(folder);
  if (!run) return tl::unexpected(run.error());
  const std::string file = (std::filesystem::path(folder) / "scenario.yaml").string();
  auto scenario = assembly::load_scenario(file, overrides_of(run->info));
  if (!scenario) return tl::unexpected(scenario.error());
  return Recorded{std::move(*scenario), std::move(*run)};
}

Verdict verdict_on(const scenario::Scenario& scenario, const std::vector<journal::Record>& records,
                   const laws::Judging& judging) {
  const laws::History history = laws::history_of(scenario, records);
  Verdict verdict;
  const laws::GoalCount goals = laws::count_goals(history);
  verdict.goals = goals.all;
  verdict.achieved = goals.achieved;
  verdict.failed = goals.failed;
  verdict.flown = history.end;
  if (const auto near = laws::nearest(history)) verdict.nearest = near->distance;
  verdict.violations = laws::judge(scenario, records, judging);
  return verdict;
}

Verdict verdict_on(const Recorded& recorded, const std::vector<std::string>& only, double late) {
  laws::Judging judging{only};
  if (recorded.run.info.runtime == report::RuntimeKind::kDds)
    judging.over_dds = Duration::seconds(late * recorded.scenario.rate);
  return verdict_on(recorded.scenario, recorded.run.records, judging);
}

int judge_runs(const JudgeRunsOptions& options, std::ostream& out, std::ostream& err) {
  if (options.list_laws) {
    print_laws(out);
    return kExitOk;
  }
  Diagnostics wrong;
  const std::string unknown = problem_of_laws(options.only);
  const std::vector<Recorded> all = read_all(options.folders, wrong);
  if (!wrong.empty() || !unknown.empty()) {
    err << unknown << to_text(wrong);
    return kExitBadInput;
  }
  bool kept = true;
  Json document = Json::array();
  for (const Recorded& recorded : all) {
    err << to_text(recorded.run.damaged);
    const Verdict verdict = verdict_on(recorded, options.only, options.late);
    kept = kept && verdict.violations.empty();
    if (options.json) {
      document.push_back(json_of(recorded.run.folder, verdict));
    } else {
      print(recorded.run.folder, verdict, out);
    }
  }
  if (options.json) out << document.dump(2) << '\n';
  return kept ? kExitOk : kExitNegative;
}

}  // namespace skein::storm_tool
