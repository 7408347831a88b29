// SPDX-License-Identifier: Apache-2.0
// Whether a logical expression is well formed, and which atoms it asks for.
#pragma once

#include <cstddef>
#include <vector>

#include "language/read_context.hpp"

namespace skein::htn {

/// Walks expressions of any nesting with its own stack. What is wrong goes to the context's errors.
class ConditionChecker {
 public:
  explicit ConditionChecker(const ReadContext& context) : context_(context) {}

  /// A precondition of a branch or operator: may begin with :first or :sort-by.
  void check_precondition(Expression precondition);
  void check(Expression condition);

  /// The atoms met so far, those with a variable for a predicate left out.
  const std::vector<Expression>& atoms() const { return atoms_; }

 private:
  void check_one(Expression condition);
  void enclose_tail(Expression conditions) const;
  void check_list(Expression condition, Term word);
  bool check_word(Expression condition, Term word);
  void check_sort(Expression condition);
  void check_quantifier(const std::vector<Expression>& all);
  void check_collection(const std::vector<Expression>& all);
  void check_assignment(const std::vector<Expression>& all);
  void check_evaluation(const std::vector<Expression>& all);
  bool has_arguments(Expression condition, std::size_t least, std::size_t most,
                     const char* shape) const;
  void push_from(const std::vector<Expression>& all, std::size_t begin, std::size_t end);

  const ReadContext& context_;
  std::vector<Expression> open_;
  std::vector<Expression> atoms_;
};

/// Function names as :sort-by and call take them: f, 'f, #'f, (lambda …).
bool is_function(const ReadContext& context, Expression expression);

}  // namespace skein::htn
