// SPDX-License-Identifier: Apache-2.0
#include "skein/storm_tool/judge.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <sstream>

#include "skein/assembly/assembly.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/foundation/nearest.hpp"
#include "skein/laws/contact.hpp"
#include "skein/laws/healing.hpp"
#include "skein/laws/laws.hpp"
#include "skein/laws/protocol.hpp"
#include "skein/scenario_setup/overrides.hpp"
#include "skein/workers/workers.hpp"

namespace skein::storm_tool {

namespace {

using journal::Record;

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  std::replace(text.begin(), text.end(), '\t', ' ');
  return text;
}

std::vector<Record> play(const scenario::Scenario& scenario) {
  std::vector<Record> records;
  const assembly::NodeMaker make_node(scenario);
  node::run_virtual(make_node.roster(), std::cref(make_node), assembly::virtual_config(scenario),
                    [&](const Record& record) { records.push_back(record); });
  std::stable_sort(records.begin(), records.end(),
                   [](const auto& a, const auto& b) { return a.at() < b.at(); });
  return records;
}

void count_goals(const laws::History& history, std::ostream& out) {
  int goals = 0, achieved = 0, failed = 0;
  for (const auto& [name, uav] : history.uavs) {
    for (const auto& [id, goal] : uav.goals) {
      ++goals;
      achieved += goal.state() == "achieved" ? 1 : 0;
      failed += goal.state() == "failed" ? 1 : 0;
    }
  }
  const auto near = laws::nearest(history);
  out << "run\t" << goals << '\t' << achieved << '\t' << failed << '\t' << history.end << '\t'
      << (near ? near->distance : -1) << '\n';
}

void keep_log(const std::vector<Record>& records, const Case& one, const std::string& folder) {
  std::filesystem::create_directories(folder);
  std::ofstream out(std::filesystem::path(folder) /
                    (std::filesystem::path(one.name).stem().string() + ".jsonl"));
  for (const Record& record : records) out << journal::to_json(record) << '\n';
}

bool wants(const JudgeOptions& options, const char* law) {
  return options.only.empty() ||
         std::find(options.only.begin(), options.only.end(), law) != options.only.end();
}

std::string text_of(const std::vector<Record>& records) {
  std::string text;
  for (const Record& record : records) text += journal::to_json(record) + "\n";
  return text;
}

std::vector<laws::Violation> violations_of(const scenario::Scenario& scenario,
                                           const std::vector<Record>& records,
                                           const JudgeOptions& options) {
  std::vector<laws::Violation> all = laws::broken_laws(scenario, records, options.only);
  if (wants(options, "protocol")) {
    for (const std::string& breach : laws::broken_protocol(records, laws::command_limit(scenario)))
      all.push_back({"protocol", 0, "", 0, breach});
  }
  if (wants(options, "healing")) {
    for (const std::string& breach : laws::broken_healing(records, laws::healing_limits(scenario)))
      all.push_back({"healing", 0, "", 0, breach});
  }
  if (wants(options, "contact")) {
    for (const std::string& breach : laws::broken_contacts(scenario, records))
      all.push_back({"contact", 0, "", 0, breach});
  }
  if (options.twice && wants(options, "same-bytes") && text_of(play(scenario)) != text_of(records))
    all.push_back({"same-bytes", 0, "", 0, "played again, the event log is another"});
  return all;
}

// The child's report, a line a fact.
std::string report_of(const Case& one, const JudgeOptions& options) {
  std::ostringstream out;
  auto scenario = scenario::read_scenario_text(one.yaml, one.file);
  Diagnostics problems = scenario ? scenario_setup::apply({}, *scenario) : scenario.error();
  if (problems.empty()) problems = assembly::check_assembly(*scenario);
  if (!problems.empty()) return "invalid\t" + one_line(to_text(problems)) + "\n";
  const std::vector<Record> records = play(*scenario);
  if (!options.log.empty()) keep_log(records, one, options.log);
  count_goals(laws::history_of(*scenario, records), out);
  for (const laws::Violation& broken : violations_of(*scenario, records, options)) {
    out << "broken\t" << broken.law << '\t' << broken.at << '\t' << broken.uav << '\t'
        << broken.goal << '\t' << one_line(broken.sentence) << '\n';
  }
  return out.str();
}

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, '\t');) fields.push_back(field);
  return fields;
}

