// SPDX-License-Identifier: Apache-2.0
// Laws on random automata and traces, and agreement with the naive engine.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <memory>
#include <set>

#include "skein/interaction/engine.hpp"
#include "testing/naive_engine.hpp"
#include "testing/random_automaton.hpp"
#include "testing/show.hpp"

namespace skein::interaction {
namespace {

using testing::NaiveEngine;
using testing::random_trace;
using testing::RandomAutomaton;
using testing::show;

struct Case {
  std::shared_ptr<const Automaton> automaton;
  std::vector<std::pair<MissionTime, Input>> trace;
};

Case a_case(std::uint64_t seed, std::size_t length) {
  auto automaton = std::make_shared<const Automaton>(RandomAutomaton(seed).make());
  auto trace = random_trace(*automaton, seed, length);
  return {std::move(automaton), std::move(trace)};
}

Case any_case() {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  return a_case(seed, *rc::gen::resize(100, rc::gen::inRange<std::size_t>(1, 120)));
}

// States as told by the effects and nothing else.
class Told {
 public:
  explicit Told(const Automaton& automaton) : automaton_(automaton), states_(automaton.size()) {}

  ComponelState operator[](ComponelIndex index) const { return states_[index]; }
  ComponelIndex note(const StateChanged& change) {
    const ComponelIndex index = *automaton_.find(change.componel);
    // What begins anew has told nothing of its content yet.
    if (change.state == ComponelState::kScheduled) {
      for (ComponelIndex i = index; i < automaton_.end_of(index); ++i) states_[i] = {};
    }
    states_[index] = change.state;
    return index;
  }
  bool is_open(ComponelIndex index) const {
    return states_[index] != ComponelState::kNone && !is_over(states_[index]);
  }

