// SPDX-License-Identifier: Apache-2.0
#include "skein/storm_tool/judge.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <sstream>

#include "over_dds.hpp"
#include "skein/assembly/assembly.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/foundation/nearest.hpp"
#include "skein/laws/judgement.hpp"
#include "skein/scenario_setup/overrides.hpp"
#include "skein/storm_tool/recorded.hpp"
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

// The child's report, a line a fact.
std::string report_of(const Verdict& verdict) {
  std::ostringstream out;
  if (!verdict.valid) return "invalid\t" + one_line(verdict.problem) + "\n";
  out << "run\t" << verdict.goals << '\t' << verdict.achieved << '\t' << verdict.failed << '\t'
      << verdict.flown << '\t' << verdict.nearest << '\n';
  for (const laws::Violation& broken : verdict.violations) {
    out << "broken\t" << broken.law << '\t' << broken.at << '\t' << broken.uav << '\t'
        << broken.goal << '\t' << one_line(broken.sentence) << '\n';
  }
  return out.str();
}

Verdict invalid(std::string problem) {
  Verdict verdict;
  verdict.valid = false;
  verdict.problem = std::move(problem);
  return verdict;
}

Verdict play_and_judge(const Case& one, const JudgeOptions& options) {
  auto scenario = scenario::read_scenario_text(one.yaml, one.file);
  Diagnostics problems = scenario ? scenario_setup::apply({}, *scenario) : scenario.error();
  if (problems.empty()) problems = assembly::check_assembly(*scenario);
  if (!problems.empty()) return invalid(to_text(problems));
  if (options.over_dds_at) return judged_over_dds(one, options);
  const std::vector<Record> records = play(*scenario);
  if (!options.log.empty()) keep_log(records, one, options.log);
  Verdict verdict = verdict_on(*scenario, records, {options.only});
  if (options.twice && wants(options, "same-bytes") && text_of(play(*scenario)) != text_of(records))
    verdict.violations.push_back(
        {"same-bytes", 0, "", 0, "played again, the event log is another"});
  return verdict;
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
  return [one = std::move(one), &options] { return report_of(play_and_judge(one, options)); };
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

std::vector<laws::Statement> all_judged() {
  std::vector<laws::Statement> all = laws::judged_by();
  all.push_back({{"crash", "hang"}, "a run ends"});
  all.push_back({{"same-bytes"}, "played again, the event log is the same (with --twice)"});
  return all;
}

std::vector<std::string> law_names() {
  std::vector<std::string> names;
  for (const laws::Statement& one : all_judged())
    names.insert(names.end(), one.names.begin(), one.names.end());
  return names;
}

}  // namespace

void print_laws(std::ostream& out) {
  for (const laws::Statement& one : all_judged())
    out << joined(one.names, ", ") << ": " << one.says << '\n';
}

std::string problem_of_laws(const std::vector<std::string>& names) {
  const std::vector<std::string> known = law_names();
  std::string problem;
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    problem += "--law: there is no law '" + name + "'" + did_you_mean(nearest_name(name, known)) +
               " (--laws lists them)\n";
  }
  return problem;
}

Verdict judge_one(const Case& one, const JudgeOptions& options) {
  return verdict_of(workers::do_apart(work_of(one, options), {1, options.patience}), options);
}

}  // namespace skein::storm_tool
