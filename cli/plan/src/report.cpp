// SPDX-License-Identifier: Apache-2.0
#include "report.hpp"

#include <array>
#include <cstdio>

#include "skein/htn_tools/plan_text.hpp"
#include "skein/htn_tools/search_text.hpp"

namespace skein::plan_tool {

namespace {

using htn::Outcome;
using htn::Plan;
using htn::TextStyle;
using htn::Verdict;

std::string counted(std::uint64_t count, const std::string& one) {
  return std::to_string(count) + ' ' + one + (count == 1 ? "" : "s");
}

std::string decimal(double value, const char* unit) {
  std::array<char, 64> text{};
  const int digits = value < 10 ? 2 : value < 100 ? 1 : 0;
  const int length = std::snprintf(text.data(), text.size(), "%.*f %s", digits, value, unit);
  return {text.data(), static_cast<std::size_t>(length)};
}

std::string duration(double seconds) {
  return seconds < 1 ? decimal(seconds * 1e3, "ms") : decimal(seconds, "s");
}

std::size_t shown_steps(const Plan& plan, bool internal) {
  std::size_t count = 0;
  for (const htn::Step& step : plan.steps) count += internal || !step.internal ? 1 : 0;
  return count;
}

std::string size_text(const Plan& plan, const ReportOptions& options) {
  const std::size_t shown = shown_steps(plan, options.internal);
  std::string out = counted(shown, "step");
  if (shown < plan.steps.size()) {
    out += " and " + std::to_string(plan.steps.size() - shown) + " internal";
  }
  return out + ", cost " + to_text(plan.cost);
}

std::string verdict_text(const Outcome& outcome, const ReportOptions& options) {
  const TextStyle& style = options.style;
  std::string found = "no plan";
  if (outcome.plans.size() == 1) found = "plan, " + size_text(outcome.plans.front(), options);
  if (outcome.plans.size() > 1) found = counted(outcome.plans.size(), "plan");
  switch (outcome.verdict) {
    case Verdict::kPlan:
      return style.mark(style.good, found);
    case Verdict::kNoPlan:
      return style.mark(style.bad,
                        "there is no plan" + (outcome.why.empty() ? "" : ": " + outcome.why));
    case Verdict::kLimit:
      return style.mark(style.accent, "cut: " + outcome.why + options.bound + "; so far: " + found);
    default:
      return style.mark(style.bad, "error: " + outcome.why);
  }
}

std::string statistics_text(const htn::PlanningReport& report, const Outcome& outcome) {
  const htn::Statistics& counts = outcome.statistics;
  return "  " + counted(counts.expansions, "expansion") + ", " +
         counted(counts.inferences, "inference") + ", depth " + std::to_string(counts.deepest) +
         "; planned in " + duration(report.seconds) + ", started and read in " +
         duration(report.reading_seconds) + "; " + decimal(report.memory_mb, "MB");
}

}  // namespace

std::string report_text(const htn::PlanningReport& report, const Outcome& outcome,
                        const htn::TermStore& store, const ReportOptions& options) {
  const TextStyle& style = options.style;
  std::string out = style.mark(style.bold, report.problem);
  if (!report.domain.empty()) out += " (" + report.domain + ')';
  out += ": " + verdict_text(outcome, options) + '\n';
  const htn::PlanTextOptions shown{options.internal, style, options.states};
  std::size_t number = 0;
  for (const Plan& plan : outcome.plans) {
    if (outcome.plans.size() > 1) {
      out += ' ' + style.mark(style.bold, "plan " + std::to_string(++number)) + ": " +
             size_text(plan, options) + '\n';
    }
    out += options.tree ? tree_text(plan, store, shown) : steps_text(plan, store, shown);
  }
  if (outcome.plans.size() > 1 && outcome.repeats_left_out > 0) {
    out += "  Of equal tasks that may be done in any order one is tried first, " +
           counted(outcome.repeats_left_out, "time") +
           ": plans that only repeat these by other choices are left out.\n";
  }
  if (outcome.standing) out += standing_text(*outcome.standing, store, style);
  if (outcome.failure) out += to_text(*outcome.failure, store, style);
  return out + style.mark(style.dim, statistics_text(report, outcome)) + '\n';
}

}  // namespace skein::plan_tool