 private:
  const Automaton& automaton_;
  std::vector<ComponelState> states_;
};

RC_GTEST_PROP(Engine, GivesExactlyTheEffectsOfTheNaiveEngine, ()) {
  const auto [automaton, trace] = any_case();
  Engine engine(automaton);
  NaiveEngine naive(*automaton);

  for (const auto& [at, input] : trace) {
    const auto effects = engine.handle(input, at);
    const auto expected = naive.handle(input, at);
    RC_ASSERT(effects.has_value() == expected.has_value());
    if (effects) RC_ASSERT(show(*effects) == show(*expected));
  }
}

RC_GTEST_PROP(Engine, SameInputsGiveTheSameEffects, ()) {
  const auto [automaton, trace] = any_case();
  Engine one(automaton), other(automaton);

  for (const auto& [at, input] : trace) {
    const auto effects = one.handle(input, at);
    const auto again = other.handle(input, at);
    RC_ASSERT((effects == again));
  }
}

// That instants pass one by one is no matter of who asks for them.
RC_GTEST_PROP(Engine, PlayedAtEachWakeupItDoesTheSame, ()) {
  const auto [automaton, trace] = any_case();
  Engine lazy(automaton), punctual(automaton);

  for (const auto& [at, input] : trace) {
    const auto expected = lazy.handle(input, at);
    if (!expected) continue;
    Effects effects;
    while (punctual.next_wakeup() && *punctual.next_wakeup() <= at) {
      const Effects some = *punctual.handle(Tick{}, *punctual.next_wakeup());
      effects.insert(effects.end(), some.begin(), some.end());
    }
    const Effects rest = *punctual.handle(input, at);
    effects.insert(effects.end(), rest.begin(), rest.end());
    RC_ASSERT(show(effects) == show(*expected));
    RC_ASSERT((!punctual.next_wakeup() || *punctual.next_wakeup() > at));
  }
}

RC_GTEST_PROP(Engine, NoBlockIsActiveOutsideOfAnActiveParent, ()) {
  const auto [automaton, trace] = any_case();
  Engine engine(automaton);
  Told told(*automaton);

  for (const auto& [at, input] : trace) {
    const auto effects = engine.handle(input, at).value_or(Effects{});
    for (const Effect& effect : effects) {
      const auto* change = std::get_if<StateChanged>(&effect.what);
      if (change == nullptr) continue;
      const ComponelIndex index = told.note(*change);
      const ComponelIndex parent = (*automaton)[index].parent;
      if (change->state == ComponelState::kRunning && index != 0) {
        RC_ASSERT(told[parent] == ComponelState::kRunning);
      }
      if (!is_over(change->state)) continue;
      for (ComponelIndex i = index + 1; i < automaton->end_of(index); ++i) {
        RC_ASSERT(!told.is_open(i));
      }
    }
  }
}

RC_GTEST_PROP(Engine, WhatIsInterruptedIsToldAtOnce, ()) {
  const auto [automaton, trace] = any_case();
  Engine engine(automaton);

  for (const auto& [at, input] : trace) {
    const Effects effects = engine.handle(input, at).value_or(Effects{});
    for (std::size_t i = 0; i < effects.size(); ++i) {
      const auto* change = std::get_if<StateChanged>(&effects[i].what);
      if (change == nullptr || change->state != ComponelState::kAborting) continue;
      const Componel& componel = (*automaton)[*automaton->find(change->componel)];
      if (componel.block() != nullptr) continue;
      RC_ASSERT(i + 1 < effects.size());
      const Effect::What told = componel.task() != nullptr ? Effect::What(Interrupt{componel.id})
                                                           : Effect::What(Withdraw{componel.id});
      RC_ASSERT(effects[i + 1].what == told);
    }
  }
}

// Whatever happened before: once it is to end and what it runs has stopped, it ends.
RC_GTEST_PROP(Engine, EveryActivationEnds, ()) {
  const auto [automaton, trace] = any_case();
  Engine engine(automaton);
  for (const auto& [at, input] : trace) (void)engine.handle(input, at);
  const MissionTime last = trace.back().first;

  (void)engine.handle(Abort{}, last);
  for (ComponelIndex i = 0; i < automaton->size(); ++i) {
    if (engine.state(i) != ComponelState::kAborting || (*automaton)[i].block() != nullptr) continue;
    (void)engine.handle(Status{(*automaton)[i].id, Status::Word::kAborted}, last);
  }

  RC_ASSERT(engine.is_over());
  RC_ASSERT(!engine.next_wakeup());
  for (ComponelIndex i = 0; i < automaton->size(); ++i) {
    RC_ASSERT((engine.state(i) == ComponelState::kNone || is_over(engine.state(i))));
  }
}

// An oracle says nothing about what its traces never meet.
TEST(RandomTrace, MeetsEveryKindOfEffect) {
  std::map<std::string, int> met;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const auto [automaton, trace] = a_case(seed, 100);
    Engine engine(automaton);
    std::set<std::string> begun;
    for (const auto& [at, input] : trace) {
      const auto effects = engine.handle(input, at);
      if (!effects) ++met["refused"];
      for (const Effect& effect : effects.value_or(Effects{})) {
        if (effect.at < at) ++met["between inputs"];
        if (std::holds_alternative<Read>(effect.what)) ++met["read"];
        if (std::holds_alternative<Withdraw>(effect.what)) ++met["withdraw"];
        if (std::holds_alternative<Interrupt>(effect.what)) ++met["interrupt"];
        if (const auto* run = std::get_if<interaction::Run>(&effect.what)) {
          if (!begun.insert(run->task).second) ++met["run again"];
        }
        if (const auto* over = std::get_if<ModelOver>(&effect.what)) {
          ++met[over->state == ComponelState::kEnded ? "model ended" : "model aborted"];
          if (!over->why.empty()) ++met["a loop without end"];
        }
      }
    }
  }
  for (const char* what : {"refused", "between inputs", "read", "withdraw", "interrupt",
                           "run again", "model ended", "model aborted", "a loop without end"}) {
    EXPECT_GT(met[what], 3) << what;
  }
}

}  // namespace
}  // namespace skein::interaction
