// SPDX-License-Identifier: Apache-2.0
// What every part of the reader of definitions shares.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "language/words.hpp"
#include "skein/htn/definitions.hpp"

namespace skein::htn {

/// Definitions nested deeper are errors: what works on them may recur.
inline constexpr std::uint32_t kDeepestNesting = 1000;

struct ReadContext {
  TermStore& store;
  const Words& words;
  const IncludeReader& include;
  Definitions& definitions;
  Diagnostics& errors;
  Diagnostics& warnings;
  bool wary = true;        ///< what is merely suspicious is looked for
  bool singletons = true;  ///< false inside (let ((*ignore-singleton-variables* t)) …)

  void error(Expression where, std::string message, std::string expected = "",
             std::string nearest = "") const;
  void warn(Expression where, std::string message, std::string expected = "",
            std::string nearest = "") const;

  /// What a list has from `from` on becomes a list of its own, its last part: for parentheses that
  /// were left out. The new list stands behind all other nodes of its document.
  void enclose(Expression list, Expression from) const;

  /// nil and () alike.
  bool is_nil(Expression expression) const;
  bool is_symbol(Expression expression) const;
  bool is_variable(Expression expression) const;
  /// A symbol that is neither a variable nor nil.
  bool is_name(Expression expression) const;
  bool is_list(Expression expression) const { return (*expression).list; }
  /// The symbol a list begins with; nil when it begins otherwise, or is no list.
  Term head(Expression expression) const;
  std::string name(Expression symbol) const { return std::string(store.name((*symbol).atom)); }
  std::string name(Term symbol) const { return std::string(store.name(symbol)); }
  bool variable(Term symbol) const { return store.name(symbol).starts_with('?'); }
};

Diagnostic diagnostic_at(Expression where, std::string message, std::string expected,
                         std::string nearest);

/// What stands in the text, in one line, cut when long.
std::string text_of(Expression expression);

/// "1 part", "2 parts".
std::string counted(std::size_t number, const char* what);

/// First child; absent for atoms and ().
Expression first(Expression list);
Expression next(Expression expression);
/// The children in order.
std::vector<Expression> parts(Expression list);
std::size_t count(Expression list);
/// The x of 'x and `x, however often quoted; other expressions as they are.
Expression unquoted(Expression expression, const Words& words);

}  // namespace skein::htn
