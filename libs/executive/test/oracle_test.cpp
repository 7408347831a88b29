// SPDX-License-Identifier: Apache-2.0
// Laws on random plans and random events, and agreement with the naive executive.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

#include "skein/executive/executive.hpp"
#include "testing/naive_executive.hpp"
#include "testing/random_trace.hpp"
#include "testing/show.hpp"

namespace skein::executive {
namespace {

using testing::NaiveExecutive;
using testing::RandomTrace;
using testing::show;

Config config_for(std::uint64_t seed) {
  Config config;
  config.name = "marvin";
  config.urgent_wait = Duration::seconds(4);
  if (seed % 3 == 0) config.functional_timeout = Duration::seconds(5);
  config.interrupts_unanswered = seed % 2 == 0;
  config.last_urgent_counts = seed % 7 < 3;
  if (seed % 5 < 3) config.sync_validity = Duration::seconds(6);
  return config;
}

RC_GTEST_PROP(Executive, GivesExactlyTheTraceOfTheNaiveExecutive, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const auto length = *rc::gen::resize(100, rc::gen::inRange<std::size_t>(1, 300));
  const auto trace = RandomTrace(seed).make(length);
  const bool punctual = seed % 2 == 0;
  Executive executive(config_for(seed));
  NaiveExecutive naive(config_for(seed));

  for (const auto& [at, input] : trace) {
    while (punctual && executive.next_wakeup() && *executive.next_wakeup() <= at) {
      const MissionTime instant = *executive.next_wakeup();
      RC_ASSERT(show(executive.handle(Tick{}, instant)) == show(naive.handle(Tick{}, instant)));
    }
    RC_ASSERT(show(executive.handle(input, at)) == show(naive.handle(input, at)));
  }
}

RC_GTEST_PROP(Executive, SameTraceGivesTheSameEffects, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const auto trace = RandomTrace(seed).make(150);
  Executive one(config_for(seed)), other(config_for(seed));

  for (const auto& [at, input] : trace) {
    RC_ASSERT(one.handle(input, at) == other.handle(input, at));
  }
}

RC_GTEST_PROP(Executive, NextWakeupIsNeverInThePast, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const auto trace = RandomTrace(seed).make(150);
  Executive executive(config_for(seed));

  for (const auto& [at, input] : trace) {
    executive.handle(input, at);
    RC_ASSERT(!executive.next_wakeup() || *executive.next_wakeup() > at);
  }
}

// Who goes by changes() misses no change, and is not told of one for each input.
RC_GTEST_PROP(Executive, SaysThatItsTasksChangedWheneverTheyDid, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  Executive executive(config_for(seed));
  std::vector<TaskStatus> before;
  std::uint64_t changes = executive.changes();

  for (const auto& [at, input] : RandomTrace(seed).make(150)) {
    const bool events = !executive.handle(input, at).empty();
    const bool told = executive.changes() > changes;
    RC_ASSERT(executive.changes() >= changes);
    RC_ASSERT(told || executive.tasks() == before);
    RC_ASSERT(events || !told);
    before = executive.tasks();
    changes = executive.changes();
  }
}

// An oracle says nothing about what its traces never meet.
TEST(RandomTrace, MeetsEveryKindOfHappening) {
  std::map<std::string, int> met;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Executive executive(config_for(seed));
    for (const auto& [at, input] : RandomTrace(seed).make(150)) {
      for (std::string word : show(executive.handle(input, at))) {
        std::erase_if(word, [](char c) { return c >= '0' && c <= '9'; });
        ++met[word];
      }
    }
  }

