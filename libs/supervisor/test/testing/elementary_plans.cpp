// SPDX-License-Identifier: Apache-2.0
#include "elementary_plans.hpp"

namespace skein::supervisor {

namespace {

class RandomPlan {
 public:
  RandomPlan(Random& random, bool odd) : random_(random), odd_(odd) {}

  Tasks make() {
    const std::uint64_t parts = 1 + random_.below(5);
    for (std::uint64_t i = 0; i < parts; ++i) part();
    double foreseen = 0;
    for (const auto& task : tasks_) foreseen += task.duration.most.to_seconds();
    for (auto& task : tasks_) constrain(task, foreseen);
    return tasks_;
  }

 private:
  double whole(double low, double high) {
    return low + static_cast<double>(random_.below(static_cast<std::uint64_t>(high - low) + 1));
  }

  std::uint64_t add(TaskBuilder builder) {
    tasks_.push_back(builder);
    return next_++;
  }

  TaskBuilder after_motion(const std::string& type) {
    TaskBuilder builder = a_task(next_, type);
    if (motion_ > 0) builder.ended(motion_);
    if (shot_ > 0 && random_.chance(0.7)) builder.ended(shot_);
    return builder;
  }

  void part() {
    switch (random_.below(4)) {
      case 0:
        beside_.push_back(joint());
        break;
      case 1:
        meeting();
        break;
      default:
        leg();
    }
  }

  std::uint64_t joint() {
    TaskBuilder builder = a_task(next_, "joint:relay");
    if (motion_ > 0 && random_.chance(0.5)) builder.ended(motion_);
    const double least = whole(1, 20);
    return add(builder.lasts(least, least + whole(0, 30)));
  }

  void leg() {
    const bool wait = random_.chance(0.4);
    const double least = whole(1, 40);
    TaskBuilder builder = after_motion(wait ? "wait" : "goto");
    motion_ = add(builder.lasts(least, wait ? least : least + whole(0, 40)));
    if (random_.chance(0.6)) takeshot();
  }

  void takeshot() {
    TaskBuilder builder = a_task(next_, "takeshot").running(motion_);
    builder.stopped_by(motion_);
    if (odd_ && !beside_.empty()) builder.ended(beside_.back());
    if (odd_ && shot_ > 0) builder.ended(shot_);
    shot_ = add(builder);
  }

  void meeting() {
    TaskBuilder wait = after_motion("wait");
    motion_ = add(wait.stopped_by(next_ + 1));
    add(a_task(next_, "synchronise").running(motion_).lasts(0, whole(1, 30)));
  }

  void constrain(mission::ElementaryTask& task, double foreseen) {
    if (!random_.chance(0.2)) return;
    const MissionTime bound = at(whole(0, 1.3 * foreseen + 10));
    const MissionTime late = bound + Duration::seconds(whole(0, foreseen + 10));
    switch (random_.below(5)) {
      case 0:
        task.time.start_after = bound;
        break;
      case 1:
        task.time.end_after = bound;
        break;
      case 2:
        task.time.start_before = bound;
        break;
      case 3:
        task.time.end_before = bound;
        break;
      default:
        task.time.end_after = bound;
        task.time.start_before = late;
    }
  }

  Random& random_;
  bool odd_;
  Tasks tasks_;
  std::uint64_t next_ = 1, motion_ = 0, shot_ = 0;
  std::vector<std::uint64_t> beside_;
};

}  // namespace

Tasks random_plan(Random& random, bool odd) { return RandomPlan(random, odd).make(); }

Tasks long_plan(std::size_t tasks) {
  Tasks plan{a_task(1, "takeoff").lasts(4, 6)};
  std::uint64_t next = 2, motion = 1, shot = 0;
  while (plan.size() + 4 <= tasks) {
    TaskBuilder go = a_task(next, "goto").ended(motion).lasts(8, 88);
    if (shot > 0) go.ended(shot);
    plan.push_back(go);
    plan.push_back(a_task(next + 1, "wait").ended(next).lasts(20));
    TaskBuilder take = a_task(next + 2, "takeshot").running(next + 1).stopped_by(next + 1);
    if (shot > 0) take.ended(shot);
    plan.push_back(take);
    motion = next + 1;
    shot = next + 2;
    next += 3;
  }
  while (plan.size() < tasks) {
    plan.push_back(a_task(next, "land").ended(motion).lasts(4, 6));
    motion = next++;
  }
  plan.back().time.end_before = at(1e6);
  return plan;
}

}  // namespace skein::supervisor
