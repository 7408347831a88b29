// SPDX-License-Identifier: Apache-2.0
// Runs compiled Lisp terms: calls of the files' functions use an explicit stack, not the machine's.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "lisp/program.hpp"

namespace skein::htn::lisp {

/// One evaluation at a time; the memory it needs is kept for the next.
class Machine {
 public:
  explicit Machine(Program& program);

  tl::expected<Term, LispError> evaluate(const Unit& unit, const SlotValue& slots);
  /// Evaluates `function` to a function value and calls that.
  tl::expected<Term, LispError> apply(const Unit& function, Arguments arguments,
                                      const SlotValue& slots);
  /// Global variables as the files define them, no table, no array.
  void begin();
  void limit_steps(std::uint64_t steps) { step_limit_ = steps; }

  // For the built-in functions:
  TermStore& store() { return program_.store(); }
  /// Calls a function value: a name, or what `lambda` gave.
  Outcome call(Term function, Arguments arguments);
  /// Counts work beyond that of instructions; false when the evaluation takes too long: give up
  /// with kTooLong.
  bool charge(std::size_t steps);
  bool is_function(Term term);
  /// What can be changed in place: hash tables and arrays, from `make-…` on until begin().
  struct Table {
    bool loose = false;  ///< keys that are `equalp` are one
    std::unordered_map<Term, Term> values;
  };
  struct Array {
    std::vector<std::size_t> sizes;
    std::vector<Term> items;
  };
  Term add_table(Table table);
  Term add_array(Array array);
  /// Null for anything else.
  Table* table(Term term);
  Array* array(Term term);

  static constexpr const char* kTooLong = "the evaluation takes too many steps";

 private:
  struct Frame {
    const Unit* unit = nullptr;
    std::uint32_t pc = 0;
    std::uint32_t base = 0;   ///< of its locals in the stack
    std::uint32_t given = 0;  ///< arguments of the call
  };

  void start(const SlotValue& slots);
  tl::expected<Term, LispError> finish(Outcome outcome);

  // Each gives false on a failure, which is then in failure_.
  bool run(std::size_t depth);
  bool execute(const Instruction& instruction);
  bool execute_variable(const Instruction& instruction);
  bool call_named(std::uint32_t index, std::uint32_t count);
  bool call_value(std::uint32_t count);
  bool enter(const Unit& unit, std::uint32_t count, Term captured);
  bool fail(std::string why);

  Outcome call_directly(const Callable& callable, Arguments arguments);
  Outcome call_unit(const Unit& unit, Arguments arguments, Term captured);
  /// The unit of a name or function object; its captured values.
  struct Target {
    const Callable* callable = nullptr;
    const Unit* unit = nullptr;
    Term captured;
  };
  Result<Target, Failure> target(Term function);
  struct Global {
    std::optional<Term> value;
    bool begun = false;  ///< its first value is known, or in the making
  };
  Global& global_at(std::uint32_t index);
  bool push_global(const Instruction& instruction);
  void leave();
  void place_arguments(const Unit& unit, std::uint32_t count);
  Term instance(Term pattern);
  Term closure(std::uint32_t unit);
  Term new_box(Term value);
  Term take_list(std::uint32_t count, Term tail);

  void push(Term term) { stack_.push_back(term); }
  Term pop() {
    const Term top = stack_.back();
    stack_.pop_back();
    return top;
  }
  Term& local(std::uint32_t index) { return stack_[frames_.back().base + index]; }
  Arguments top(std::uint32_t count) const {
    return Arguments(stack_).subspan(stack_.size() - count);
  }

  Program& program_;
  std::vector<Term> stack_;  ///< never grows beyond what is reserved: arguments stay where they are
  std::vector<Frame> frames_;
  std::vector<Term> boxes_;
  std::vector<Global> globals_;
  std::deque<Table> tables_;
  std::deque<Array> arrays_;
  const SlotValue* slots_ = nullptr;
  std::string failure_;
  std::optional<Expression> where_;  ///< innermost place of the failure
  std::uint64_t steps_ = 0;
  std::uint64_t step_limit_;
  int nesting_ = 0;  ///< of built-in functions that call functions
};

}  // namespace skein::htn::lisp
