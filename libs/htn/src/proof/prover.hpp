// SPDX-License-Identifier: Apache-2.0
// Finds the satisfiers of conditions in a state, with axioms.
#pragma once

#include <array>
#include <deque>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "compile/compiled_domain.hpp"
#include "proof/answers.hpp"
#include "proof/budget.hpp"

namespace skein::htn {

/// Proves goals depth first with its own stacks: neither recursion of axioms nor the length of a
/// conjunction can overflow. The order of answers is that of SHOP3: for one goal, facts before
/// axioms; the answers of a complete query are the reverse of the order in which they are met;
/// `and`, `or` and `imply` are complete queries of their own whose answers are gone through one
/// after the other. Source: docs/decisions/0006-htn-search.md.
class Prover {
 public:
  Prover(CompiledDomain& domain, Bindings& bindings, FactBase& facts, Budget& budget)
      : domain_(domain),
        store_(domain.store),
        bindings_(bindings),
        facts_(facts),
        budget_(budget) {}

  /// All satisfiers of a condition, or the first met. False when the budget stopped the proof.
  bool solve(ConditionIndex condition, Base base, bool just_one, Answers& out);
  /// All satisfiers of the first goals of a condition (for explanations).
  bool solve_part(ConditionIndex condition, std::size_t goals, Base base, Answers& out);
  /// Whether a ground atom holds, by fact or axiom.
  bool holds(Term atom);

  /// Records which facts each answer rests on.
  void record_support(bool on) { recording_ = on; }
  std::size_t memory_bytes() const;

 private:
  enum class Purpose : std::uint8_t {
    kTop,
    kNot,
    kEach,
    kEnforce,
    kAlternative,
    kForallBounds,
    kForallPart,
    kExistsBounds,
    kExistsPart,
    kCollect,
    kHolds  ///< a ground atom, by its axioms
  };
  enum class ContinuationKind : std::uint8_t { kGoals, kCut, kEmit };
  struct Continuation {
    ContinuationKind kind = ContinuationKind::kEmit;
    std::uint32_t position = 0;  // kGoals: next goal; kCut: the frame
    std::uint32_t done = 0;      // kGoals: those behind it that were tried before their turn (bits)
    const std::vector<GoalIndex>* goals = nullptr;
    Base base = 0;
    std::uint32_t next = 0;
  };
  enum class FrameKind : std::uint8_t { kQuery, kAtom, kRows, kOr, kForall, kExists, kItems };
  struct Frame {
    FrameKind kind = FrameKind::kQuery;
    bool committed = false;  // kAtom: a tail of the axiom held
    bool once = false;       // kAtom: one answer of this axiom is enough
    Bindings::Mark mark;
    std::uint32_t continuations = 0;
    std::uint32_t support = 0;
    std::uint32_t after = 0;  // continuation behind the goal
    GoalIndex goal = 0;
    Base base = 0;
    std::uint32_t at = 0;              // row, alternative, or axiom
    std::uint32_t tail = 0;            // kAtom
    std::uint32_t set = 0;             // kRows, kForall, kExists
    std::uint32_t answers_first = 0;   // kAtom: answers of the query when the goal came up
    std::uint32_t answers_middle = 0;  // kAtom: when its axioms began
    bool axioms_begun = false;
    FactBase::Cursor cursor;
    Term items;  // kItems
  };
  struct Query {
    Purpose purpose = Purpose::kTop;
    bool just_one = false;
    bool test = false;       // whether it holds is all that is asked: no answers are kept
    bool any_order = false;  // a test of what is Condition::finite
    std::uint32_t frame = 0;
    std::uint32_t set = 0;
    std::uint32_t after = 0;
    GoalIndex goal = 0;
    Base base = 0;
  };
  enum class Move : std::uint8_t { kForward, kBack, kDone, kStop };

  bool run();
  Move forward();
  Move back();
  Move emit();
  std::uint32_t pick(const Continuation& here);
  bool facts_alone(GoalIndex goal) const;
  std::uint32_t matching(const Goal& goal, Base base);
  Move execute(GoalIndex goal, Base base, std::uint32_t after);

  Move begin(Purpose purpose, ConditionIndex condition, bool just_one, Query query);
  void collect_cells(const Condition& condition, Base base, Answers& answers);
  Move finish_query();
  Move finish_test(bool holds);
  // What follows when a test is over: nothing that could fail.
  bool ends_test(std::uint32_t after) const {
    return queries_.back().test && continuations_[after].kind == ContinuationKind::kEmit;
  }
  bool one_is_enough(const Goal& goal, std::uint32_t after) const;
  Move finish_rows(const Query& query);
  Move finish_collection(const Query& query);
  Move finish_quantifier_bounds(const Query& query);
  Move finish_quantifier_part(bool holds, const std::vector<CausalLink>& support);
  void keep_support(Frame& frame, const std::vector<CausalLink>& support);

