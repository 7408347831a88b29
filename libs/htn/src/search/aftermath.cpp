// SPDX-License-Identifier: Apache-2.0
#include "skein/htn/aftermath.hpp"

#include "proof/budget.hpp"
#include "search/search.hpp"

namespace skein::htn {

/// A search that only relives the past; what it points to is kept here.
class Aftermath::State {
 public:
  State(const Domain& domain, const Problem& problem)
      : problem_(problem), search_(domain, problem_, options_, silent_) {}

  std::size_t relive(Budget& budget) { return search_.relive(budget); }
  const FactBase& facts() const { return search_.facts(); }

 private:
  const Problem problem_;
  const Options options_;
  const Host silent_;
  Search search_;
};

Aftermath::Aftermath(const Domain& domain, const Problem& problem, const Limits& limits,
                     const Host& host)
    : state_(std::make_unique<State>(domain, problem)) {
  Budget budget(limits, host, [] { return std::size_t{0}; });
  events_ = state_->relive(budget);
  failed_ = budget.error();
  cut_ = budget.stopped() && !failed_;
  why_ = budget.why();
}

Aftermath::~Aftermath() = default;

bool Aftermath::holds(Term fact) const { return state_->facts().holds(fact); }

std::vector<Term> Aftermath::facts() const { return state_->facts().atoms(); }

}  // namespace skein::htn
