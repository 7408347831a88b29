// SPDX-License-Identifier: Apache-2.0
// The Lisp-like terms of a domain: compiled once, evaluated during the search.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/htn/definitions.hpp"
#include "skein/htn/functions.hpp"
#include "skein/htn/term_store.hpp"

namespace skein::htn {

/// A compiled expression of a Lisp.
using CodeIndex = std::uint32_t;
inline constexpr CodeIndex kNoCode = 0xFFFFFFFFU;

/// Where an expression failed and why.
struct LispError {
  std::string why;
  Expression where;
};

/// Slot of a clause variable (the symbol `?x`), or none if the clause does not know it.
using SlotOf = std::function<std::optional<std::uint32_t>(Term variable)>;
/// Value of a slot during evaluation: bound as far as known; may contain search variables.
using SlotValue = std::function<Term(std::uint32_t slot)>;

class Lisp {
 public:
  /// Functions defined in the files (defun) come after the built-in ones and the host's. Their
  /// bodies are compiled when first used; what no domain uses may contain anything.
  Lisp(TermStore& store, const Functions& host, const std::vector<FunctionDefinition>& defined);
  ~Lisp();

  /// An expression whose value is wanted. Values of slots stand for themselves, quoted or not; a
  /// symbol that is no variable of the expression stands for itself. Unknown functions, wrong
  /// argument counts: `errors`, kNoCode.
  CodeIndex compile(Expression expression, const SlotOf& slot_of, Diagnostics& errors);
  /// (call f a b…): the children of `call` from the second on are function and arguments.
  CodeIndex compile_call(Expression call, const SlotOf& slot_of, Diagnostics& errors);
  /// A term in which each (call f a b…) at any depth stands for its value and all else for itself.
  CodeIndex compile_template(Expression expression, const SlotOf& slot_of, Diagnostics& errors);
  /// A function designator: #'<, 'f, f, (lambda …).
  CodeIndex compile_function(Expression function, const SlotOf& slot_of, Diagnostics& errors);

  /// Cost bounds: evaluation steps (see limit_steps) and nesting of calls, an error beyond; the
  /// machine stack does not grow with the expression or its data. Not from inside a host function.
  tl::expected<Term, LispError> evaluate(CodeIndex code, const SlotValue& slots);
  /// Calls the function that `function` designates.
  tl::expected<Term, LispError> apply(CodeIndex function, std::span<const Term> arguments,
                                      const SlotValue& slots);

  /// Global variables get their first values again, as when Lisp loads the files: to call before
  /// each search, which nothing that an earlier one assigned may change.
  void begin();

  /// Most steps (instructions and items of lists visited) of one evaluation; 5 million at first.
  void limit_steps(std::uint64_t steps);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace skein::htn
