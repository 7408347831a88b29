// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "compile/condition_compiler.hpp"
#include "compile/expression_term.hpp"
#include "language/problem_reader.hpp"
#include "language/read_context.hpp"
#include "skein/htn/domain.hpp"

namespace skein::htn {

namespace {

/// Reads the tasks of a problem; variables are numbered by name.
class NetworkReader {
 public:
  explicit NetworkReader(TermStore& store) : store_(store) {}

  /// The reader of files refuses what is nested deeper.
  TaskNetwork read(Expression expression, std::uint32_t depth = 0) {
    TaskNetwork network;
    std::vector<Expression> all = parts(expression);
    if (all.empty() || depth > kDeepestNesting) return network;
    const std::string_view name = word(all.front());
    if (name == ":ordered" || name == ":unordered" || (*all.front()).list) {
      if (name == ":unordered") network.kind = NetworkKind::kUnordered;
      if (!name.empty()) all.erase(all.begin());
      for (const Expression part : all) network.children.push_back(read(part, depth + 1));
      return network;
    }
    return task(expression, name);
  }

 private:
  std::string_view word(Expression expression) const {
    const bool symbol = !(*expression).list && (*expression).atom.is(TermKind::kSymbol);
    return symbol ? store_.name((*expression).atom) : std::string_view{};
  }

  TaskNetwork task(Expression expression, std::string_view name) {
    TaskNetwork network;
    network.kind = NetworkKind::kTask;
    network.task = term_of(
        expression, store_, [this](Term atom) { return number(atom); }, scratch_);
    if (name == ":task") network.task = store_.cdr(network.task);
    const Term immediate = store_.symbol(":immediate");
    if (network.task.is(TermKind::kPair) && store_.car(network.task) == immediate) {
      network.task = store_.cdr(network.task);
      network.immediate = true;
    }
    return network;
  }

  Term number(Term atom) {
    if (!is_variable(store_, atom)) return atom;
    const auto known = std::find(variables_.begin(), variables_.end(), atom);
    const auto index = static_cast<std::uint32_t>(known - variables_.begin());
    if (known == variables_.end()) variables_.push_back(atom);
    return {TermKind::kLocal, index};
  }

  TermStore& store_;
  TermScratch scratch_;
  std::vector<Term> variables_;
};

}  // namespace

Problem make_problem(const ProblemDefinition& definition, TermStore& store) {
  Problem problem;
  problem.name = definition.name;
  TermScratch scratch;
  const auto leaf = [](Term atom) { return atom; };
  for (const Expression fact : parts(definition.facts)) {
    if (!is_fact(fact)) continue;
    problem.facts.push_back(term_of(fact, store, leaf, scratch));
  }
  problem.tasks = NetworkReader(store).read(definition.tasks);
  return problem;
}

}  // namespace skein::htn
