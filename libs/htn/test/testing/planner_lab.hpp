// SPDX-License-Identifier: Apache-2.0
// Terms with variables from text, for tests of bindings and facts.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "compile/expression_term.hpp"
#include "proof/bindings.hpp"
#include "skein/htn/term_map.hpp"

namespace skein::htn::test {

/// In `term` a variable `?x` is a cell of the bindings, the same in every text; in `pattern` it is
/// a slot, numbered by the names of the clause.
class Lab {
 public:
  TermStore store;
  Bindings bindings{store};

  Term term(const std::string& text) {
    return read(text, [this](Term variable) { return cell(variable); });
  }
  /// `names` are the slots in order.
  Term pattern(const std::string& text, const std::vector<std::string>& names) {
    return read(text, [this, &names](Term variable) {
      for (std::uint32_t slot = 0; slot < names.size(); ++slot) {
        if (store.symbol(names[slot]) == variable) return Term(TermKind::kSlot, slot);
      }
      ADD_FAILURE() << "no slot " << store.to_text(variable);
      return kNil;
    });
  }
  bool unify(const std::string& left, const std::string& right) {
    const Term one = term(left);
    return bindings.unify(one, 0, term(right), 0);
  }
  /// What is known of the term, its unbound variables by their names.
  std::string known(const std::string& text) { return shown(bindings.instance(term(text), 0)); }
  std::string shown(Term term) {
    return store.to_text(map_leaves(store, term, kHasVariable, [this](Term variable) {
      const auto named = names_.find(variable.index());
      return named == names_.end() ? variable : named->second;
    }));
  }
  Term nested(std::size_t depth, Term inside) {
    for (std::size_t level = 0; level < depth; ++level) inside = store.pair(inside, kNil);
    return inside;
  }

 private:
  template <class Leaf>
  Term read(const std::string& text, Leaf leaf) {
    Diagnostics errors;
    const Document document = read_document("lab", text, store, errors);
    EXPECT_TRUE(errors.empty()) << text;
    const auto replaced = [&](Term atom) {
      const bool variable = atom.is(TermKind::kSymbol) && store.name(atom).starts_with('?');
      return variable ? leaf(atom) : atom;
    };
    TermScratch scratch;
    return term_of(Expression{&document, document.top.front()}, store, replaced, scratch);
  }
  Term cell(Term variable) {
    const auto known = cells_.find(variable.index());
    if (known != cells_.end()) return {TermKind::kVariable, known->second};
    const Base made = bindings.open(1);
    cells_.emplace(variable.index(), made);
    names_.emplace(made, variable);
    return {TermKind::kVariable, made};
  }
  std::map<std::uint32_t, std::uint32_t> cells_;
  std::map<std::uint32_t, Term> names_;
};

}  // namespace skein::htn::test
