// SPDX-License-Identifier: Apache-2.0
#include "facts.hpp"

#include <functional>

#include "skein/scenario/measures.hpp"

namespace skein::compare_tool {

namespace {

using journal::Record;
using Facts = std::map<std::string, Fact>;

/// The nearest number: a hundredth stays a hundredth.
double seconds_of(MissionTime at) { return static_cast<double>(at.count()) / 1e9; }

std::string text_of(const Record& record, std::string_view key) {
  return std::string(record.text(key));
}

std::string id_of(const Record& record, std::string_view key) {
  return std::to_string(static_cast<std::int64_t>(record.number(key)));
}

std::string because(const Record& record) {
  const std::string why = text_of(record, "why");
  return why.empty() ? "" : ": " + why;
}

void see_outcome(const Record& record, Facts& facts) {
  if (record.kind() == "mission" && record.text("state") != "started")
    facts["mission"] = {text_of(record, "state"), seconds_of(record.at()), {}};
  if (record.kind() == "phase")
    facts["phase " + text_of(record, "name")] = {"entered", seconds_of(record.at()), {}};
  if (record.kind() == "alarm")
    facts["alarm " + id_of(record, "alarm")] = {
        text_of(record, "state"), seconds_of(record.at()), {}};
}

void see_expectation(const Record& record, Facts& facts) {
  if (record.kind() != "expectation") return;
  facts[text_of(record, "name")] = {
      record.truth("passed") ? "met" : "not met: " + text_of(record, "seen"), {}, {}};
}

/// The last state, and when it was entered.
void see_goal(const Record& record, Facts& facts) {
  if (record.kind() != "goal") return;
  facts[text_of(record, "uav") + " goal " + id_of(record, "goal") + " " +
        text_of(record, "statement")] = {
      text_of(record, "state") + because(record), seconds_of(record.at()), {}};
}

void see_task(const Record& record, Facts& facts) {
  if (record.kind() != "task") return;
  const std::string name =
      text_of(record, "uav") + " task " + id_of(record, "task") + " " + text_of(record, "type");
  const std::string state = text_of(record, "state");
  const double at = seconds_of(record.at());
  if (state == "started") facts.try_emplace(name + ", begun", Fact{"", at, {}});
  if (state != "ended" && state != "aborted") return;
  const std::string reason = text_of(record, "reason");
  facts[name + ", over"] = {state + (reason.empty() ? "" : ": " + reason), at, {}};
}

void count(Facts& facts, const std::string& name) {
  Fact& fact = facts[name];
  fact.value = fact.value.value_or(0) + 1;
  fact.text = "times";
}

void see_refusal(const Record& record, Facts& facts) {
  const std::string& kind = record.kind();
  const std::string uav = text_of(record, "uav");
  if (kind == "request" && !record.truth("accepted"))
    count(facts, uav + " refuses " + text_of(record, "request") + because(record));
  if (kind == "command" && (record.text("state") == "refused" || record.text("state") == "expired"))
    count(facts, "command to " + uav + " " + text_of(record, "state") + ": " +
                     text_of(record, "what") + because(record));
  if (kind == "answer" && !record.truth("planned") && !record.truth("evaluated"))
    count(facts, uav + " cannot plan mission " + id_of(record, "mission") + because(record));
}

void see_decision(const Record& record, Facts& facts) {
  see_refusal(record, facts);
  const std::string& kind = record.kind();
  const std::string uav = text_of(record, "uav");
  if (kind == "decision") count(facts, uav + " decides " + text_of(record, "operator"));
  if (kind == "degree") {
    std::string& told = facts[uav + " degree"].text;
    told += (told.empty() ? "" : ", then ") + id_of(record, "degree");
  }
  if (kind == "owner")
    facts["team task " + id_of(record, "task")] = {
        text_of(record, "stage") + (record.text("owners").empty() ? "" : " by ") +
            text_of(record, "owners"),
        seconds_of(record.at()),
        {}};
}

Section section(const std::string& name, const recording::Run& run,
                const std::function<void(const Record&, Facts&)>& see) {
  Section section{name, {}};
  for (const Record& record : run.records) see(record, section.facts);
  return section;
}

Section measures(const recording::Run& run) {
  Section section{"measures", {}};
  for (const scenario::NamedMeasure& one : scenario::measures_of_any_run()) {
    const auto measured = scenario::measure(one.what, run.records);
    if (measured) {
      section.facts[one.name] = {
          std::string(scenario::unit_of(one.what.quantity)), {}, measured->value};
    } else {
      section.facts[one.name] = {measured.error(), {}, {}};
    }
  }
  return section;
}

}  // namespace

std::vector<Section> facts_of(const recording::Run& run) {
  Section outcome = section("outcome", run, see_outcome);
  outcome.facts["last line"] = {"", seconds_of(run.until()), {}};
  return {std::move(outcome),
          section("expectations", run, see_expectation),
          measures(run),
          section("goals", run, see_goal),
          section("tasks", run, see_task),
          section("decisions", run, see_decision)};
}

}  // namespace skein::compare_tool
