// SPDX-License-Identifier: Apache-2.0
// All functions and all compiled code of a Lisp.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "lisp/code.hpp"
#include "skein/foundation/diagnostics.hpp"
#include "skein/htn/lisp.hpp"

namespace skein::htn::lisp {

/// Owner of units and of the table of functions. Units stay where they are.
class Program {
 public:
  Program(TermStore& terms, const Functions& host, const std::vector<FunctionDefinition>& defined);

  TermStore& store() { return store_; }

  /// The function of that name: built in, the host's, or defined in the files.
  std::optional<std::uint32_t> find(Term name);
  const Callable& callable(std::uint32_t index) const { return callables_[index]; }
  /// Notes that the function will be called: `compile_pending` must follow.
  void want(std::uint32_t callable);
  /// Compiles the wanted functions of the files, those that these call, and so on; each once.
  void compile_pending(Diagnostics& errors);
  std::vector<std::string> function_names() const;

  std::uint32_t add_unit(Unit unit);
  Unit& unit(std::uint32_t index) { return units_[index]; }
  const Unit& unit(std::uint32_t index) const { return units_[index]; }
  std::size_t unit_count() const { return units_.size(); }
  /// Global variables: those that the files define, and every name written *so*. The number of one;
  /// none for other names.
  std::optional<std::uint32_t> global(Term name);
  struct Global {
    Term name;
    const FunctionDefinition* definition = nullptr;  ///< null: none, it has no first value
    std::optional<std::uint32_t> first_value;        ///< unit, once it is compiled
  };
  const std::deque<Global>& globals() const { return globals_; }

  /// Function values: an opaque object for a unit, and back.
  Term function_object(std::uint32_t unit);
  std::optional<std::uint32_t> unit_of(Term object) const;

 private:
  struct UnitReference {
    const Program* program = nullptr;
    std::uint32_t unit = 0;
  };
  void add_callable(Callable callable, Term name);
  void compile_first_value(Global& global, Diagnostics& errors);

  TermStore& store_;
  const Functions& host_;
  std::deque<Callable> callables_;
  std::unordered_map<Term, std::uint32_t> by_name_;
  std::deque<Unit> units_;
  std::unordered_map<std::uint32_t, Term> objects_;
  std::deque<FunctionDefinition> definitions_;
  std::vector<std::uint32_t> pending_;
  std::deque<Global> globals_;
  std::unordered_map<Term, std::uint32_t> global_by_name_;
  std::unordered_map<Term, const FunctionDefinition*> variables_;  ///< the last definition of each
  std::vector<std::uint32_t> pending_globals_;
};

}  // namespace skein::htn::lisp
