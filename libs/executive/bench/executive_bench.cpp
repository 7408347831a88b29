// SPDX-License-Identifier: Apache-2.0
// The cost of one event, and the memory of the executive, on plans of 10 to 10,000 tasks with five
// conditions each. Goals: the same time at every size; at 10,000 tasks 200,000 events/s, 10 MB.
#include <benchmark/benchmark.h>
#include <malloc.h>

#include "skein/executive/executive.hpp"

namespace skein::executive {
namespace {

/// Bytes handed out by the allocator, as it rounds them and with its headers.
std::size_t live_bytes() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

Literal task_is(std::uint64_t id, TaskState state, Modality modality = Modality::kMandatory) {
  return Literal{TaskInState{TaskId{id}, state}, false, modality};
}

/// A window of n tasks that moves on: task i follows the three before it and a message, and stops
/// when the one before it runs again; so an event concerns five conditions at any n.
class MovingWindow {
 public:
  explicit MovingWindow(std::uint64_t n) : executive_(Config{}) {
    executive_.handle(ProcessMessage{"go"}, MissionTime());
    for (std::uint64_t i = 0; i < n; ++i) start();
  }

  /// Four events: a task starts to run, ends (the next is dispatched), one enters, one leaves.
  void move_on() {
    ++first_;
    executive_.handle(FunctionalStatus{TaskId{first_}, TaskState::kRunning, {}}, MissionTime());
    executive_.handle(FunctionalStatus{TaskId{first_}, TaskState::kEnded, {}}, MissionTime());
    start();
    executive_.handle(Suppress{TaskId{first_}}, MissionTime());
  }

  /// Every event had its effect: the plan is as long as ever and its first task is dispatched.
  bool is_moving() const {
    const auto next = executive_.find(TaskId{first_ + 1});
    return executive_.tasks().size() == last_ - first_ && next &&
           next->state == TaskState::kStarted;
  }
  Executive& executive() { return executive_; }

 private:
  void start() {
    const std::uint64_t id = ++last_;
    Task task{TaskId{id}, "goto", {}, {}, {}, {}};
    task.parameters.add(Parameter{"to", "", {100.0, 200.0, 50.0}});
    const auto before = [&](std::uint64_t k) { return id > k ? id - k : 0; };
    for (std::uint64_t k = 1; k <= 3; ++k) {
      if (before(k) > 0) task.preconditions.push_back({task_is(before(k), TaskState::kEnded)});
    }
    task.preconditions.push_back({Literal{MessageReceived{"go"}}});
    if (before(1) > 0) task.exit.push_back({task_is(before(1), TaskState::kAborted)});
    executive_.handle(Start{std::move(task), InsertionMode::kSeq}, MissionTime());
  }

  Executive executive_;
  std::uint64_t first_ = 0, last_ = 0;
};

void event_in_a_moving_window(benchmark::State& state) {
  const std::size_t before = live_bytes();
  MovingWindow window(static_cast<std::uint64_t>(state.range(0)));
  const std::size_t built = live_bytes() - before;
  for (auto _ : state) window.move_on();
  if (!window.is_moving()) state.SkipWithError("the window stands still");
  const auto moves = static_cast<double>(state.iterations());
  state.counters["events/s"] = benchmark::Counter(4.0 * moves, benchmark::Counter::kIsRate);
  state.counters["bytes"] = static_cast<double>(built);
  state.counters["per_event"] =
      benchmark::Counter(4.0 * moves, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(event_in_a_moving_window)->RangeMultiplier(10)->Range(10, 10'000);

// Coherence, compilation and watching of five conditions, given again and again to the last task.
void update_of_conditions(benchmark::State& state) {
  MovingWindow window(static_cast<std::uint64_t>(state.range(0)));
  const TaskId id{static_cast<std::uint64_t>(state.range(0))};
  Formula exit;
  for (std::uint64_t k = 1; k <= 5; ++k) exit.push_back({task_is(k, TaskState::kAborted)});
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        window.executive().handle(UpdateConditions{id, {}, exit}, MissionTime()));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(update_of_conditions)->RangeMultiplier(10)->Range(10, 10'000);

// A last task inserted with DEP has one condition for each of the others: the cost is that of the
// insertion, linear, and is not paid again by the events that follow.
void insertion_by_dep(benchmark::State& state) {
  MovingWindow window(static_cast<std::uint64_t>(state.range(0)));
  std::uint64_t id = 1'000'000;
  for (auto _ : state) {
    const TaskId one{++id};
    window.executive().handle(Start{Task{one, "land", {}, {}, {}, {}}, InsertionMode::kDep},
                              MissionTime());
    window.executive().handle(Abort{one}, MissionTime());
    window.executive().handle(Suppress{one}, MissionTime());
  }
}
BENCHMARK(insertion_by_dep)->RangeMultiplier(10)->Range(10, 10'000);

}  // namespace
}  // namespace skein::executive

BENCHMARK_MAIN();
