// SPDX-License-Identifier: Apache-2.0
#include "by_hand.hpp"

#include <algorithm>

#include "scripted.hpp"

namespace skein::laws {

std::set<std::int64_t> given_by_hand(const History& history, const Uav& uav) {
  std::set<std::int64_t> result;
  for_scripted<ground_station::SendPlan>(*history.scenario, [&](const auto& plan) {
    if (plan.uav != uav.name()) return;
    for (const auto& one : plan.tasks)
      result.insert(static_cast<std::int64_t>(one.task.id.value()));
  });
  return result;
}

std::vector<const Activity*> carried_out_by_hand(const History& history, const Uav& uav) {
  const std::set<std::int64_t> given = given_by_hand(history, uav);
  std::vector<const Activity*> result;
  for (const Activity& one : uav.activities)
    if (given.contains(one.task) && one.type != "takeshot") result.push_back(&one);
  return result;
}

bool does_by_hand(const History& history, const Uav& uav, double at) {
  constexpr double kMoment = 0.5;  // [s] between what is asked for at once
  const std::vector<const Activity*> done = carried_out_by_hand(history, uav);
  return std::any_of(done.begin(), done.end(), [&](const Activity* one) {
    return one->from <= at + kMoment && at < one->until;
  });
}

bool was_left_by_hand(const History& history, const Uav& uav, double at) {
  const std::set<std::int64_t> given = given_by_hand(history, uav);
  const Activity* last = nullptr;
  for (const Activity& one : uav.activities)
    if (one.moves() && one.from < one.until && one.from <= at) last = &one;
  return last != nullptr && given.contains(last->task);
}

}  // namespace skein::laws
