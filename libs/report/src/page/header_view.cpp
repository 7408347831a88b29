// SPDX-License-Identifier: Apache-2.0
// The head of the page: verdict, figures, expectations.
#include <algorithm>

#include "page/views.hpp"

namespace skein::report {

namespace {

void write_tile(Markup& out, std::string_view value, std::string_view name,
                std::string_view note = {}) {
  out.open("div", {{"class", "tile"}});
  out.element("div", {{"class", "value"}}, value);
  out.element("div", {{"class", "name"}}, name);
  if (!note.empty()) out.element("div", {{"class", "note"}}, note);
  out.close();
}

Span mission_span(const Run& run) {
  Span span = run.story.time;
  for (const MissionRecord& r : run.journal.missions) {
    (r.state == "started" ? span.from : span.to) = seconds(r.stamp);
  }
  return span;
}

std::string mission_outcome(const Run& run) {
  if (run.journal.missions.empty()) return "no end in the log";
  const std::string& last = run.journal.missions.back().state;
  return last == "started" ? "no end in the log" : last;
}

void write_verdict(Markup& out, const Run& run) {
  const Statistics& f = run.figures;
  const std::size_t all = f.passed + f.failed;
  const char* style = all == 0 ? "verdict none" : f.ok() ? "verdict passed" : "verdict failed";
  const std::string text =
      all == 0 ? "nothing expected"
      : f.ok() ? "passed"
               : std::to_string(f.failed) + " of " + std::to_string(all) + " failed";
  out.element("span", {{"class", style}}, text);
}

void write_circumstances(Markup& out, const RunInfo& info) {
  out.open("p", {{"class", "circumstances"}});
  const auto item = [&](std::string_view name, const std::string& value) {
    if (value.empty()) return;
    out.open("span").element("b", {}, name).text(" " + value).close().text(" ");
  };
  item("epoch", info.epoch);
  item("runtime", info.runtime == RuntimeKind::kDds ? "DDS" : "virtual time");
  item("rate", info.rate > 0 ? "× " + short_number(info.rate) : "free");
  item("seed", std::to_string(info.seed));
  item("skein", info.version);
  out.close();
}

void write_separation_tile(Markup& out, const Run& run) {
  const std::optional<Separation>& s = run.figures.separation;
  if (!s) return write_tile(out, "–", "least separation", "never two in the air");
  const std::string pair = run.story.uavs[s->first].name + " – " + run.story.uavs[s->second].name;
  write_tile(out, length_text(s->metres), "least separation", pair + " at " + clock_text(s->t));
}

void write_message_tile(Markup& out, const Run& run) {
  std::size_t sent = 0, received = 0, failed = 0;
  for (const auto& [key, f] : run.figures.channels) {
    sent += f.sent;
    received += f.received;
    failed += f.lost + f.expired;
  }
  write_tile(out, grouped(sent), "event messages sent",
             grouped(received) + " received, " + grouped(failed) + " lost or expired");
}

void write_task_tile(Markup& out, const Run& run) {
  std::size_t tasks = 0, ended = 0, aborted = 0;
  for (const UavFigures& f : run.figures.uavs) {
    tasks += f.tasks;
    ended += f.ended;
    aborted += f.aborted;
  }
  write_tile(out, grouped(tasks), "tasks",
             grouped(ended) + " ended, " + grouped(aborted) + " aborted");
}

void write_alarm_tile(Markup& out, const Run& run) {
  const auto& alarms = run.story.alarms;
  const auto in_state = [&](AlarmState state) {
    return static_cast<std::size_t>(std::count_if(
        alarms.begin(), alarms.end(), [state](const AlarmStory& a) { return a.state == state; }));
  };
  write_tile(out, grouped(alarms.size()), alarms.size() == 1 ? "alarm" : "alarms",
             grouped(in_state(AlarmState::kConfirmed)) + " confirmed, " +
                 grouped(in_state(AlarmState::kInfirmed)) + " infirmed");
}

}  // namespace

void write_header(Markup& out, const Run& run) {
  const Span mission = mission_span(run);
  const double duration = std::max(mission.to - mission.from, 0.0);
  double distance = 0.0;
  for (const UavFigures& f : run.figures.uavs) distance += f.distance;

  out.open("header");
  out.open("div", {{"class", "headline"}});
  out.element("h1", {}, run.info.scenario.empty() ? "Skein run" : run.info.scenario);
  write_verdict(out, run);
  out.close();
  write_circumstances(out, run.info);
  out.open("div", {{"class", "tiles"}});
  write_tile(out, clock_text(duration), "mission time", mission_outcome(run));
  const double speed = run.info.wall_seconds > 0 ? duration / run.info.wall_seconds : 0.0;
  write_tile(out, run.info.wall_seconds > 0 ? span_text(run.info.wall_seconds) : "–", "wall time",
             speed > 0 ? short_number(speed, speed < 10 ? 1 : 0) + " × real time" : "");
  write_tile(out, std::to_string(run.story.uavs.size()), "UAVs", length_text(distance) + " flown");
  write_separation_tile(out, run);
  write_task_tile(out, run);
  write_alarm_tile(out, run);
  write_message_tile(out, run);
  write_tile(out, grouped(run.figures.lines), "log lines",
             run.journal.unreadable > 0 ? grouped(run.journal.unreadable) + " unreadable" : "");
  out.close();
  out.close().line_break();
}

void write_expectations(Markup& out, const Run& run) {
  out.open("section", {{"class", "card expectations"}});
  out.element("h2", {}, "Expectations");
  if (run.journal.expectations.empty()) {
    out.element("p", {{"class", "empty"}}, "The log holds no checked expectation.");
    out.close();
    return;
  }
  out.open("table").open("tbody");
  std::vector<const ExpectationRecord*> ordered;
  for (const ExpectationRecord& e : run.journal.expectations) ordered.push_back(&e);
  std::stable_partition(ordered.begin(), ordered.end(),
                        [](const ExpectationRecord* e) { return !e->passed; });
  for (const ExpectationRecord* e : ordered) {
    out.open("tr", {{"class", e->passed ? "passed" : "failed"}});
    out.element("td", {{"class", "mark"}}, e->passed ? "✓" : "✗");
    out.open("td").element("div", {{"class", "what"}}, e->name);
    out.element("div", {{"class", "seen"}}, e->seen).close();
    out.close();
  }
  out.close().close().close().line_break();
}

}  // namespace skein::report
