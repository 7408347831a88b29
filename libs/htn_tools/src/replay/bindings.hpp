// SPDX-License-Identifier: Apache-2.0
// Values of variables for the validator: one table, undone in reverse.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "skein/htn/term_store.hpp"

namespace skein::htn::replay {

/// Variables are terms of kind kVariable, numbered from 0. The floats of a plan file do not tell
/// their precision: two numbers that are written alike count as equal here. No recursion.
class Bindings {
 public:
  struct Mark {
    std::size_t trail = 0;
    std::size_t variables = 0;
  };

  explicit Bindings(TermStore& store) : store_(store) {}

  /// The first of `count` new variables.
  std::uint32_t fresh(std::uint32_t count);
  Mark mark() const { return {trail_.size(), values_.size()}; }
  void undo(const Mark& mark);

  /// The pattern of a clause whose slots are the variables from `base` on, with all that is known
  /// put in.
  Term instance(Term pattern, std::uint32_t base) const { return rewrite(pattern, base); }
  Term resolve(Term term) const { return rewrite(term, 0); }
  /// On failure some variables may be bound: undo.
  bool unify(Term left, Term right);

 private:
  Term rewrite(Term term, std::uint32_t base) const;
  Term known(Term term, std::uint32_t base) const;
  bool occurs(Term variable, Term inside) const;
  bool bind(Term variable, Term value);

  TermStore& store_;
  std::vector<std::optional<Term>> values_;
  std::vector<std::uint32_t> trail_;
};

/// Equal, or numbers that are written alike.
bool alike(const TermStore& store, Term left, Term right);

/// `term` with every variable replaced by what `value_of` gives for it.
Term replace_variables(TermStore& store, Term term, const std::function<Term(Term)>& value_of);

}  // namespace skein::htn::replay
