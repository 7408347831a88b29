// SPDX-License-Identifier: Apache-2.0
#include "skein/run_tool/run.hpp"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <ostream>

#include "play_dds.hpp"
#include "play_virtual.hpp"
#include "run_folder.hpp"
#include "skein/assembly/assembly.hpp"
#include "skein/deliberation_setup/refused_missions.hpp"
#include "skein/export_tool/export.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/foundation/nearest.hpp"
#include "skein/journal/lines/run.hpp"
#include "skein/laws/laws.hpp"
#include "skein/laws/waiting.hpp"
#include "skein/report/explain.hpp"
#include "skein/run_tool/whole_run.hpp"
#include "skein/scenario_setup/setup.hpp"

namespace skein::run_tool {

namespace {

using scenario::Scenario;
using scenario::Verdict;

Progress::Style progress_style(const RunOptions& options) {
  if (options.json || options.quiet) return Progress::Style::kNone;
  return isatty(STDERR_FILENO) != 0 ? Progress::Style::kTerminal : Progress::Style::kLines;
}

// Why a run came to no proper end; empty if it did.
std::string early_end(const Played& played) {
  switch (played.end) {
    case Played::End::kFailed:
      return "the run failed: " + played.why;
    case Played::End::kInterrupted:
      return "interrupted";
    default:
      break;
  }
  return "";
}

/// That UAVs in the air came nearer to each other than their models ask for, and what prevents it.
void warn_of_encounters(const Scenario& scenario, const WholeRun& run, std::ostream& out) {
  if (scenario.uavs.size() < 2) return;
  const auto encounters = laws::too_near(scenario, run.played.records);
  if (encounters.empty()) return;
  const laws::Violation& first = encounters.front();
  out << "warning: " << encounters.size() << " times two UAVs in the air came too near; at "
      << std::lround(first.at) << " s " << first.uav << " was " << first.sentence << '\n';
  if (!scenario.separation || !scenario.separation->merge)
    out << "         nothing keeps ways apart here: separation: {merge: true} does\n";
}

/// What the script of a mission that was not finished still waited for.
void print_waits(const std::vector<journal::Record>& records, std::ostream& out) {
  for (const journal::Record& record : records) {
    if (record.kind() != journal::lines::Waiting::kKind) continue;
    laws::Waiting waiting{std::string(record.text("step")), std::string(record.text("for")),
                          std::string(record.text("is")), std::nullopt,
                          std::string(record.text("why"))};
    if (record.find("since") != nullptr) waiting.since = record.number("since");
    out << "        " << to_text(waiting) << '\n';
  }
}

void print_summary(const WholeRun& run, const std::string& folder, std::ostream& out) {
  const auto& [played, verdicts] = run;
  const std::string early = early_end(played);
  if (!early.empty()) out << early << (early.back() == '\n' ? "" : "\n");
  std::size_t passed = 0;
  for (const Verdict& verdict : verdicts) {
    passed += verdict.passed ? 1 : 0;
    // Of a run that was cut short nobody expects the rest; the report has it all.
    if (verdict.passed || !early.empty()) continue;
    out << "FAILED  " << verdict.name << "\n        " << verdict.seen << '\n';
  }
  if (played.end == Played::End::kTimeLimit)
    out << "the time limit came before the mission's end\n";
  if (played.end == Played::End::kIdle)
    out << "nothing was left to happen before the mission's end\n";
  print_waits(played.records, out);
  if (ended_unjudged(run))
    out << "FAILED  the mission did not end, and the scenario expects nothing else\n";
  out << passed << " of " << verdicts.size() << " expectations met; report: " << folder
      << "/report.html\n";
}

// "karma" or "karma:104".
Result<std::string, Failure> explained(const report::Journal& journal, const std::string& wanted) {
  const std::size_t colon = wanted.find(':');
  if (colon == std::string::npos) return report::explain(journal, wanted, std::nullopt);
  std::uint64_t task = 0;
  const char* const end = wanted.data() + wanted.size();
  const auto [rest, error] = std::from_chars(wanted.data() + colon + 1, end, task);
  if (error != std::errc() || rest != end) {
    return failure("--explain: '" + wanted + "', expected UAV or UAV:TASK, as in karma:104");
  }
  return report::explain(journal, wanted.substr(0, colon), task);
}

// The exit code: that of the run, unless something asked for could not be explained.
int explain_all(const std::string& folder, const std::vector<std::string>& wanted, int code,
                std::ostream& out, std::ostream& err) {
  if (wanted.empty()) return code;
  const auto journal = read_run_journal(folder);
  if (!journal) {
    err << journal.error().why << '\n';
    return kExitBadInput;
  }
  for (const std::string& one : wanted) {
    const auto text = explained(*journal, one);
    if (text) {
      out << *text;
      continue;
    }
    err << text.error().why << '\n';
    code = kExitBadInput;
  }
  return code;
}

int play(const Scenario& scenario, const RunOptions& options, const std::string& folder,
         std::ostream& out, std::ostream& err) {
  Progress progress(err, progress_style(options), scenario.uav_names());
  const auto start = std::chrono::steady_clock::now();
  Played played =
      options.virtual_time
          ? play_virtual(scenario, progress)
          : play_dds(scenario,
                     {options.daemons, folder, options.domain, options.overrides.as_options(),
                      options.without, options.security, options.types, options.console,
                      options.mavlink_out, options.ros2, options.interfaces},
                     progress);
  progress.finish();
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  const WholeRun whole =
      judged(scenario, std::move(played), Duration::seconds(options.allow_late * scenario.rate));
  // Virtual time knows no wall clock: the same seed gives the same folder, byte for byte.
  const report::RunInfo info =
      run_info(scenario, options.virtual_time, options.virtual_time ? 0 : wall.count(),
               whole.played.records);
  const auto summary = write_folder(folder, scenario, info, whole.played.records);
  if (!summary) {
    err << summary.error().why << '\n';
    return kExitSystem;
  }
  if (options.json) {
    out << *summary;
  } else {
    warn_of_encounters(scenario, whole, out);
    print_summary(whole, folder, out);
  }
  if (!options.mcap.empty()) {
    const auto written = export_tool::write_mcap(info, whole.played.records, options.mcap);
    if (!written) {
      err << written.error().why << '\n';
      return kExitSystem;
    }
  }
  return explain_all(folder, options.explain, exit_code_of(whole), out, err);
}

// Keys are checked by Fast DDS alone.
std::string security_problem(const Scenario& scenario, const RunOptions& options) {
  if (options.security.empty()) return "";
  std::vector<std::string> others;
  const node::Roster roster = scenario_setup::roster_of(scenario);
  for (const node::Member& member : roster.members())
    if (scenario.dds_of(member.name) != scenario::kDdsNames.front()) others.push_back(member.name);
  if (others.empty()) return "";
  return "--security needs Fast DDS in all nodes, and these are to use another: " +
         joined(others, ", ");
}

// Types are announced by Cyclone DDS alone.
std::string types_problem(const Scenario& scenario, const RunOptions& options) {
  if (!options.types) return "";
  const node::Roster roster = scenario_setup::roster_of(scenario);
  for (const node::Member& member : roster.members())
    if (announces_types(scenario, member.name)) return "";
  return "--types needs a node on Cyclone DDS, which alone announces types: --dds cyclonedds";
}

// Who starts a node by hand may have misspelt it.
std::string without_problem(const Scenario& scenario, const RunOptions& options) {
  std::vector<std::string> names = scenario.uav_names();
  names.insert(names.end(), {"ground", "sim"});
  for (const auto& [uav, layer] : scenario.functional_layers()) names.push_back(layer);
  for (const std::string& name : options.without)
    if (std::ranges::find(names, name) == names.end())
      return "--without: no node '" + name + "' in this scenario" +
             did_you_mean(nearest_name(name, names));
  return "";
}

// Tells what is no error and yet not what its author will have meant; whether missions will be
// refused.
bool warn(const Scenario& scenario, std::ostream& err) {
  const Diagnostics refused = deliberation_setup::refused_missions(scenario);
  for (const Diagnostics& found :
       {scenario.warnings, deliberation_setup::domain_warnings(scenario), refused})
    for (const Diagnostic& one : found.all()) err << "warning: " << to_text(one) << '\n';
  return !refused.empty();
}

int report_check(const Scenario& scenario, const std::string& file, bool refused,
                 std::ostream& out) {
  out << file << ": " << scenario.uavs.size() << " UAVs, " << scenario.ground.script.steps.size()
      << " steps, " << scenario.expectations.size() << " expectations; "
      << (refused ? "some missions will be refused" : "nothing wrong") << '\n';
  return refused ? kExitNegative : kExitOk;
}

}  // namespace

int run(const RunOptions& options, std::ostream& out, std::ostream& err) {
  const auto scenario = assembly::load_scenario(options.scenario, options.overrides);
  if (!scenario) {
    err << to_text(scenario.error());
    return kExitBadInput;
  }
  for (const auto& problem_of : {security_problem, types_problem, without_problem}) {
    if (const std::string problem = problem_of(*scenario, options); !problem.empty()) {
      err << problem << '\n';
      return kExitBadInput;
    }
  }
  const bool refused = warn(*scenario, err);
  if (options.check_only) return report_check(*scenario, options.scenario, refused, out);
  const std::string folder = options.out.empty() ? "out/" + scenario->name : options.out;
  const auto claimed = prepare_folder(folder);
  if (!claimed) {
    err << claimed.error().why << '\n';
    return kExitSystem;
  }
  return play(*scenario, options, folder, out, err);
}

int report(const ReportOptions& options, std::ostream& out, std::ostream& err) {
  if (!options.explain.empty()) {
    return explain_all(options.folder, options.explain, kExitOk, out, err);
  }
  const auto summary = write_report(options.folder);
  if (!summary) {
    err << summary.error().why << '\n';
    return kExitBadInput;
  }
  out << options.folder << "/report.html\n";
  return kExitOk;
}

}  // namespace skein::run_tool
