// SPDX-License-Identifier: Apache-2.0
// The cost of one event, and the memory of an engine, in automata of 10, 100 and 1,000 blocks.
// Goal: the same time at every size.
#include <benchmark/benchmark.h>
#include <malloc.h>

#include <memory>
#include <string>

#include "skein/interaction/engine.hpp"

namespace skein::interaction {
namespace {

/// Bytes handed out by the allocator, as it rounds them and with its headers.
std::size_t live_bytes() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

Componel componel(std::string id, ComponelIndex parent,
                  std::variant<Block, Task, CoordinationAction> what) {
  return Componel{std::move(id), parent, std::move(what), "", 0};
}

/// n blocks beside each other, all active: loops of a task, each with a precondition and an exit on
/// its neighbour, a message and an instant of its own.
std::shared_ptr<const Automaton> automaton_of(std::size_t n) {
  Automaton automaton;
  automaton.add(componel("main", 0, Block{}));
  for (std::size_t i = 1; i < n; ++i) {
    Block loop;
    loop.type = BlockType::kLoop;
    loop.scms = {"near"};
    loop.exit = {{Literal{MessagePending{"stop " + std::to_string(i)}}},
                 {Literal{TimeIs{Duration::seconds(1e6), TimeIs::ModelStart{}, true}}}};
    const ComponelIndex index = *automaton.add(componel("b" + std::to_string(i), 0, loop));
    if (i > 1) {
      automaton[index].block()->precondition = {
          {Literal{ComponelIs{index - 2, AskedState::kRunning}}}};
    }
    automaton.add(componel("t" + std::to_string(i), index, Task{"goto", {}}));
  }
  return std::make_shared<const Automaton>(std::move(automaton));
}

// A task runs and ends, its loop begins anew: two events, seven effects.
void event_in_one_of_n_active_blocks(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  const auto automaton = automaton_of(n);
  const std::size_t before = live_bytes();
  Engine engine(automaton);
  std::size_t effects = (*engine.handle(Start{}, MissionTime())).size();
  const std::size_t built = live_bytes() - before;
  std::int64_t at = 0;
  std::size_t turn = 0;
  effects = 0;
  for (auto _ : state) {
    turn = turn % (n - 1) + 1;
    const std::string task = "t" + std::to_string(turn);
    const MissionTime now = MissionTime::nanoseconds(++at);
    effects += engine.handle(Status{task, Status::Word::kRunning}, now)->size();
    effects += engine.handle(Status{task, Status::Word::kEnded}, now)->size();
  }
  if (effects != 4 * static_cast<std::size_t>(state.iterations())) {
    state.SkipWithError("an event had not its effect");
  }
  const auto events = 2.0 * static_cast<double>(state.iterations());
  state.counters["events/s"] = benchmark::Counter(events, benchmark::Counter::kIsRate);
  state.counters["per_event"] =
      benchmark::Counter(events, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["bytes"] = static_cast<double>(built);
}
BENCHMARK(event_in_one_of_n_active_blocks)->RangeMultiplier(10)->Range(10, 1'000);

// A message that one block of n names, and that changes nothing yet.
void message_for_one_of_n_blocks(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  Engine engine(automaton_of(n));
  (void)engine.handle(Start{}, MissionTime());
  std::size_t turn = 0;
  for (auto _ : state) {
    turn = turn % (n - 1) + 1;
    benchmark::DoNotOptimize(
        engine.handle(Message{"stop " + std::to_string(turn)}, MissionTime::seconds(1)));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(message_for_one_of_n_blocks)->RangeMultiplier(10)->Range(10, 1'000);

}  // namespace
}  // namespace skein::interaction

BENCHMARK_MAIN();
