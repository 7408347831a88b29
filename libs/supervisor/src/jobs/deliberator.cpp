// SPDX-License-Identifier: Apache-2.0
#include "skein/supervisor/deliberator.hpp"

#include "insertion/judge.hpp"
#include "insertion/with.hpp"
#include "planning/plans.hpp"
#include "skein/foundation/overloaded.hpp"

namespace skein::supervisor {

namespace {

/// However the job ends, nothing of its situation is kept.
struct RunningJob {
  explicit RunningJob(Plans& made) : plans(made) {}
  ~RunningJob() { plans.end_job(); }
  RunningJob(const RunningJob&) = delete;
  RunningJob& operator=(const RunningJob&) = delete;
  Plans& plans;
};

}  // namespace

Deliberator::Deliberator() : plans_(std::make_unique<Plans>()) {}
Deliberator::~Deliberator() = default;

DeliberationResult Deliberator::deliberate(const DeliberationRequest& request,
                                           const std::function<bool()>& time_is_up) {
  const RunningJob job(*plans_);
  const Planner planner = [this](const PlanningRequest& one) { return plans_->plan(one); };
  const auto answered = Overloaded{
      [&](const InsertionRequest& one) { return DeliberationResult(insert_tasks(one, planner)); },
      [&](const RepairRequest& one) { return DeliberationResult(repair_plan(one, planner)); }};
  if (!time_is_up) return std::visit(answered, request);
  DeliberationRequest timed = request;
  std::visit([&](auto& one) { one.base.budget.time_is_up = time_is_up; }, timed);
  return std::visit(answered, timed);
}

DeliberationResult deliberate(const DeliberationRequest& request,
                              std::function<bool()> time_is_up) {
  return Deliberator().deliberate(request, time_is_up);
}

}  // namespace skein::supervisor
