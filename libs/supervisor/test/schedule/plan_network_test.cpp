// SPDX-License-Identifier: Apache-2.0
// The network that lives is, after any sequence of changes, the one rebuilt from scratch.
#include "schedule/plan_network.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "skein/temporal/stnu_controllability.hpp"
#include "testing/elementary_plans.hpp"
#include "testing/rebuilt_dates.hpp"
#include "testing/rebuilt_network.hpp"

namespace skein::supervisor {
namespace {

using mission::ElementaryTask;
using temporal::kInfinite;
using temporal::kMinusInfinite;
using temporal::Ticks;

/// Tasks of a plan that come, start, end, are aborted, change and go.
class Life {
 public:
  explicit Life(std::uint64_t seed) : random_(seed) {
    for (ElementaryTask& task : random_plan(random_, random_.chance(0.5))) come(std::move(task));
  }

  void happen() {
    switch (random_.below(8)) {
      case 0:
        return come_and_go();
      case 1:
        return change();
      case 2:
      case 3:
        return end();
      default:
        now_ = now_ + Duration::seconds(static_cast<double>(random_.below(12)));
        return start();
    }
  }

  Tasks tasks() const {
    Tasks result;
    for (const auto& [id, task] : tasks_) result.push_back(task);
    return result;
  }
  const Observations& seen() const { return seen_; }
  MissionTime now() const { return now_; }
  std::vector<TaskView> views() const {
    std::vector<TaskView> result;
    for (const auto& [id, task] : tasks_) {
      const auto seen = seen_.find(id);
      result.push_back({&task, seen == seen_.end() ? Observation() : seen->second});
    }
    return result;
  }

 private:
  void come(ElementaryTask task) { tasks_[task.id] = std::move(task); }

  std::map<executive::TaskId, ElementaryTask>::iterator any() {
    auto it = tasks_.begin();
    std::advance(it, static_cast<std::ptrdiff_t>(random_.below(tasks_.size())));
    return it;
  }

  // What is over, or anything at all, goes; a task of another plan comes, under its number.
  void come_and_go() {
    if (tasks_.size() > 3) {
      const auto gone = any();
      seen_.erase(gone->first);
      tasks_.erase(gone);
    }
    const Tasks others = random_plan(random_, true);
    ElementaryTask task = others[random_.below(others.size())];
    if (tasks_.count(task.id) == 0) come(std::move(task));
  }
  void change() {
    ElementaryTask& task = any()->second;
    const MissionTime bound = now_ + Duration::seconds(static_cast<double>(random_.below(200)));
    if (random_.chance(0.3)) {
      task.time = {};
    } else if (random_.chance(0.5)) {
      task.time.end_before = bound;
    } else {
      task.time.start_after = bound;
    }
  }
  void start() {
    const auto task = any();
    Observation& seen = seen_[task->first];
    if (!seen.started && !seen.over) seen.started = now_;
  }
  void end() {
    const auto task = any();
    Observation& seen = seen_[task->first];
    if (seen.over || (!seen.started && random_.chance(0.7))) return;
    seen.over = now_;
    seen.aborted = !seen.started;
  }

