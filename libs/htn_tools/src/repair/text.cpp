// SPDX-License-Identifier: Apache-2.0
#include "skein/htn_tools/repair_text.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "skein/htn_tools/plan_json.hpp"

namespace skein::htn {

namespace {

std::string counted(std::size_t count, const std::string& one) {
  return std::to_string(count) + ' ' + one + (count == 1 ? "" : "s");
}

std::string heading(const Repair& repair, const TextStyle& style) {
  switch (repair.verdict) {
    case RepairVerdict::kStands:
      return style.mark(style.good, "the plan stands");
    case RepairVerdict::kRepaired:
      return style.mark(style.good, "repaired: " + counted(repair.kept.size(), "step") + " kept, " +
                                        std::to_string(repair.dropped.size()) + " dropped, " +
                                        std::to_string(repair.added.size()) + " new, cost " +
                                        to_text(repair.plan.cost));
    case RepairVerdict::kNoPlan:
      return style.mark(style.bad, "there is no plan from here");
    case RepairVerdict::kLimit:
      return style.mark(style.accent, "cut: " + repair.why);
    default:
      return style.mark(style.bad, "error: " + repair.why);
  }
}

std::string steps(const RepairRequest& request, const Repair& repair, const TermStore& store,
                  const TextStyle& style) {
  std::string out;
  for (StepIndex step = 0; step < repair.plan.steps.size(); ++step) {
    const bool fresh = std::binary_search(repair.added.begin(), repair.added.end(), step);
    const std::string number = std::to_string(step + 1);
    const std::string line = std::string(number.size() < 4 ? 4 - number.size() : 0, ' ') + number +
                             ' ' + store.to_text(repair.plan.steps[step].action);
    const bool done = step < request.executed;
    out += std::string(done    ? "·"
                       : fresh ? "+"
                               : " ") +
           style.mark(done    ? style.dim
                      : fresh ? style.good
                              : "",
                      line) +
           '\n';
  }
  for (const StepIndex step : repair.dropped) {
    out += "-     " + style.mark(style.bad, store.to_text(request.plan->steps[step].action)) + '\n';
  }
  return out;
}

const char* verdict_name(RepairVerdict verdict) {
  switch (verdict) {
    case RepairVerdict::kStands:
      return "stands";
    case RepairVerdict::kRepaired:
      return "repaired";
    case RepairVerdict::kNoPlan:
      return "no-plan";
    case RepairVerdict::kLimit:
      return "limit";
    default:
      return "error";
  }
}

nlohmann::ordered_json json_of(Term term, const TermStore& store) {
  std::string text;
  append_json(term, store, text);
  return nlohmann::ordered_json::parse(text, nullptr, false);
}

}  // namespace

std::string to_text(const std::string& problem, const RepairRequest& request, const Repair& repair,
                    const TermStore& store, const TextStyle& style) {
  std::string out = style.mark(style.bold, problem) + ": " + heading(repair, style) + '\n';
  if (repair.clobbered) {
    out += "  lost: " + store.to_text(repair.clobbered->fact) + ", needed by " +
           store.to_text(repair.clobbered->task) + '\n';
  }
  for (const Redone& redone : repair.redone) {
    out += std::string(redone.begun ? "  begun again: " : "  done otherwise: ") +
           store.to_text(redone.task) + '\n';
  }
  return out + steps(request, repair, store, style);
}

std::string to_json(const std::string& problem, const RepairRequest& request, const Repair& repair,
                    const TermStore& store) {
  nlohmann::ordered_json out;
  out["problem"] = problem;
  out["result"] = verdict_name(repair.verdict);
  if (!repair.why.empty()) out["why"] = repair.why;
  out["executed"] = request.executed;
  out["plans"] = nlohmann::ordered_json::array();
  const bool found =
      repair.verdict == RepairVerdict::kStands || repair.verdict == RepairVerdict::kRepaired;
  if (found) {
    std::string plan;
    append_json(repair.plan, store, {true, true}, plan);
    out["plans"].push_back(nlohmann::ordered_json::parse(plan, nullptr, false));
    out["kept"] = repair.kept;
    out["added"] = repair.added;
    out["dropped"] = repair.dropped;
    out["redone"] = nlohmann::ordered_json::array();
    for (const Redone& redone : repair.redone) {
      out["redone"].push_back({{"task", json_of(redone.task, store)}, {"begun", redone.begun}});
    }
  }
  if (repair.clobbered) {
    out["lost"] = {{"fact", json_of(repair.clobbered->fact, store)},
                   {"task", json_of(repair.clobbered->task, store)}};
  }
  out["attempts"] = repair.attempts;
  out["expansions"] = repair.statistics.expansions;
  out["inferences"] = repair.statistics.inferences;
  return out.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace skein::htn
