// SPDX-License-Identifier: Apache-2.0
#include "skein/htn_tools/search_text.hpp"

#include <algorithm>
#include <map>

namespace skein::htn {

namespace {

constexpr std::size_t kDeepestIndent = 30;
constexpr std::size_t kDepthWidth = 5;
constexpr std::size_t kLastSteps = 10;
constexpr std::size_t kMostNearest = 5;
constexpr std::size_t kMostOpenTasks = 20;
constexpr std::size_t kFewestRecursions = 10;

std::string counted(std::uint64_t count, const std::string& one) {
  return std::to_string(count) + ' ' + one + (count == 1 ? "" : "s");
}

std::string event_text(const TraceEvent& event, const TermStore& store, const TextStyle& style) {
  const std::string task = store.to_text(event.task);
  const std::string detail = event.detail.empty() ? "" : ": " + event.detail;
  switch (event.kind) {
    case TraceKind::kTask:
      return style.mark(style.bold, task) + detail;
    case TraceKind::kBranchFails:
      return style.mark(style.bad, "✗ ") + event.label + " does not hold" + detail;
    case TraceKind::kBranchHolds:
      return style.mark(style.good, "✓ ") + event.label + " holds, " +
             counted(event.count, "reduction") + detail;
    case TraceKind::kReduction:
      return "→ " + event.label + detail;
    case TraceKind::kStep:
      return style.mark(style.good, "● " + task) + detail;
    case TraceKind::kStepFails:
      return style.mark(style.bad, "✗ ") + task + " does not apply" + detail;
    case TraceKind::kBacktrack:
      return style.mark(style.dim, "↩ " + task + ": no way left") + detail;
  }
  return task;
}

void append_steps(const FailurePoint& failure, const TermStore& store, const TextStyle& style,
                  std::string& out) {
  const std::size_t count = failure.steps.size();
  const std::size_t first = count > kLastSteps ? count - kLastSteps : 0;
  if (first > 0) {
    out += "    " + style.mark(style.dim, "… " + counted(first, "step") + " before") + '\n';
  }
  const std::size_t width = std::to_string(count).size();
  for (std::size_t at = first; at < count; ++at) {
    const std::string number = std::to_string(at + 1);
    out += "    " + std::string(width - number.size(), ' ') + style.mark(style.dim, number) + ' ' +
           store.to_text(failure.steps[at].action) + '\n';
  }
}

void append_open_tasks(const FailurePoint& point, const TermStore& store, const TextStyle& style,
                       std::string& out) {
  const std::size_t count = point.open_tasks.size();
  const std::size_t left_out = count > kMostOpenTasks ? count - kMostOpenTasks : 0;
  if (count > 0) out += "  Open there, from the top:\n";
  for (std::size_t level = 0; level < count; ++level) {
    const std::size_t shown = level < kMostOpenTasks / 2 ? level : level - left_out;
    if (left_out > 0 && level == kMostOpenTasks / 2) {
      out += "    " + style.mark(style.dim, "… " + counted(left_out, "task") + " more") + '\n';
      level += left_out;
    }
    out += std::string(4 + 2 * std::min(shown, kDeepestIndent), ' ') +
           store.to_text(point.open_tasks[level]) + '\n';
  }
}

// Tasks of one name inside one another: where domains recur for ever.
void append_recursion(const FailurePoint& point, const TermStore& store, std::string& out) {
  std::map<std::string, std::size_t> counts;
  for (const Term task : point.open_tasks) {
    if (task.is(TermKind::kPair)) ++counts[store.to_text(store.car(task))];
  }
  for (const auto& [name, count] : counts) {
    if (count < kFewestRecursions) continue;
    out += "  (" + name + " …) is open " + std::to_string(count) +
           " times inside itself: the domain may recur for ever there.\n";
  }
}

void append_attempt(const Attempt& attempt, const TermStore& store, const TextStyle& style,
                    std::string& out) {
  out += "    " + style.mark(style.bad, "✗ ") + store.to_text(attempt.task);
  if (!attempt.label.empty()) out += ", " + attempt.label;
  out += attempt.condition.empty() ? "" : ": needs " + attempt.condition;
  out += '\n';
  if (attempt.nearest.empty()) return;
  out += "      " + style.mark(style.dim, "nearest facts:");
  const std::size_t shown = std::min(attempt.nearest.size(), kMostNearest);
  for (std::size_t at = 0; at < shown; ++at) out += ' ' + store.to_text(attempt.nearest[at]);
  if (shown < attempt.nearest.size()) {
    out += style.mark(style.dim, " … and " + std::to_string(attempt.nearest.size() - shown));
  }
  out += '\n';
}

}  // namespace

std::string to_text(const TraceEvent& event, const TermStore& store, const TextStyle& style) {
  const std::string depth = std::to_string(event.depth);
  const std::size_t levels =
      static_cast<std::size_t>(std::min<std::uint64_t>(event.depth, kDeepestIndent));
  const bool of_a_task = event.kind != TraceKind::kTask;
  std::string out(kDepthWidth - std::min(kDepthWidth, depth.size()), ' ');
  out += style.mark(style.dim, depth) + ' ' + std::string(2 * levels + (of_a_task ? 2 : 0), ' ');
  return out + event_text(event, store, style) + '\n';
}

std::string to_text(const FailurePoint& failure, const TermStore& store, const TextStyle& style) {
  std::string out = "  The search came furthest after " + counted(failure.steps.size(), "step") +
                    (failure.steps.empty() ? ".\n" : ":\n");
  append_steps(failure, store, style, out);
  append_open_tasks(failure, store, style, out);
  out += failure.attempts.empty() ? "  No operator and no method was there to try.\n"
                                  : "  Tried there, and why not:\n";
  for (const Attempt& attempt : failure.attempts) append_attempt(attempt, store, style, out);
  return out;
}

std::string standing_text(const FailurePoint& point, const TermStore& store,
                          const TextStyle& style) {
  std::string out = "  The search was cut after " + counted(point.steps.size(), "step") +
                    (point.steps.empty() ? ".\n" : ":\n");
  append_steps(point, store, style, out);
  append_open_tasks(point, store, style, out);
  append_recursion(point, store, out);
  return out;
}

}  // namespace skein::htn
