// SPDX-License-Identifier: Apache-2.0
// Elementary tasks in the text form of the seeds (TASKREQ …). Source: spec 3.4.
#include <algorithm>
#include <cctype>
#include <map>

#include "skein/foundation/shortest_text.hpp"
#include "skein/mission/elementary_plan.hpp"

namespace skein::mission {

namespace {

using Ends = std::map<executive::TaskId, Interval>;

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

bool is_plain(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 ||
           std::string_view("-_+.:/?!*<>=").find(static_cast<char>(c)) != std::string_view::npos;
  });
}

// A symbol when it can be one, else a string between quotes.
std::string symbol(std::string_view text) {
  if (is_plain(text)) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

std::string span(Duration d) { return d == Duration::max() ? "UNLIMITED" : to_text(d); }

std::string interval(std::string_view head, const Interval& i) {
  return " (" + std::string(head) + " " + span(i.least) + " " + span(i.most) + ")";
}

std::string constraints(const TimeConstraints& time) {
  std::string text = " (TIME-CONSTRAINTS";
  for (const auto& bound : {time.start_before, time.start_after, time.end_before, time.end_after}) {
    text += bound ? " " + to_text(*bound) : " NIL";
  }
  return text + ")";
}

std::string dependences(const std::vector<Dependence>& all) {
  std::string list;
  for (const Dependence& one : all) {
    list += (list.empty() ? "(" : " (") + upper(to_text(one.kind)) + " " + to_text(one.task) + ")";
  }
  return " (DEPENDENCES (" + list + "))";
}

std::string way_points(const std::vector<double>& numbers) {
  std::string list;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    list += (i == 0 ? "(TERM" : " (TERM");
    for (std::size_t k = i; k < i + 3; ++k) list += " " + shortest_text(numbers[k]);
    list += ")";
  }
  return " (WPLIST (" + list + "))";
}

std::string parameter(const executive::Parameter& one) {
  if (one.name == "waypoints" && one.text.empty() && one.numbers.size() % 3 == 0) {
    return way_points(one.numbers);
  }
  std::string text = " (" + (is_plain(one.name) ? upper(one.name) : symbol(one.name));
  if (!one.text.empty()) text += " " + symbol(one.text);
  for (const double number : one.numbers) text += " " + shortest_text(number);
  return text + ")";
}

std::string names(std::string_view head, const std::vector<std::string>& all) {
  std::string text = " (" + std::string(head);
  for (const std::string& name : all) text += " " + symbol(name);
  return text + ")";
}

std::string parameters(const ElementaryTask& task) {
  std::string text = " (PARAMS";
  for (const executive::Parameter& one : task.parameters.all()) text += parameter(one);
  if (task.synchronisation) {
    const executive::Synchronisation& sync = *task.synchronisation;
    text += " (SYNC-ID " + std::to_string(sync.id) + ")" + names("SENDERS", sync.senders) +
            names("RECEIVERS", sync.receivers);
    if (sync.deadline) text += " (DEADLINE " + to_text(*sync.deadline) + ")";
  }
  return text + ")";
}

std::string head(std::string_view name, executive::TaskId id) {
  return "(TASKREQ " + upper(name) + " " + to_text(id);
}

std::string task_line(const ElementaryTask& task) {
  return head(task.name, task.id) + dependences(task.dependences) + parameters(task) +
         interval("START-TIME", task.start) + interval("DURATION", task.duration) +
         constraints(task.time) + " " + to_text(task.origin) + ")";
}

Interval later_of(const Interval& a, const Interval& b) {
  return {std::max(a.least, b.least), std::max(a.most, b.most)};
}

// When what ends the task comes about: as far as the ends of the tasks it waits for are known.
Interval stop_time(const ElementaryTask& task, const Ends& ends) {
  Interval time{task.start.least, Duration::max()};
  bool known = false;
  for (const Dependence& one : task.stop) {
    const auto found = ends.find(one.task);
    if (one.kind == DependenceKind::kRunning || found == ends.end()) continue;
    time = known ? later_of(time, found->second) : found->second;
    known = true;
  }
  return time;
}

std::string stop_line(const ElementaryTask& task, const Ends& ends) {
  return head("TASK-STOP-" + upper(task.type), task.id) + dependences(task.stop) + " (PARAMS)" +
         interval("START-TIME", stop_time(task, ends)) + interval("DURATION", {}) +
         constraints({}) + " " + to_text(task.origin) + ")";
}

std::string lines(const ElementaryTask& task, const Ends& ends) {
  return task_line(task) + (task.stop.empty() ? "" : "\n" + stop_line(task, ends));
}

}  // namespace

std::string to_taskreq(const ElementaryTask& task) { return lines(task, {}); }

std::string to_taskreq(const ElementaryPlan& plan) {
  Ends ends;
  for (const ElementaryTask& task : plan.tasks) {
    if (!task.stop.empty()) continue;
    ends[task.id] = {task.start.least + task.duration.least, task.start.most + task.duration.most};
  }
  std::string text;
  for (const ElementaryTask& task : plan.tasks) text += lines(task, ends) + "\n";
  return text;
}

}  // namespace skein::mission
