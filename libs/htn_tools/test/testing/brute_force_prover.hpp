// SPDX-License-Identifier: Apache-2.0
// Oracle: all answers of a query, in the order the language defines, by plain recursion on values.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "replay/clauses.hpp"

namespace skein::htn::oracle {

/// An error of the domain, or a budget that is spent; caught by brute_force().
struct Stop : std::runtime_error {
  enum class Kind { kError, kBudget };
  Stop(Kind why_kind, const std::string& why) : std::runtime_error(why), kind(why_kind) {}
  Kind kind;
};

/// Values of variables, copied freely.
class Substitution {
 public:
  explicit Substitution(TermStore& store) : store_(&store) {}
  Term resolve(Term term) const { return instance(term, 0); }
  Term instance(Term pattern, std::uint32_t base) const;
  bool unify(Term left, Term right);
  void set(Term variable, Term value) { values_[variable.index()] = value; }

 private:
  Term value(Term term, std::uint32_t base) const;
  bool occurs(Term variable, Term term) const;
  TermStore* store_;
  std::map<std::uint32_t, Term> values_;
};

/// Facts of each predicate, the newest first. Undoing a deletion makes the fact the newest.
class Facts {
 public:
  explicit Facts(const TermStore& store) : store_(store) {}
  struct Change {
    bool added;
    Term fact;
  };
  const std::vector<Term>& of(Term predicate) const;
  bool holds(Term fact) const;
  void add(Term fact, std::vector<Change>& changes);
  void remove(Term fact, std::vector<Change>& changes);
  void undo(const std::vector<Change>& changes);

 private:
  std::vector<Term>& list_of(Term fact);
  const TermStore& store_;
  std::map<std::uint32_t, std::vector<Term>> facts_;
};

class Prover {
 public:
  using Goals = std::vector<replay::Goal>;
  Prover(TermStore& store, const replay::Clauses& clauses, Lisp& lisp, const Facts& facts,
         std::uint64_t most_inferences)
      : store_(store), clauses_(clauses), lisp_(lisp), facts_(facts), left_(most_inferences) {}

  /// Every answer, none twice; with just_one the one met first.
  std::vector<Substitution> find(const Goals& goals, std::uint32_t base, const Substitution& known,
                                 bool just_one);
  /// The same with :first and :sort-by obeyed.
  std::vector<Substitution> find(const replay::Condition& condition, std::uint32_t base,
                                 const Substitution& known, bool just_one);
  bool holds(Term goal, const Substitution& known);
  Term evaluate(CodeIndex code, std::uint32_t base, const Substitution& known);
  std::uint32_t fresh(std::uint32_t count) {
    const std::uint32_t first = next_variable_;
    next_variable_ += count;
    return first;
  }
  std::uint64_t inferences() const { return inferences_; }

 private:
  using Answer = std::vector<Term>;  // one value for each variable asked for
  struct Item {
    const replay::Goal* goal = nullptr;
    std::uint32_t base = 0;
    std::optional<Term> term;         // instead of goal
    std::shared_ptr<bool> committed;  // instead of both: the cut of an axiom
  };
  struct Query {
    Substitution known;
    std::vector<Term> variables;
    bool just_one;
  };
  std::vector<Answer> seek(std::vector<Item> items, const Query& query);
  std::vector<Answer> seek_goal(const Item& item, const std::vector<Item>& rest,
                                const Query& query);
  std::vector<Answer> seek_atom(Term atom, const std::vector<Item>& rest, const Query& query);
  std::vector<Answer> seek_axiom(const replay::AxiomClause& axiom, Term atom,
                                 const std::vector<Item>& rest, const Query& query);
  std::vector<Answer> seek_each(const std::vector<Substitution>& ways,
                                const std::vector<Item>& rest, const Query& query);
  std::vector<Answer> seek_assigned(const Item& item, const std::vector<Item>& rest,
                                    const Query& query);
  bool quantified(const Item& item, const Query& query);
  std::vector<Substitution> collected(const Item& item, const Query& query);
  std::vector<Substitution> alternatives(const Item& item, const Query& query);
  std::vector<Item> items_of(const Goals& goals, std::uint32_t base) const;
  const Goals& as_element(const Goals& goals);
  const Goals& as_disjunction(const replay::Goal& imply);
  void variables_in(const Goals& goals, std::uint32_t base, const Substitution& known,
                    std::vector<Term>& out) const;

  TermStore& store_;
  const replay::Clauses& clauses_;
  Lisp& lisp_;
  const Facts& facts_;
  std::uint64_t left_;
  std::uint64_t inferences_ = 0;
  std::uint32_t next_variable_ = 0;
  std::map<const void*, Goals> made_;  // by what they are made of, which lives in clauses_ or here
};

/// `term` and its variables written so that texts can be compared: every variable is "?".
std::string plain_text(TermStore& store, Term term);

}  // namespace skein::htn::oracle
