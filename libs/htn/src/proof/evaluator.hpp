// SPDX-License-Identifier: Apache-2.0
// Values of Lisp terms under the current bindings.
#pragma once

#include <optional>
#include <string>

#include "compile/compiled_domain.hpp"
#include "proof/answers.hpp"
#include "proof/budget.hpp"

namespace skein::htn {

/// "file:line:column" of an expression.
std::string place_text(Expression where);

/// A term that cannot be evaluated ends the search, with the position of the term.
class Evaluator {
 public:
  Evaluator(CompiledDomain& domain, Bindings& bindings, Budget& budget)
      : domain_(domain), store_(domain.store), bindings_(bindings), budget_(budget) {}

  std::optional<Term> value_of(CodeIndex code, Base base);
  /// Binds a variable to the value; any other pattern must be `equalp` to it.
  bool bind(Term pattern, Base base, Term value);
  /// :sort-by, stable as in SBCL: rows by the value of an expression under each of them.
  bool sort(const Condition& condition, Base base, Answers& answers);

 private:
  bool before(const Condition& condition, Term left, Term right);

  CompiledDomain& domain_;
  TermStore& store_;
  Bindings& bindings_;
  Budget& budget_;
};

}  // namespace skein::htn
