// SPDX-License-Identifier: Apache-2.0
// What can be wrong with a script in itself.
#include "skein/ground_orders/script.hpp"

#include <set>

namespace skein::ground_station {
namespace {

// `where` is whose trigger it is, for the sentence.
void check(const Trigger& trigger, const std::set<std::string>& steps, const std::string& where,
           std::vector<std::string>& problems) {
  const auto check_all = [&](const std::vector<Trigger>& of) {
    for (const Trigger& inner : of) check(inner, steps, where, problems);
  };
  const auto check_step = [&](const std::string& step) {
    if (!steps.contains(step)) problems.push_back(where + " waits for unknown step '" + step + "'");
  };
  if (const auto* on_step = std::get_if<OnStep>(&trigger.what)) {
    check_step(on_step->step);
  } else if (const auto* on_expired = std::get_if<OnExpired>(&trigger.what)) {
    check_step(on_expired->step);
  } else if (const auto* silence = std::get_if<OnSilence>(&trigger.what)) {
    if (silence->lasts <= Duration())
      problems.push_back(where + " waits for '" + silence->uav + "' to be silent for no time");
  } else if (const auto* all = std::get_if<AllOf>(&trigger.what)) {
    check_all(all->of);
  } else if (const auto* any = std::get_if<AnyOf>(&trigger.what)) {
    if (any->of.empty()) problems.push_back(where + " waits for one of nothing");
    check_all(any->of);
  }
}

}  // namespace

std::string asked_by_step(const std::string& step) { return "step " + step; }

std::vector<std::string> problems_of(const Script& script) {
  std::vector<std::string> problems;
  std::set<std::string> steps;
  for (const Step& step : script.steps) {
    if (step.name.empty()) problems.emplace_back("a step has no name");
    if (!steps.insert(step.name).second) {
      problems.push_back("two steps are named '" + step.name + "'");
    }
  }
  for (const Step& step : script.steps) {
    check(step.when, steps, "step '" + step.name + "'", problems);
    if (step.after < Duration())
      problems.push_back("step '" + step.name + "' has a negative delay");
  }
  for (const OperatorAction& action : script.operators) {
    const std::string where = "operator action '" + action.does + "'";
    check(action.when, steps, where, problems);
    if (action.after < Duration()) problems.push_back(where + " has a negative delay");
  }
  if (script.command_lifetime <= Duration()) {
    problems.emplace_back("the lifetime of commands must be positive");
  }
  return problems;
}

}  // namespace skein::ground_station
