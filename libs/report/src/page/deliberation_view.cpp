// SPDX-License-Identifier: Apache-2.0
// What was asked, decided and planned, as tables; planned ways on the map.
#include <algorithm>

#include "page/table.hpp"
#include "page/views.hpp"

namespace skein::report {

namespace {

constexpr std::size_t kMostRows = 400;

std::string dates(double from, const std::optional<double>& to) {
  const std::string first = fixed_number(from, 1);
  return to ? first + " – " + fixed_number(*to, 1) : first + " –";
}

std::string date(const std::optional<double>& t) { return t ? fixed_number(*t, 1) : "–"; }

// Within what was planned, or by how much outside.
std::string gap(const std::optional<double>& t, double from, const std::optional<double>& to) {
  if (!t) return "";
  if (*t < from - 0.05) return " (" + fixed_number(from - *t, 1) + " early)";
  if (to && *t > *to + 0.05) return " (" + fixed_number(*t - *to, 1) + " late)";
  return "";
}

std::string course(const GoalStory& goal) {
  std::string text;
  for (const auto& [t, state] : goal.states) {
    text += (text.empty() ? "" : " → ") + state + " " + clock_text(t);
  }
  return text;
}

void write_task_row(Markup& out, const Run& run, const Promise& promise) {
  const PlannedRecord& p = *promise.planned;
  const GoalStory* goal = run.plans.goal(p.uav, p.goal);
  const std::string statement = goal != nullptr ? goal->first->statement : "";
  out.open("tr");
  write_cells(out, {std::to_string(p.task) + " " + p.type, std::to_string(p.goal) + " " + statement,
                    p.methods, p.after + (p.stop.empty() ? "" : " · stopped by " + p.stop),
                    dates(p.earliest_start, p.latest_start),
                    date(promise.started) + gap(promise.started, p.earliest_start, p.latest_start),
                    dates(p.earliest_end, p.latest_end),
                    date(promise.over) + gap(promise.over, p.earliest_end, p.latest_end),
                    promise.outcome + (promise.reason.empty() ? "" : ": " + promise.reason)});
  out.close();
}

void write_tasks_of(Markup& out, const Run& run, const UavStory& uav) {
  const auto first = run.plans.promises.lower_bound({uav.name, 0});
  if (first == run.plans.promises.end() || first->first.first != uav.name) return;
  open_table(out, "Elementary tasks of " + uav.name + ": planned against done [s]",
             {"task", "high-level task", "methods", "waits for", "start planned", "started",
              "end planned", "over", "outcome"});
  std::size_t rows = 0;
  for (auto one = first; one != run.plans.promises.end() && one->first.first == uav.name; ++one) {
    if (++rows <= kMostRows) write_task_row(out, run, one->second);
  }
  close_table(out);
}

}  // namespace

void write_goal_table(Markup& out, const Run& run) {
  if (run.plans.goals.empty()) return;
  open_table(out, "High-level tasks",
             {"UAV", "id", "statement", "mission", "asked by", "course", "why"}, Cells::kSentences);
  for (std::size_t i = 0; i < std::min(run.plans.goals.size(), kMostRows); ++i) {
    const GoalStory& goal = run.plans.goals[i];
    out.open("tr");
    write_uav_name(out, run.story.uav_index(goal.uav).value_or(0), goal.uav);
    write_cells(
        out, {std::to_string(goal.first->goal), goal.first->statement,
              std::to_string(goal.first->mission), goal.first->asked_by, course(goal), goal.why});
    out.close();
  }
  close_table(out);
}

void write_decision_table(Markup& out, const Run& run) {
  if (run.journal.decisions.empty()) return;
  open_table(out, "Decisions: why each UAV did what it did",
             {"time", "UAV", "operator", "cause", "inputs", "outcome", "took"}, Cells::kSentences);
  for (std::size_t i = 0; i < std::min(run.journal.decisions.size(), kMostRows); ++i) {
    const DecisionRecord& r = run.journal.decisions[i];
    out.open("tr", {{"data-t", seconds(r.stamp)}});
    write_cells(out, {clock_text(seconds(r.stamp))});
    write_uav_name(out, run.story.uav_index(r.uav).value_or(0), r.uav);
    write_cells(out,
                {r.applied, r.cause, r.inputs, r.outcome, r.took > 0 ? span_text(r.took) : "–"});
    out.close();
  }
  close_table(out);
}

void write_explained_tasks(Markup& out, const Run& run) {
  for (const UavStory& uav : run.story.uavs) write_tasks_of(out, run, uav);
}

void write_planned_ways(Markup& out, const Run& run, const MapFrame& frame) {
  for (const auto& [key, promise] : run.plans.promises) {
    const PlannedRecord& p = *promise.planned;
    const std::optional<std::size_t> uav = run.story.uav_index(p.uav);
    if (p.way.size() < 2 || !uav) continue;
    std::vector<Point> points;
    for (const Position& position : p.way) points.push_back(frame(position));
    out.open("path",
             {{"class", (promise.started ? "planned " : "planned never ") + colour_class(*uav)},
              {"d", path_data(points)}});
    out.title(p.uav + ": way planned for " + std::to_string(p.task) + " " + p.type +
              (promise.started ? "" : ", not flown"));
    out.close();
  }
}

}  // namespace skein::report
