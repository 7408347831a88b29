// SPDX-License-Identifier: Apache-2.0
// The possible reductions of a task by a method in the current state.
#pragma once

#include <string>
#include <vector>

#include "proof/prover.hpp"
#include "proof/row_set.hpp"

namespace skein::htn {

/// One reduction: the tasks of a branch under one satisfier, with one task forced to be first.
struct Reduction {
  const Branch* branch = nullptr;
  std::uint32_t forcing = 0;
  std::uint32_t tasks = 0;     ///< first of the leaves in ReductionPool::tasks
  std::uint32_t bindings = 0;  ///< first of the values that the reduction binds to older variables
  std::uint32_t bindings_end = 0;
  std::uint32_t locals = 0;  ///< number of new variables that are still unbound
  std::uint32_t support = 0xFFFFFFFFU;
};

/// Stack of reductions that have not been tried; cut back when the search backtracks.
struct ReductionPool {
  std::vector<Reduction> reductions;
  std::vector<Term> tasks;
  std::vector<std::pair<Term, Term>> bindings;
  std::vector<std::vector<CausalLink>> support;

  struct Mark {
    std::uint32_t reductions = 0;
    std::uint32_t tasks = 0;
    std::uint32_t bindings = 0;
    std::uint32_t support = 0;
  };
  Mark mark() const {
    const auto size = [](const auto& items) { return static_cast<std::uint32_t>(items.size()); };
    return {size(reductions), size(tasks), size(bindings), size(support)};
  }
  void cut(Mark mark) {
    reductions.resize(mark.reductions);
    tasks.resize(mark.tasks);
    bindings.resize(mark.bindings);
    support.resize(mark.support);
  }
  std::size_t memory_bytes() const {
    return reductions.capacity() * sizeof(Reduction) + tasks.capacity() * sizeof(Term) +
           bindings.capacity() * sizeof(std::pair<Term, Term>);
  }
};

/// Computes reductions: all satisfiers of the first branch that has any, in order, without
/// duplicates.
class Reducer {
 public:
  Reducer(CompiledDomain& domain, Bindings& bindings, Prover& prover, Budget& budget,
          ReductionPool& pool)
      : domain_(domain),
        store_(domain.store),
        bindings_(bindings),
        prover_(prover),
        budget_(budget),
        pool_(pool) {}

  /// Called for each branch that was taken or refused, with its satisfiers; for traces.
  using Tell = std::function<void(const Method&, const Branch&, Base, const Answers&)>;

  /// Appends the reductions of `task` by the method to the pool; restores all bindings.
  void reduce(const Method& method, Term task, const Tell& tell);
  /// Applies a reduction: creates its new variables, binds the older ones, and returns the tasks
  /// for the agenda (valid until the next call).
  const Term* install(const Reduction& reduction);

 private:
  void add(const Branch& branch, Bindings::Mark mark, Base base, const Answers& answers);
  bool add_row(const Branch& branch, Bindings::Mark mark, Base base);
  std::optional<Term> leaf(const BodyNode& node, Base base);

  CompiledDomain& domain_;
  TermStore& store_;
  Bindings& bindings_;
  Prover& prover_;
  Budget& budget_;
  ReductionPool& pool_;
  Answers answers_;
  RowSet made_;
  std::vector<Term> renamed_;
  std::vector<Term> ready_;
};

}  // namespace skein::htn
