// SPDX-License-Identifier: Apache-2.0
#include "insertion/relaxations.hpp"

#include <algorithm>
#include <optional>

#include "insertion/slack.hpp"

namespace skein::supervisor {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
/// Beyond this nobody is told to wait [s].
constexpr std::int64_t kFarthest = std::int64_t{1} << 20U;

Duration whole_seconds(Duration duration) {
  const std::int64_t count = duration.count();
  return Duration::nanoseconds((count + kSecond - 1) / kSecond * kSecond);
}

// Rides along with another task: by itself it is not asked to be in time.
bool rides_along(const mission::ElementaryTask& task) {
  return !mission::holds_vehicle(task) && !mission::devices_of(task).empty();
}

class Relaxations {
 public:
  Relaxations(const Judge& judge, const Goals& order)
      : judge_(judge),
        order_(Slack(order, judge.knowledge().vocabulary).goals(Slack::kAll)),
        standing_(judge.standing()) {}

  std::vector<Relaxation> find() {
    if (!bounded()) return {};
    auto plan = judge_.plan_of(without_upper_bounds());
    if (!plan) return {};
    plan_ = *std::move(plan);
    for (mission::HighLevelTask& goal : order_) {
      if (!absolute(goal)) return {};
    }
    for (mission::ElementaryTask& task : plan_.tasks) task.time = bounds_of(task.origin);
    if (!after_goals() || found_.empty() || !serves()) return {};
    return std::move(found_);
  }

 private:
  bool bounded() const {
    return std::any_of(order_.begin(), order_.end(), [](const mission::HighLevelTask& goal) {
      return goal.time.start_before || goal.time.end_before ||
             std::any_of(goal.after.begin(), goal.after.end(),
                         [](const auto& bound) { return bound.most != Duration::max(); });
    });
  }

  Goals without_upper_bounds() const {
    Goals goals = order_;
    for (mission::HighLevelTask& goal : goals) {
      goal.time.start_before.reset();
      goal.time.end_before.reset();
    }
    return goals;
  }

  mission::TimeConstraints bounds_of(mission::GoalId id) const {
    const auto goal =
        std::find_if(order_.begin(), order_.end(), [&](const auto& one) { return one.id == id; });
    return goal == order_.end() ? mission::TimeConstraints() : goal->time;
  }

  // As the planner reckons. False: nobody knows when it starts or ends.
  bool absolute(mission::HighLevelTask& goal) {
    Duration start, end;
    for (const mission::ElementaryTask& task : plan_.tasks) {
      if (task.origin != goal.id || rides_along(task)) continue;
      start = std::max(start, task.start.most);
      const bool known = task.start.most != Duration::max() && !task.open_ended &&
                         task.duration.most != Duration::max();
      end = known ? std::max(end, task.start.most + task.duration.most) : Duration::max();
      if (end == Duration::max()) break;
    }
    return later(goal, goal.time.start_before, "start-before", start) &&
           later(goal, goal.time.end_before, "end-before", end);
  }

  bool later(const mission::HighLevelTask& goal, std::optional<MissionTime>& bound,
             const char* name, Duration latest) {
    if (!bound) return true;
    if (latest == Duration::max()) return false;
    const Duration needed = whole_seconds(plan_.origin - MissionTime() + latest);
    const Duration asked = *bound - MissionTime();
    if (needed <= asked) return true;
    found_.push_back({goal.id, name, asked, needed});
    bound = MissionTime() + needed;
    return true;
  }

  // One after another, each as it was asked for if that can be, while those to come are without
  // bound.
  bool after_goals() {
    std::vector<std::pair<mission::GoalId, mission::GoalBound*>> bounds;
    std::vector<Duration> asked;
    for (mission::HighLevelTask& goal : order_) {
      for (mission::GoalBound& bound : standing_.bounds.of[goal.id]) {
        if (bound.most == Duration::max()) continue;
        bounds.emplace_back(goal.id, &bound);
        asked.push_back(bound.most);
        bound.most = Duration::max();
      }
    }
    if (!holds()) return false;
    for (std::size_t i = 0; i < bounds.size(); ++i) {
      mission::GoalBound& bound = *bounds[i].second;
      bound.most = asked[i];
      if (holds()) continue;
      if (!relax(bound, asked[i])) return false;
      const std::string name = std::string(bound.on_end ? "end" : "start") + "-after-goal " +
                               to_text(bound.goal) + " at most";
      found_.push_back({bounds[i].first, name, asked[i], bound.most});
    }
    return true;
  }

  bool relax(mission::GoalBound& bound, Duration asked) {
    std::int64_t few = asked.count() / kSecond, enough = kFarthest;
    const auto serves_with = [&](std::int64_t seconds) {
      bound.most = Duration::nanoseconds(seconds * kSecond);
      return holds();
    };
    if (!serves_with(enough)) return false;
    while (enough - few > 1) {
      const std::int64_t middle = few + (enough - few) / 2;
      (serves_with(middle) ? enough : few) = middle;
    }
    bound.most = Duration::nanoseconds(enough * kSecond);
    return true;
  }

  bool holds() const {
    std::vector<mission::ElementaryTask> all = standing_.tasks;
    all.insert(all.end(), plan_.tasks.begin(), plan_.tasks.end());
    return schedule(all, standing_.seen, judge_.base().situation.origin, standing_.bounds)
        .controllable;
  }

  bool serves() const { return Judge(judge_, standing_).of(order_).serves; }

  const Judge& judge_;
  Goals order_;        ///< with the bounds that would serve
  Standing standing_;  ///< likewise
  mission::ElementaryPlan plan_;
  std::vector<Relaxation> found_;
};

}  // namespace

std::string to_text(const Relaxation& one) {
  return "goal " + to_text(one.goal) + " " + one.bound + " " + to_text(one.needed) +
         " s instead of " + to_text(one.asked) + " s";
}

std::vector<Relaxation> relaxations_for(const Judge& judge, const Goals& order) {
  if (judge.base().budget.over()) return {};
  return Relaxations(judge, order).find();
}

}  // namespace skein::supervisor