  using Values = std::array<Term, kMostFlatArguments>;
  Move atom(GoalIndex goal, Base base, std::uint32_t after);
  Move flat_atom(GoalIndex goal, Base base, std::uint32_t after);
  Move first_fact(GoalIndex goal, const Values& values, Base base, std::uint32_t after);
  Move test_axioms(GoalIndex goal, Base base, std::uint32_t after);
  Move negated(const Goal& goal, Query query);
  Bindings::Known values_of(const Goal& goal, Base base, Values& values);
  FactBase::Candidates candidates(const Goal& goal, const Values& values, Base base);
  bool some_fact(const Goal& goal, Base base);
  Frame& push_atom(GoalIndex goal, Base base, std::uint32_t after);
  Move retry_atom();
  Move try_axioms();
  bool match_fact(std::span<const Term> arguments, Base base, FactIndex fact);
  std::uint32_t answers_so_far();
  Move enter_tail(const Axiom& axiom, Base axiom_base);
  Move leave_atom();
  Move next_row();
  Move next_alternative();
  Move next_item();
  Move quantifier_part();
  Move evaluate(const Goal& goal, Base base, std::uint32_t after);
  Move assign(const Goal& goal, Base base, std::uint32_t after);
  Move assign_each(GoalIndex goal, Base base, std::uint32_t after);
  Move value_as_goal(const Goal& goal, Base base, std::uint32_t after);
  std::optional<GoalIndex> goal_of_term(Term term, const Goal& from);
  std::optional<ConditionIndex> condition_of_atom(Term atom);
  std::optional<ConditionIndex> condition_of_terms(Term list, const Goal& from);
  std::optional<Term> value_of(CodeIndex code, Base base);
  bool bind_value(Term pattern, Base base, Term value);

  Frame& push_frame(FrameKind kind, GoalIndex goal, Base base, std::uint32_t after) {
    Frame& frame = frames_.emplace_back();
    frame.kind = kind;
    frame.mark = bindings_.mark();
    frame.continuations = static_cast<std::uint32_t>(continuations_.size());
    frame.support = static_cast<std::uint32_t>(support_.size());
    frame.after = after;
    frame.goal = goal;
    frame.base = base;
    frame.set = sets_open_;
    return frame;
  }
  void restore(const Frame& frame) {
    bindings_.undo(frame.mark);
    continuations_.erase(continuations_.begin() + frame.continuations, continuations_.end());
    if (recording_) support_.resize(frame.support);
  }
  void pop_frames(std::size_t count);
  std::uint32_t push_goals(const std::vector<GoalIndex>& goals, std::uint32_t position, Base base,
                           std::uint32_t next, std::uint32_t done = 0) {
    for (; (done & 1U) != 0; done >>= 1U) ++position;
    if (position == goals.size()) return next;
    continuations_.push_back({ContinuationKind::kGoals, position, done >> 1U, &goals, base, next});
    return static_cast<std::uint32_t>(continuations_.size() - 1);
  }
  std::uint32_t open_set();
  Answers& set(std::uint32_t index) { return sets_[index]; }
  void note_support(FactIndex fact) {
    if (recording_) support_.push_back({facts_.atom(fact), facts_.producer(fact)});
  }
  void note_absence(const Goal& goal, Base base);
  Move fail(const Goal& goal, const std::string& why);
  bool sort(const Condition& condition, Base base, Answers& answers);
  bool before(const Condition& condition, Term left, Term right);
  static bool connective(std::string_view name);

  CompiledDomain& domain_;
  TermStore& store_;
  Bindings& bindings_;
  FactBase& facts_;
  Budget& budget_;
  std::vector<Continuation> continuations_;
  std::vector<Frame> frames_;
  std::vector<Query> queries_;
  std::deque<Answers> sets_;
  std::uint32_t sets_open_ = 0;
  std::uint32_t current_ = 0;
  std::uint32_t once_frames_ = 0;
  static constexpr int kDeepestValue = 200;
  static constexpr std::uint32_t kFewEnough = 2;   ///< matching facts: no better goal is looked for
  static constexpr std::uint32_t kMostPicked = 8;  ///< goals among which one is picked
  int value_nesting_ = 0;
  bool recording_ = false;
  std::vector<CausalLink> support_;
  RowSet seen_;
  std::map<std::pair<ConditionIndex, std::size_t>, ConditionIndex> parts_;  ///< of solve_part
};

/// "file:line:column" of an expression.
std::string place_text(Expression where);

}  // namespace skein::htn