  for (const char* word :
       {" scheduled", " started", " running", " aborting", " ended", " aborted", "dispatch ",
        "dispatch joint ", "interrupt ", "interrupt joint ", "sync  to heliv", "forward  started",
        "forward  aborted", "refused START", "refused ABORT", "refused UPDATE-COND",
        "refused SUPPRESS", "accepted UPDATE-COND", "accepted SUPPRESS"}) {
    EXPECT_GT(met[word], 50) << word;
  }
}

RC_GTEST_PROP(Executive, NoTaskLeavesATerminalStateNorSkipsTheTable, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const auto trace = RandomTrace(seed).make(200);
  Executive executive(config_for(seed));
  std::map<TaskId, TaskState> states;
  const std::map<TaskState, std::set<TaskState>> table = {
      {TaskState::kScheduled, {TaskState::kStarted, TaskState::kAborted}},
      {TaskState::kStarted,
       {TaskState::kRunning, TaskState::kEnded, TaskState::kAborting, TaskState::kAborted}},
      {TaskState::kRunning, {TaskState::kEnded, TaskState::kAborting, TaskState::kAborted}},
      {TaskState::kAborting, {TaskState::kAborted}}};

  for (const auto& [at, input] : trace) {
    for (const Effect& effect : executive.handle(input, at)) {
      const auto* event = std::get_if<TaskEvent>(&effect);
      if (event == nullptr) continue;
      const auto known = states.find(event->id);
      if (known == states.end()) {
        RC_ASSERT(event->state == TaskState::kScheduled || event->state == TaskState::kAborted);
      } else {
        RC_ASSERT(table.count(known->second) > 0);
        RC_ASSERT(table.at(known->second).count(event->state) > 0);
      }
      states[event->id] = event->state;
    }
    // What another executive took over may come back, as a new task.
    if (!std::holds_alternative<Relinquish>(input)) continue;
    std::erase_if(states, [](const auto& one) { return !is_terminal(one.second); });
  }
}

// Whoever gives motions, and changes his mind: what the vehicle is asked for last is alone with it.
RC_GTEST_PROP(Executive, NoUrgentMotionIsDispatchedBesideOneThatIsNotInterrupted, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  Config config = config_for(1);
  config.last_urgent_counts = true;
  Executive executive(config);
  std::set<TaskId> moving;
  const auto see = [&](const Effects& effects) {
    for (const Effect& effect : effects) {
      if (const auto* dispatch = std::get_if<Dispatch>(&effect))
        RC_ASSERT(moving.insert(dispatch->id).second && moving.size() == 1);
      if (const auto* event = std::get_if<TaskEvent>(&effect))
        if (event->state == TaskState::kAborting || is_terminal(event->state))
          moving.erase(event->id);
    }
  };

  double at = 0;
  for (std::uint64_t given = 0; given < 40; at += static_cast<double>(random.below(4))) {
    const MissionTime now = MissionTime::seconds(at);
    if (random.chance(0.5)) {
      // In no order of ids: the operator's ways have some of their own.
      const TaskId id{1 + given + (random.chance(0.5) ? 1000 : 0)};
      ++given;
      const char* type = random.chance(0.5) ? "goto" : "land";
      see(executive.handle(Start{Task{id, type, {}, {}, {}, {}}, InsertionMode::kVut}, now));
    } else {
      const TaskState state = random.chance(0.5) ? TaskState::kRunning : TaskState::kAborted;
      const std::vector<TaskStatus> all = executive.tasks();
      if (all.empty()) continue;
      see(executive.handle(FunctionalStatus{all[random.below(all.size())].id, state, ""}, now));
    }
  }
}

// A chain and a fan of mandatory dependences: whatever task is aborted, the executive comes to rest
// and what depends on it is aborted, the rest is not.
RC_GTEST_PROP(Executive, AnAbortCascadeReachesExactlyWhatDependsOnIt, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  Random random(seed);
  const std::uint64_t count = 2 + random.below(60);
  Executive executive(config_for(1));
  std::vector<std::set<std::uint64_t>> needs(count + 1);
  for (std::uint64_t id = 1; id <= count; ++id) {
    Task task{TaskId{id}, "goto", {}, {{Literal{MessageReceived{"go"}}}}, {}, {}};
    for (std::uint64_t k = random.below(3); k > 0 && id > 1; --k) {
      const std::uint64_t other = 1 + random.below(id - 1);
      task.preconditions.push_back({Literal{TaskInState{TaskId{other}, TaskState::kEnded}}});
      needs[id].insert(other);
      needs[id].insert(needs[other].begin(), needs[other].end());
    }
    executive.handle(Start{task, InsertionMode::kSeq}, MissionTime());
  }
  const std::uint64_t victim = 1 + random.below(count);

  executive.handle(Abort{TaskId{victim}}, MissionTime());

  for (const TaskStatus& task : executive.tasks()) {
    const std::uint64_t id = task.id.value();
    const bool reached = id == victim || needs[id].count(victim) > 0;
    RC_ASSERT((task.state == TaskState::kAborted) == reached);
  }
}

// The oracle for "no task starts while a mandatory precondition is false": a literal evaluated here
// from the events seen so far and nothing else.
RC_GTEST_PROP(Executive, NoTaskStartsWhileAMandatoryPreconditionIsFalse, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  Random random(seed);
  Executive executive(config_for(1));
  std::map<TaskId, TaskState> states;
  std::map<TaskId, std::vector<TaskInState>> needs;
  const auto see = [&](const Effects& effects) {
    for (const Effect& effect : effects) {
      const auto* event = std::get_if<TaskEvent>(&effect);
      if (event == nullptr) continue;
      states[event->id] = event->state;
      if (event->state != TaskState::kStarted) continue;
      for (const TaskInState& need : needs[event->id]) {
        RC_ASSERT(states[need.task] == need.state);
      }
    }
  };

  for (std::uint64_t i = 1; i <= 30; ++i) {
    Task task{TaskId{i}, "goto", {}, {}, {}, {}};
    for (std::uint64_t k = random.below(3); k > 0 && i > 1; --k) {
      const TaskInState need{TaskId{1 + random.below(i - 1)},
                             random.chance(0.7) ? TaskState::kEnded : TaskState::kRunning};
      task.preconditions.push_back({Literal{need}});
      needs[task.id].push_back(need);
    }
    see(executive.handle(Start{task, InsertionMode::kSeq}, MissionTime()));
    for (int k = 0; k < 3; ++k) {
      const TaskState state = random.chance(0.5)   ? TaskState::kRunning
                              : random.chance(0.8) ? TaskState::kEnded
                                                   : TaskState::kAborted;
      see(executive.handle(FunctionalStatus{TaskId{1 + random.below(i)}, state, ""},
                           MissionTime()));
    }
  }
}

}  // namespace
}  // namespace skein::executive