Verdict verdict_from(const std::string& report) {
  Verdict verdict;
  std::istringstream in(report);
  for (std::string line; std::getline(in, line);) {
    const std::vector<std::string> f = fields_of(line);
    if (f.size() == 2 && f[0] == "invalid") {
      verdict.valid = false;
      verdict.problem = f[1];
    } else if (f.size() == 6 && f[0] == "run") {
      verdict.goals = std::stoi(f[1]);
      verdict.achieved = std::stoi(f[2]);
      verdict.failed = std::stoi(f[3]);
      verdict.flown = std::stod(f[4]);
      verdict.nearest = std::stod(f[5]);
    } else if (f.size() == 6 && f[0] == "broken") {
      verdict.violations.push_back({f[1], std::stod(f[2]), f[3], std::stoll(f[4]), f[5]});
    }
  }
  return verdict;
}

workers::Work work_of(Case one, const JudgeOptions& options) {
  return [one = std::move(one), &options] { return report_of(one, options); };
}

Verdict verdict_of(const workers::Outcome& outcome, const JudgeOptions& options) {
  Verdict verdict = verdict_from(outcome.said);
  if (outcome.end == workers::Outcome::End::kDone || !wants(options, "crash")) return verdict;
  const bool hangs = outcome.end == workers::Outcome::End::kHung;
  verdict.violations.push_back({hangs ? "hang" : "crash", 0, "", 0, outcome.why});
  return verdict;
}

}  // namespace

void judge(const std::function<bool(Case&)>& next, const JudgeOptions& options,
           const std::function<void(const Case&, const Verdict&)>& tell) {
  std::map<std::uint64_t, Case> cases;  // those under way
  std::uint64_t given = 0;
  const auto next_work = [&]() -> std::optional<workers::Work> {
    Case one;
    if (!next(one)) return std::nullopt;
    cases.emplace(given++, one);
    return work_of(std::move(one), options);
  };
  workers::do_apart(next_work, {options.jobs, options.patience},
                    [&](std::uint64_t number, const workers::Outcome& outcome) {
                      const Case one = std::move(cases.extract(number).mapped());
                      tell(one, verdict_of(outcome, options));
                    });
}

namespace {

struct Judged {
  std::vector<std::string> names;
  std::string says;
};

/// The laws of truth, and what else is judged.
std::vector<Judged> all_judged() {
  std::vector<Judged> all;
  for (const auto& law : laws::all_laws()) all.push_back({{law.name}, law.says});
  all.push_back({{"protocol"},
                 "tasks go through their states, commands are settled once, messages come once and "
                 "in order"});
  all.push_back(
      {{"healing"}, "what was waiting comes soon after a link is back, no event is lost unsaid"});
  all.push_back({{"contact"}, "nobody is in contact whom the radio does not connect"});
  all.push_back({{"crash", "hang"}, "a run ends"});
  all.push_back({{"same-bytes"}, "played again, the event log is the same (with --twice)"});
  return all;
}

std::vector<std::string> law_names() {
  std::vector<std::string> names;
  for (const Judged& one : all_judged())
    names.insert(names.end(), one.names.begin(), one.names.end());
  return names;
}

}  // namespace

std::vector<std::string> law_lines() {
  std::vector<std::string> lines;
  for (const Judged& one : all_judged()) lines.push_back(joined(one.names, ", ") + ": " + one.says);
  return lines;
}

std::string problem_of_laws(const std::vector<std::string>& names) {
  const std::vector<std::string> known = law_names();
  std::string problem;
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    const std::string nearest = nearest_name(name, known);
    problem += "--law: there is no law '" + name + "'" +
               (nearest.empty() ? "" : "; did you mean '" + nearest + "'?") +
               " (--laws lists them)\n";
  }
  return problem;
}

Verdict judge_one(const Case& one, const JudgeOptions& options) {
  return verdict_of(workers::do_apart(work_of(one, options), {1, options.patience}), options);
}

}  // namespace skein::storm_tool
