// SPDX-License-Identifier: Apache-2.0
// Random automata and traces: few messages and instants, and conditions on neighbours, so that
// everything meets everything.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "skein/foundation/random.hpp"
#include "skein/interaction/automaton.hpp"
#include "skein/interaction/input.hpp"

namespace skein::interaction::testing {

class RandomAutomaton {
 public:
  explicit RandomAutomaton(std::uint64_t seed) : random_(seed, "automaton") {}

  Automaton make() {
    depth_ = 1 + random_.below(4);
    add_block(0, 0);
    for (ComponelIndex i = 0; i < automaton_.size(); ++i) {
      if (automaton_[i].block() == nullptr) continue;
      const bool loop = automaton_[i].block()->type == BlockType::kLoop;
      Formula pre = formula(i == 0 ? 0.1 : 0.6, false, false);
      Formula exit = formula(0.4, true, loop);
      automaton_[i].block()->precondition = std::move(pre);
      automaton_[i].block()->exit = std::move(exit);
    }
    return std::move(automaton_);
  }

 private:
  void add_block(ComponelIndex parent, std::uint64_t depth) {
    Block block;
    block.type = random_.chance(0.35) ? BlockType::kLoop : BlockType::kPlan;
    block.end = random_.chance(0.35) ? EndMode::kImmediate : EndMode::kWait;
    for (std::uint64_t k = random_.below(3); k > 1; --k) block.locals.push_back({"p", "f()", 0});
    for (const char* scm : {"s1", "s2"}) {
      if (random_.chance(0.25)) block.scms.emplace_back(scm);
    }
    const ComponelIndex index = add("b", parent, std::move(block));
    const std::uint64_t items = 1 + random_.below(depth == 0 ? 4 : 3);
    for (std::uint64_t i = 0; i < items; ++i) {
      if (depth < depth_ && random_.chance(0.6)) {
        add_block(index, depth + 1);
      } else {
        add_leaf(index);
      }
    }
  }

  void add_leaf(ComponelIndex parent) {
    if (random_.chance(0.75)) {
      add("t", parent, Task{"goto", {}});
    } else {
      add("a", parent, CoordinationAction{"role-allocation", {}, {}});
    }
  }

  template <class What>
  ComponelIndex add(const char* letter, ComponelIndex parent, What what) {
    Componel componel;
    componel.id = letter + std::to_string(automaton_.size());
    componel.parent = parent;
    componel.what = std::move(what);
    return *automaton_.add(std::move(componel));
  }

  Formula formula(double chance, bool exit, bool loop) {
    Formula formula;
    if (!random_.chance(chance)) return formula;
    formula.resize(random_.chance(0.7) ? 1 : 2);
    for (Clause& clause : formula) {
      const std::uint64_t size = random_.chance(0.02) ? 0 : 1 + random_.below(2);
      for (std::uint64_t i = 0; i < size; ++i) {
        clause.push_back(literal());
        if (exit && loop && random_.chance(0.5)) clause.back().effect = ExitEffect::kContinue;
      }
    }
    return formula;
  }

  Literal literal() {
    Literal literal;
    const double kind = random_.uniform();
    if (kind < 0.5) {
      literal.condition = ComponelIs{componel(), asked()};
    } else if (kind < 0.75) {
      static const std::vector<std::string> kMessages{"m1", "m2", "s1 violated", "s2 satisfied"};
      literal.condition = MessagePending{kMessages[random_.below(kMessages.size())]};
    } else {
      TimeIs is;
      is.after = Duration::seconds(static_cast<double>(random_.below(20)));
      if (kind < 0.85) is.since = TimeIs::ModelStart{};
      if (kind > 0.9) {
        is.since = TimeIs::Event{componel(), asked()};
        is.after = Duration::seconds(static_cast<double>(random_.below(5)) - 1);
      }
      is.passed = random_.chance(0.6);
      literal.condition = is;
    }
    literal.negated = random_.chance(0.2);
    literal.modality = random_.chance(0.25) ? Modality::kOptional : Modality::kMandatory;
    return literal;
  }

  ComponelIndex componel() { return random_.below(automaton_.size()); }
  AskedState asked() {
    return random_.chance(0.5) ? AskedState::kEnded : static_cast<AskedState>(random_.below(6));
  }

  Random random_;
  Automaton automaton_;
  std::uint64_t depth_ = 0;
};

/// Inputs with instants that never decrease, whole seconds; the first is the start.
inline std::vector<std::pair<MissionTime, Input>> random_trace(const Automaton& automaton,
                                                               std::uint64_t seed,
                                                               std::size_t length) {
  Random random(seed, "trace");
  std::vector<std::pair<MissionTime, Input>> trace;
  double at = static_cast<double>(random.below(3));
  const auto leaf = [&] {
    ComponelIndex index = random.below(automaton.size());
    while (automaton[index].block() != nullptr) index = (index + 1) % automaton.size();
    return automaton[index].id;
  };
  trace.emplace_back(MissionTime::seconds(at), Start{});
  while (trace.size() < length) {
    if (random.chance(0.4)) at += static_cast<double>(random.below(4));
    Input input = Tick{};
    const double kind = random.uniform();
    if (kind < 0.65) {
      input = Status{leaf(), static_cast<Status::Word>(random.below(3))};
    } else if (kind < 0.8) {
      input = Message{random.chance(0.5) ? "m1" : "m2"};
    } else if (kind < 0.95) {
      input = ScmReport{random.chance(0.5) ? "s1" : "s2",
                        static_cast<ScmReport::Finding>(random.below(3))};
    } else if (kind < 0.955) {
      input = Abort{};
    } else if (kind < 0.96) {
      input = Start{};
    } else if (kind < 0.965) {
      input = Status{"nobody", Status::Word::kEnded};
    }
    trace.emplace_back(MissionTime::seconds(at), std::move(input));
  }
  return trace;
}

}  // namespace skein::interaction::testing
