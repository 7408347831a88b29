// SPDX-License-Identifier: Apache-2.0
#include "skein/interaction/check_automaton.hpp"

#include <algorithm>

#include "possibilities.hpp"

namespace skein::interaction {

namespace {

class AutomatonChecker {
 public:
  AutomatonChecker(const Automaton& automaton, const std::string& file, Diagnostics& problems)
      : automaton_(automaton), possible_(automaton), file_(file), problems_(problems) {}

  void check() {
    for (ComponelIndex i = 0; i < automaton_.size(); ++i) {
      if (automaton_[i].block() == nullptr) continue;
      const bool reachable =
          i == 0 || possible_.reaches(automaton_[i].parent, AskedState::kRunning);
      if (!reachable) continue;  // said of the block around it
      check_formula({i, Side::kPrecondition});
      check_formula({i, Side::kExit});
      check_reached(i);
      check_way_out(i);
    }
  }

 private:
  void report(ComponelIndex index, const char* key, std::string message, std::string expected) {
    const Componel& componel = automaton_[index];
    const std::string path = componel.path.substr(0, componel.path.rfind("block")) + key;
    problems_.add({file_, componel.line, 0, path, std::move(message), std::move(expected), ""});
  }

  void check_formula(Watch where) {
    const Formula& formula = possible_.formula(where);
    const char* key = where.side == Side::kPrecondition ? "pre" : "exit";
    const std::size_t before = problems_.size();
    for (std::size_t c = 0; c < formula.size(); ++c) {
      if (formula[c].empty()) {
        report(where.block, key, "a clause without literals can never be true", "a literal in it");
      }
      for (std::size_t l = 0; l < formula[c].size(); ++l) {
        if (possible_.may_hold(formula[c][l], where)) continue;
        const std::string place =
            std::string(key) + "[" + std::to_string(c) + "][" + std::to_string(l) + "]";
        report(where.block, place.c_str(), "this can never hold: " + why(formula[c][l], where),
               remedy(formula[c][l], where));
      }
    }
    if (problems_.size() == before && !formula.empty() && !possible_.may_hold(where)) {
      report(where.block, key, "its clauses can never be true together",
             "clauses that do not exclude each other");
    }
  }

  std::string why(const Literal& literal, Watch where) const {
    if (const auto* is = std::get_if<ComponelIs>(&literal.condition)) return why(*is, where);
    const auto& time = std::get<TimeIs>(literal.condition);
    if (const auto* event = std::get_if<TimeIs::Event>(&time.since)) {
      return "'" + automaton_[event->componel].id + "' never is " +
             std::string(to_text(event->state));
    }
    return "the instant has passed when the model starts";
  }

  std::string why(const ComponelIs& is, Watch where) const {
    const std::string id = "'" + automaton_[is.componel].id + "'";
    if (automaton_.contains(is.componel, where.block)) return id + " is around it and running then";
    if (is.componel == where.block) return "it is about the block itself";
    if (where.side == Side::kPrecondition && automaton_.contains(where.block, is.componel)) {
      return id + " is inside the block and has no state before";
    }
    const Block* block = automaton_[is.componel].block();
    if (is.state == AskedState::kEnded && block != nullptr && block->type == BlockType::kLoop) {
      return id + " is a loop, which is left by its exit and aborted then";
    }
    return id + " never is " + std::string(to_text(is.state));
  }

  std::string remedy(const Literal& literal, Watch where) const {
    const auto* is = std::get_if<ComponelIs>(&literal.condition);
    if (is == nullptr) return "an instant that can come";
    const Block* block = automaton_[is->componel].block();
    const bool elsewhere = !automaton_.contains(is->componel, where.block);
    if (elsewhere && block != nullptr && block->type == BlockType::kLoop &&
        is->state == AskedState::kEnded) {
      return "state: over";
    }
    return "a state that can come";
  }

  void check_reached(ComponelIndex index) {
    if (possible_.reaches(index, AskedState::kRunning)) return;
    report(index, "pre", "the block '" + automaton_[index].id + "' can never be activated",
           "a precondition that can come true");
  }

  // --- ways out of loops
  // ---------------------------------------------------------------------------

  // What comes only after it is over does not end it.
  void check_way_out(ComponelIndex index) {
    if (automaton_[index].block()->type != BlockType::kLoop) return;
    const Possibilities before(automaton_, index);
    if (has_exit(index, before)) return;
    ComponelIndex inner = index;
    while (inner != 0) {
      const ComponelIndex outer = automaton_[inner].parent;
      if (is_ended_beside(inner, before)) return;
      if (has_exit(outer, before) && !is_interruption(outer)) return;
      inner = outer;
    }
    report(index, "exit", "the loop '" + automaton_[index].id + "' has no way out",
           "an exit, or an immediate block beside it");
  }

  // Of effect exit, and possible.
  static bool has_exit(ComponelIndex index, const Possibilities& possible) {
    const Watch where{index, Side::kExit};
    if (!possible.may_hold(where)) return false;
    for (const Clause& clause : possible.formula(where)) {
      for (const Literal& literal : clause) {
        if (literal.effect == ExitEffect::kExit && possible.may_hold(literal, where)) return true;
      }
    }
    return false;
  }

  bool is_interruption(ComponelIndex index) const {
    if (index != 0) return false;
    for (const Clause& clause : automaton_[index].block()->exit) {
      for (const Literal& literal : clause) {
        if (!std::holds_alternative<MessagePending>(literal.condition)) return false;
      }
    }
    return true;
  }

  // The end of another block of the same content interrupts it.
  bool is_ended_beside(ComponelIndex index, const Possibilities& possible) const {
    const auto& content = automaton_[automaton_[index].parent].block()->content;
    return std::any_of(content.begin(), content.end(), [&](ComponelIndex one) {
      const Block* block = automaton_[one].block();
      return one != index && block != nullptr && block->end == EndMode::kImmediate &&
             possible.reaches(one, AskedState::kEnded);
    });
  }

  const Automaton& automaton_;
  Possibilities possible_;
  const std::string& file_;
  Diagnostics& problems_;
};

}  // namespace

void check_automaton(const Automaton& automaton, const std::string& file, Diagnostics& problems) {
  if (!automaton.empty()) AutomatonChecker(automaton, file, problems).check();
}

}  // namespace skein::interaction