  Random random_;
  std::map<executive::TaskId, ElementaryTask> tasks_;
  Observations seen_;
  MissionTime now_;
};

/// All shortest distances, by three loops.
std::vector<Ticks> floyd_warshall(const temporal::Stnu& network, bool greatest, bool least) {
  const std::size_t n = network.nodes.size();
  std::vector<Ticks> d(n * n, kInfinite);
  const auto add = [&](temporal::NodeIndex from, temporal::NodeIndex to, Ticks min, Ticks max) {
    if (max != kInfinite) d[from * n + to] = std::min(d[from * n + to], max);
    if (min != kMinusInfinite) d[to * n + from] = std::min(d[to * n + from], -min);
  };
  for (std::size_t i = 0; i < n; ++i) d[i * n + i] = 0;
  for (const auto& arc : network.arcs) add(arc.from, arc.to, arc.min, arc.max);
  for (const auto& link : network.contingent) {
    add(link.activation, link.contingent, greatest ? link.max : link.min,
        least ? link.min : link.max);
  }
  if (least && !greatest)
    for (const temporal::Arc& arc : implied_by(network)) add(arc.from, arc.to, arc.min, arc.max);
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        if (d[i * n + k] != kInfinite && d[k * n + j] != kInfinite)
          d[i * n + j] = std::min(d[i * n + j], d[i * n + k] + d[k * n + j]);
  return d;
}

MissionTime instant(Ticks ticks) {
  return ticks == kInfinite ? MissionTime::max() : MissionTime::nanoseconds(ticks);
}

void expect_windows_of(const temporal::Stnu& network, const Life& life, const Schedule& schedule) {
  const bool every = schedule.controllable;
  const std::vector<Ticks> low = floyd_warshall(network, false, every);
  const std::vector<Ticks> high = floyd_warshall(network, every, false);
  const std::size_t n = network.nodes.size();
  std::size_t node = 1;
  for (const ElementaryTask& task : life.tasks()) {
    const mission::TaskDates expected{instant(-low[node * n]), instant(high[node]),
                                      instant(-low[(node + 1) * n]), instant(high[node + 1])};
    RC_ASSERT(schedule.dates.at(task.id) == expected);
    node += 2;
  }
}

RC_GTEST_PROP(PlanNetwork, AfterAnyChangesIsTheOneBuiltFromScratch, (std::uint64_t seed)) {
  Life life(seed);
  PlanNetwork kept;

  for (int step = 0; step < 40; ++step) {
    kept.update(life.views(), life.now());

    const Schedule& now = kept.schedule();
    const temporal::Stnu network = network_of(life.tasks(), life.seen(), life.now());
    const auto verdict = temporal::check_dynamic_controllability(network);
    RC_ASSERT(verdict.has_value());
    RC_ASSERT(now.consistent == verdict->consistent);
    RC_ASSERT(now.controllable == verdict->controllable);
    RC_ASSERT(now.conflicts.empty() == now.controllable);
    for (const Conflict& one : now.conflicts) RC_ASSERT(!one.why.empty());
    if (now.consistent) expect_windows_of(network, life, now);
    life.happen();
  }
}

RC_GTEST_PROP(PlanNetwork, ForeseesWhatIsForeseenFromScratch, (std::uint64_t seed)) {
  Life life(seed);
  PlanNetwork kept;

  for (int step = 0; step < 30; ++step, life.happen()) {
    kept.update(life.views(), life.now());

    const Schedule& now = kept.schedule();
    if (!now.controllable || !now.holds.empty()) continue;
    const RebuiltNetwork rebuilt = build_network(life.tasks(), life.seen(), life.now());
    const auto allowed = dates_in_every_course(rebuilt);
    const auto foreseen = foresee(rebuilt, &*allowed);
    for (const auto& [id, nodes] : rebuilt.nodes) {
      const mission::TaskDates expected{
          instant(foreseen->earliest[nodes.start]), instant(foreseen->latest[nodes.start]),
          instant(foreseen->earliest[nodes.end]), instant(foreseen->latest[nodes.end])};
      RC_ASSERT(now.foreseen.at(id) == expected);
    }
  }
}

// The laws above would hold of plans that never change: how much they are about.
TEST(PlanNetwork, LivesAreOfEverySort) {
  int controllable = 0, broken = 0, held = 0;
  std::uint64_t local = 0, scratch = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Life life(seed);
    PlanNetwork kept;
    for (int step = 0; step < 40; ++step, life.happen()) {
      kept.update(life.views(), life.now());
      ++(kept.schedule().controllable ? controllable : broken);
      held += kept.schedule().holds.empty() ? 0 : 1;
    }
    local += kept.network().settled_locally();
    scratch += kept.network().settled_from_scratch();
  }
  EXPECT_GT(controllable, 500);
  EXPECT_GT(broken, 300);
  EXPECT_GT(held, 5);
  EXPECT_GT(local, scratch / 2) << "changes worked out where they are";
}

TEST(PlanNetwork, AnUpdateWithoutAChangeWorksNothingOut) {
  const Tasks plan = karma_plan();
  std::vector<TaskView> views;
  for (const ElementaryTask& task : plan) views.push_back({&task, {}});
  PlanNetwork kept;
  kept.update(views, at(0));
  const auto before = kept.network().settled_locally() + kept.network().settled_from_scratch();

  kept.update(views, at(0));

  EXPECT_EQ(kept.network().settled_locally() + kept.network().settled_from_scratch(), before);
}

}  // namespace
}  // namespace skein::supervisor
