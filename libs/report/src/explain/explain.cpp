// SPDX-License-Identifier: Apache-2.0
#include "skein/report/explain.hpp"

#include <algorithm>
#include <set>
#include <sstream>

#include "explain/explain_words.hpp"
#include "explain/role_tasks_told.hpp"
#include "skein/foundation/nearest.hpp"
#include "story/chronology.hpp"
#include "story/deliberation.hpp"
#include "text.hpp"

namespace skein::report {

namespace {

std::string window(double from, const std::optional<double>& to) {
  if (!to) return "from " + instant_text(from) + " on";
  if (*to - from < 0.05) return "at " + instant_text(from);
  return fixed_number(from, 1) + " to " + instant_text(*to);
}

std::string asked_text(const GoalRecord& goal) {
  return "mission " + std::to_string(goal.mission) +
         (goal.asked_by.empty() ? "" : ", asked by " + goal.asked_by);
}

void write_goal(std::ostream& out, const GoalStory& goal) {
  out << "  " << goal.first->goal << " " << goal.first->statement << " (" << asked_text(*goal.first)
      << ")\n";
  std::string course;
  for (const auto& [t, state] : goal.states) {
    course += (course.empty() ? "" : ", ") + state + " " + instant_text(t);
  }
  write_line(out, "", course + (goal.why.empty() ? "" : ": " + goal.why));
}

void write_task(std::ostream& out, const Deliberation& told, const Promise& promise) {
  const PlannedRecord& task = *promise.planned;
  out << "  " << task.task << " " << task.type << "\n";
  const GoalStory* goal = told.goal(task.uav, task.goal);
  if (goal != nullptr) {
    write_line(out, "for", std::to_string(task.goal) + " " + goal->first->statement);
    write_line(out, "asked", asked_text(*goal->first));
  }
  write_line(out, "by way of", task.methods);
  write_line(out, "after", task.after.empty() ? "nothing" : task.after);
  write_line(out, "stopped by", task.stop);
  write_line(out, "start",
             window(task.earliest_start, task.latest_start) + " planned, " +
                 actual_text(promise.started) + " actually");
  write_line(out, "end",
             window(task.earliest_end, task.latest_end) + " planned, " + actual_text(promise.over) +
                 " actually" + (promise.outcome.empty() ? "" : " (" + promise.outcome + ")"));
  write_line(out, "because", promise.reason);
  write_line(out, "dates of",
             "revision " + std::to_string(task.revision) + " of the plan, " +
                 instant_text(seconds(task.stamp)));
}

// A whole number among the words of a text: "task 104 overdue" concerns 104, not 10.
bool mentions(const std::string& text, const std::string& number) {
  std::size_t at = text.find(number);
  const auto digit = [&](std::size_t i) {
    return i < text.size() && text[i] >= '0' && text[i] <= '9';
  };
  while (at != std::string::npos) {
    if (!(at > 0 && digit(at - 1)) && !digit(at + number.size())) return true;
    at = text.find(number, at + 1);
  }
  return false;
}

bool concerns(const DecisionRecord& decision, const PlannedRecord& task) {
  const std::string id = std::to_string(task.task), goal = std::to_string(task.goal);
  return mentions(decision.cause, id) || mentions(decision.inputs, id) ||
         mentions(decision.inputs, goal) || mentions(decision.cause, goal);
}

void write_decision(std::ostream& out, const DecisionRecord& r) {
  out << "  " << instant_text(seconds(r.stamp)) << "  operator " << r.applied << "\n";
  write_line(out, "cause", r.cause);
  write_line(out, "inputs", r.inputs);
  write_line(out, "outcome", r.outcome);
  if (r.took > 0) write_line(out, "took", span_text(r.took));
}

std::vector<std::string> uavs_of(const Journal& journal) {
  std::set<std::string> names;
  for (const TelemetryRecord& r : journal.telemetry) names.insert(r.uav);
  for (const GoalRecord& r : journal.goals) names.insert(r.uav);
  for (const PlannedRecord& r : journal.planned) names.insert(r.uav);
  return {names.begin(), names.end()};
}

std::optional<Failure> unknown_uav(const Journal& journal, const std::string& uav) {
  const std::vector<std::string> known = uavs_of(journal);
  if (std::find(known.begin(), known.end(), uav) != known.end()) return std::nullopt;
  return Failure{"no UAV '" + uav + "' in the event log" + did_you_mean(nearest_name(uav, known))};
}

std::string explain_one(const Journal& journal, const Deliberation& told, const Promise& promise) {
  std::ostringstream out;
  out << promise.planned->uav << "\n";
  write_task(out, told, promise);
  bool first = true;
  for (const DecisionRecord& r : journal.decisions) {
    if (r.uav != promise.planned->uav || !concerns(r, *promise.planned)) continue;
    if (first) out << "Decisions that concern it\n";
    first = false;
    write_decision(out, r);
  }
  return out.str();
}

// Nothing for a task that no role asked for.
std::string explain_role_task(const Journal& journal, const std::string& uav, std::uint64_t task) {
  std::ostringstream out;
  for (const RoleTaskStory& story : tell_role_tasks(journal)) {
    if (story.uav == uav && story.task == task) write_role_task(out, story);
  }
  return out.str();
}

std::string explain_all(const Journal& journal, const Deliberation& told, const std::string& uav) {
  std::ostringstream goals, tasks, roles, decisions;
  for (const GoalStory& goal : told.goals) {
    if (goal.uav == uav) write_goal(goals, goal);
  }
  for (const auto& [key, promise] : told.promises) {
    if (key.first == uav) write_task(tasks, told, promise);
  }
  for (const RoleTaskStory& story : tell_role_tasks(journal)) {
    if (story.uav == uav) write_role_task(roles, story);
  }
  for (const DecisionRecord& r : journal.decisions) {
    if (r.uav == uav) write_decision(decisions, r);
  }
  const auto section = [](const char* title, const std::string& text) {
    return title + (text.empty() ? std::string(": none\n") : "\n" + text);
  };
  return uav + "\n" + section("High-level tasks", goals.str()) +
         section("Elementary tasks", tasks.str()) +
         (roles.str().empty() ? "" : section("Tasks of its roles", roles.str())) +
         section("Decisions", decisions.str());
}

}  // namespace

Result<std::string, Failure> explain(const Journal& journal, const std::string& uav,
                                     std::optional<std::uint64_t> task) {
  if (auto unknown = unknown_uav(journal, uav)) return tl::unexpected(std::move(*unknown));
  const Deliberation told = tell_deliberation(journal);
  if (!task) return explain_all(journal, told, uav);
  const auto found = told.promises.find({uav, *task});
  if (found == told.promises.end()) {
    if (const std::string role = explain_role_task(journal, uav, *task); !role.empty()) {
      return uav + "\n" + role;
    }
    return failure("no plan of " + uav + " ever held a task " + std::to_string(*task) +
                   ", and no role asked for it");
  }
  return explain_one(journal, told, found->second);
}

}  // namespace skein::report
