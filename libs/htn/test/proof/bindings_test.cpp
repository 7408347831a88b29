// SPDX-License-Identifier: Apache-2.0
// Variables: unification, undo, closing of activations, instances.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <map>
#include <optional>

#include "testing/planner_lab.hpp"

namespace skein::htn {
namespace {

using test::Lab;
using Known = Bindings::Known;

TEST(Bindings, UnifyEqualTermsWithoutBindingAnything) {
  Lab lab;
  const Bindings::Mark before = lab.bindings.mark();

  EXPECT_TRUE(lab.unify("(at (truck 1) \"x\")", "(at (truck 1) \"x\")"));
  EXPECT_EQ(lab.bindings.mark().trail, before.trail);
}

TEST(Bindings, DoNotUnifyDifferentGroundTerms) {
  for (const auto& [left, right] :
       std::vector<std::pair<std::string, std::string>>{{"a", "b"},
                                                        {"(a)", "a"},
                                                        {"(a b)", "(a c)"},
                                                        {"(a b)", "(a . b)"},
                                                        {"1", "1.0"},
                                                        {"\"A\"", "\"a\""},
                                                        {"nil", "(nil)"}}) {
    Lab lab;

    EXPECT_FALSE(lab.unify(left, right)) << left << " and " << right;
  }
}

TEST(Bindings, GiveTheVariablesOfBothSidesTheirValues) {
  Lab lab;

  ASSERT_TRUE(lab.unify("(move ?what (from ?place) b)", "(move karma (from a) ?to)"));
  EXPECT_EQ(lab.known("(?what ?place ?to)"), "(karma a b)");
}

TEST(Bindings, FollowChainsOfVariables) {
  Lab lab;

  ASSERT_TRUE(lab.unify("(?a ?b ?c)", "(?b ?c ?d)"));
  ASSERT_TRUE(lab.unify("?d", "(f x)"));
  EXPECT_EQ(lab.known("(?a ?b ?c ?d)"), "((f x) (f x) (f x) (f x))");
}

TEST(Bindings, RefuseAVariableThatMeetsTwoValues) {
  Lab lab;

  EXPECT_FALSE(lab.unify("(?x ?x)", "(a b)"));
}

TEST(Bindings, RefuseATermInsideItself) {
  EXPECT_FALSE(Lab().unify("?x", "(f ?x)"));
  EXPECT_FALSE(Lab().unify("(?x ?y)", "((f ?y) (g ?x))"));
  EXPECT_FALSE(Lab().unify("(?x ?y ?x)", "(?y ?x (?y))"));
  EXPECT_TRUE(Lab().unify("(?x ?y)", "(?y ?x)"));
  EXPECT_TRUE(Lab().unify("?x", "?x"));
}

TEST(Bindings, TakeListsApartAtTheDot) {
  Lab lab;

  ASSERT_TRUE(lab.unify("(?first . ?rest)", "(a b c)"));
  EXPECT_EQ(lab.known("(?first ?rest)"), "(a (b c))");
  ASSERT_TRUE(lab.unify("(?one . ?none)", "(a)"));
  EXPECT_EQ(lab.known("?none"), "nil");
  EXPECT_FALSE(lab.unify("(?some . ?more)", "nil"));
  ASSERT_TRUE(lab.unify("(x . ?tail)", "(x . y)"));
  EXPECT_EQ(lab.known("?tail"), "y");
}

TEST(Bindings, ReadSlotsUnderTheBaseOfTheirActivation) {
  Lab lab;
  const Term pattern = lab.pattern("(at ?x ?y)", {"?x", "?y"});
  const Base first = lab.bindings.open(2);
  const Base second = lab.bindings.open(2);

  ASSERT_TRUE(lab.bindings.unify(pattern, first, lab.term("(at karma p1)"), 0));
  ASSERT_TRUE(lab.bindings.unify(pattern, second, lab.term("(at marvin p2)"), 0));

  EXPECT_EQ(lab.shown(lab.bindings.instance(pattern, first)), "(at karma p1)");
  EXPECT_EQ(lab.shown(lab.bindings.instance(pattern, second)), "(at marvin p2)");
}

TEST(Bindings, UnifyOnePatternWithItselfUnderTwoBases) {
  Lab lab;
  const Term pattern = lab.pattern("(p ?x (f ?y))", {"?x", "?y"});
  const Base first = lab.bindings.open(2);
  const Base second = lab.bindings.open(2);
  ASSERT_TRUE(lab.bindings.unify(pattern, first, lab.term("(p a ?z)"), 0));

  ASSERT_TRUE(lab.bindings.unify(pattern, first, pattern, second));
  ASSERT_TRUE(lab.bindings.unify(lab.pattern("?y", {"?x", "?y"}), second, lab.term("b"), 0));

  EXPECT_EQ(lab.shown(lab.bindings.instance(pattern, first)), "(p a (f b))");
  EXPECT_EQ(lab.shown(lab.bindings.instance(pattern, second)), "(p a (f b))");
}

TEST(Bindings, UndoWhatWasBoundAndOpenedSinceTheMark) {
  Lab lab;
  lab.term("(?x ?y)");
  ASSERT_TRUE(lab.unify("?x", "a"));
  const Bindings::Mark mark = lab.bindings.mark();
  const Base opened = lab.bindings.open(3);
  ASSERT_TRUE(lab.unify("?y", "b"));

  lab.bindings.undo(mark);

  EXPECT_EQ(lab.known("(?x ?y)"), "(a ?y)");
  EXPECT_EQ(lab.bindings.mark().trail, mark.trail);
  EXPECT_EQ(lab.bindings.open(1), opened);
}

TEST(Bindings, LeaveTheUndoingOfAFailedUnificationToTheCaller) {
  Lab lab;
  lab.term("(?x ?y)");
  const Bindings::Mark mark = lab.bindings.mark();

  ASSERT_FALSE(lab.unify("(?x ?y b)", "(a a c)"));
  lab.bindings.undo(mark);

  EXPECT_EQ(lab.known("(?x ?y)"), "(?x ?y)");
}

TEST(Bindings, KeepForGoodWhatTheyForgetToUndo) {
  Lab lab;
  lab.term("(?x ?y)");
  ASSERT_TRUE(lab.unify("?x", "a"));

  lab.bindings.forget_trail();
  const Bindings::Mark mark = lab.bindings.mark();
  ASSERT_TRUE(lab.unify("?y", "b"));
  lab.bindings.undo(mark);

  EXPECT_EQ(lab.known("(?x ?y)"), "(a ?y)");
}

TEST(Bindings, CloseAnActivationWithTheValuesItGaveToOlderVariables) {
  Lab lab;
  const Term outer = lab.term("?outer");
  const Bindings::Mark mark = lab.bindings.mark();
  const Base clause = lab.bindings.open(2);
  const Term head = lab.pattern("(route ?from ?to)", {"?from", "?to"});
  ASSERT_TRUE(lab.bindings.unify(outer, 0, head, clause));
  ASSERT_TRUE(lab.bindings.unify(head, clause, lab.term("(route a b)"), 0));

  lab.bindings.close(mark);

  EXPECT_EQ(lab.known("?outer"), "(route a b)");
  EXPECT_EQ(lab.bindings.mark().cells, mark.cells);
}

TEST(Bindings, KeepOpenTheClosedCellsThatOlderValuesStillMention) {
  Lab lab;
  const Term outer = lab.term("?outer");
  const Bindings::Mark mark = lab.bindings.mark();
  const Base clause = lab.bindings.open(3);
  const std::vector<std::string> names{"?x", "?y", "?z"};
  ASSERT_TRUE(lab.bindings.unify(outer, 0, lab.pattern("(pair ?y ?y)", names), clause));

  lab.bindings.close(mark);

  EXPECT_EQ(lab.bindings.mark().cells, clause + 2);
  ASSERT_TRUE(lab.bindings.unify(outer, 0, lab.term("(pair a ?other)"), 0));
  EXPECT_EQ(lab.known("(?outer ?other)"), "((pair a a) a)");
}

TEST(Bindings, UndoAClosedActivationAsAWhole) {
  Lab lab;
  const Term outer = lab.term("?outer");
  const Bindings::Mark before = lab.bindings.mark();
  const Base clause = lab.bindings.open(1);
  ASSERT_TRUE(lab.bindings.unify(outer, 0, lab.pattern("(f ?x)", {"?x"}), clause));
  lab.bindings.close(before);

  lab.bindings.undo(before);

  EXPECT_EQ(lab.known("?outer"), "?outer");
  EXPECT_EQ(lab.bindings.mark().cells, before.cells);
}

TEST(Bindings, BindTheYoungerOfTwoVariables) {
  Lab lab;
  const Term older = lab.term("?older");
  const Bindings::Mark mark = lab.bindings.mark();
  const Base younger = lab.bindings.open(1);
  const Term slot(TermKind::kSlot, 0);

  ASSERT_TRUE(lab.bindings.unify(older, 0, slot, younger));

  EXPECT_EQ(lab.bindings.resolve(slot, younger), older);
  EXPECT_EQ(lab.bindings.resolve(older, 0), older);
  lab.bindings.close(mark);
  EXPECT_EQ(lab.known("?older"), "?older");
}

TEST(Bindings, ResolveTheOutsideOfATermOnly) {
  Lab lab;
  ASSERT_TRUE(lab.unify("(?x ?y)", "((f ?y) b)"));
  const Term x = lab.term("?x");

  const Term resolved = lab.bindings.resolve(x, 0);

  EXPECT_EQ(lab.shown(lab.bindings.instance(resolved, 0)), "(f b)");
  EXPECT_TRUE(resolved.is(TermKind::kPair));
}

TEST(BindingsLookUp, FindsAnInstanceThatWasEverMade) {
  Lab lab;
  const Term fact = lab.term("(at karma (p 1))");
  ASSERT_TRUE(lab.unify("(?u ?n)", "(karma 1)"));
  Term out;

  EXPECT_EQ(lab.bindings.look_up(lab.term("(at ?u (p ?n))"), 0, out), Known::kTerm);
  EXPECT_EQ(out, fact);
}

TEST(BindingsLookUp, SaysThatNoSuchTermWasEverMadeWithoutMakingIt) {
  Lab lab;
  ASSERT_TRUE(lab.unify("?u", "karma"));
  const Term question = lab.term("(near ?u)");
  const std::size_t before = lab.store.pair_count();
  Term out;

  EXPECT_EQ(lab.bindings.look_up(question, 0, out), Known::kNever);
  EXPECT_EQ(lab.store.pair_count(), before);
}

TEST(BindingsLookUp, LeavesOpenWhatHasUnboundVariables) {
  Lab lab;
  ASSERT_TRUE(lab.unify("?u", "karma"));
  Term out;

  EXPECT_EQ(lab.bindings.look_up(lab.term("(at ?u ?where)"), 0, out), Known::kOpen);
  EXPECT_EQ(lab.bindings.look_up(lab.term("(at ?u . ?rest)"), 0, out), Known::kOpen);
  EXPECT_EQ(lab.bindings.look_up(lab.term("?where"), 0, out), Known::kOpen);
}

TEST(BindingsLookUp, MakesLongAndDeepTermsAllTheSame) {
  Lab lab;
  ASSERT_TRUE(lab.unify("?u", "karma"));
  const Term u = lab.term("?u");
  const std::vector<Term> many(100, u);
  const Term deep = lab.nested(100'000, lab.term("karma"));
  Term out;

  EXPECT_EQ(lab.bindings.look_up(lab.store.list(many), 0, out), Known::kTerm);
  EXPECT_EQ(out, lab.store.list(std::vector<Term>(100, lab.term("karma"))));
  EXPECT_EQ(lab.bindings.look_up(lab.nested(100'000, u), 0, out), Known::kTerm);
  EXPECT_EQ(out, deep);
}

TEST(BindingsInstance, IsTheTermItselfWhereNothingIsToReplace) {
  Lab lab;
  const Term ground = lab.term("(a (b c) . d)");

  EXPECT_EQ(lab.bindings.instance(ground, 0), ground);
}

TEST(BindingsInstance, NeverRecursOnDeepTermsNorUnifiesThemByRecursion) {
  constexpr std::size_t kDeep = 100'000;
  Lab lab;
  const Term left = lab.nested(kDeep, lab.term("?x"));
  const Term right = lab.nested(kDeep, lab.term("core"));

  EXPECT_EQ(lab.bindings.instance(left, 0), left);
  ASSERT_TRUE(lab.bindings.unify(left, 0, right, 0));

  EXPECT_EQ(lab.bindings.instance(left, 0), right);
  EXPECT_FALSE(lab.bindings.unify(lab.term("?y"), 0, lab.nested(kDeep, lab.term("?y")), 0));
}

TEST(BindingsInstance, ReplacesInsideLongListsAndDottedTails) {
  Lab lab;
  ASSERT_TRUE(lab.unify("(?x ?t)", "((1 2) (8 9))"));

  EXPECT_EQ(lab.known("(a ?x b . ?t)"), "(a (1 2) b 8 9)");
  EXPECT_EQ(lab.known("((?x . ?u) ?t)"), "(((1 2) . ?u) (8 9))");
}

TEST(Bindings, CollectEachUnboundVariableOnceInTheOrderOfTheText) {
  Lab lab;
  ASSERT_TRUE(lab.unify("?b", "(f ?c)"));
  std::vector<Term> unbound;

  lab.bindings.collect_unbound(lab.term("(?a ?b (?a ?d) . ?c)"), 0, unbound);

  EXPECT_EQ(unbound, (std::vector<Term>{lab.term("?a"), lab.term("?c"), lab.term("?d")}));
}

// ---- against a unifier on substitutions that are copied
// ------------------------------------------

using Substitution = std::map<std::uint32_t, Term>;

Term walk(const Substitution& values, Term term) {
  while (term.is(TermKind::kVariable) && values.contains(term.index())) {
    term = values.at(term.index());
  }
  return term;
}

bool mentions(const TermStore& store, const Substitution& values, Term term, Term variable) {
  term = walk(values, term);
  if (!term.is(TermKind::kPair)) return term == variable;
  return mentions(store, values, store.car(term), variable) ||
         mentions(store, values, store.cdr(term), variable);
}

std::optional<Substitution> naive_unify(const TermStore& store, Substitution values, Term left,
                                        Term right) {
  left = walk(values, left);
  right = walk(values, right);
  if (left == right) return values;
  if (!left.is(TermKind::kVariable)) std::swap(left, right);
  if (left.is(TermKind::kVariable)) {
    if (mentions(store, values, right, left)) return std::nullopt;
    values[left.index()] = right;
    return values;
  }
  if (!left.is(TermKind::kPair) || !right.is(TermKind::kPair)) return std::nullopt;
  const auto heads = naive_unify(store, values, store.car(left), store.car(right));
  if (!heads) return std::nullopt;
  return naive_unify(store, *heads, store.cdr(left), store.cdr(right));
}

Term naive_instance(TermStore& store, const Substitution& values, Term term) {
  term = walk(values, term);
  if (!term.is(TermKind::kPair)) return term;
  const Term car = naive_instance(store, values, store.car(term));
  return store.pair(car, naive_instance(store, values, store.cdr(term)));
}

// Terms from bytes: each says what comes next.
class TermMaker {
 public:
  TermMaker(TermStore& store, const std::vector<std::uint8_t>& bytes)
      : store_(store), bytes_(bytes) {}
  Term make(int depth) {
    const std::uint8_t byte = next();
    if (depth > 0 && byte % 2 == 0) {
      const Term car = make(depth - 1);
      return store_.pair(car, make(depth - 1));
    }
    const std::uint32_t which = byte / 8U;
    if (byte % 8 < 5) return {TermKind::kVariable, which % kVariables};
    return which % 4 == 0 ? kNil : store_.integer(which % 3);
  }
  static constexpr std::uint32_t kVariables = 5;

 private:
  std::uint8_t next() { return at_ < bytes_.size() ? bytes_[at_++] : std::uint8_t{255}; }
  TermStore& store_;
  const std::vector<std::uint8_t>& bytes_;
  std::size_t at_ = 0;
};

// Variables of an instance named in the order they come up: equal for variants.
Term renamed(TermStore& store, Term term) {
  std::map<std::uint32_t, std::uint32_t> names;
  return map_leaves(store, term, kHasVariable, [&](Term variable) {
    const auto fresh = static_cast<std::uint32_t>(names.size());
    return Term(TermKind::kLocal, names.emplace(variable.index(), fresh).first->second);
  });
}

RC_GTEST_PROP(BindingsProperty, UnifyAsANaiveUnifierDoes, (std::vector<std::uint8_t> bytes)) {
  TermStore store;
  Bindings bindings(store);
  bindings.open(TermMaker::kVariables);
  TermMaker maker(store, bytes);
  const Term left = maker.make(5);
  const Term right = maker.make(5);

  const std::optional<Substitution> expected = naive_unify(store, {}, left, right);
  const bool unified = bindings.unify(left, 0, right, 0);

  RC_ASSERT(unified == expected.has_value());
  if (!unified) return;
  RC_ASSERT(bindings.instance(left, 0) == bindings.instance(right, 0));
  std::vector<Term> all;
  for (std::uint32_t at = 0; at < TermMaker::kVariables; ++at) {
    all.emplace_back(TermKind::kVariable, at);
  }
  const Term whole = store.list(all);
  RC_ASSERT(renamed(store, bindings.instance(whole, 0)) ==
            renamed(store, naive_instance(store, *expected, whole)));
}

RC_GTEST_PROP(BindingsProperty, AreAsBeforeAfterUndo, (std::vector<std::uint8_t> bytes)) {
  TermStore store;
  Bindings bindings(store);
  bindings.open(TermMaker::kVariables);
  TermMaker maker(store, bytes);
  const Term first = maker.make(3);
  const Term both = store.pair(first, maker.make(3));
  bindings.unify(first, 0, maker.make(3), 0);
  const Term before = bindings.instance(both, 0);
  const Bindings::Mark mark = bindings.mark();

  for (int round = 0; round < 4; ++round) {
    bindings.open(2);
    bindings.unify(maker.make(3), 0, maker.make(3), 0);
  }
  bindings.undo(mark);

  RC_ASSERT(bindings.instance(both, 0) == before);
  RC_ASSERT(bindings.mark().cells == mark.cells);
}

RC_GTEST_PROP(BindingsProperty, LookUpAgreesWithTheInstance, (std::vector<std::uint8_t> bytes)) {
  TermStore store;
  Bindings bindings(store);
  bindings.open(TermMaker::kVariables);
  TermMaker maker(store, bytes);
  bindings.unify(maker.make(3), 0, maker.make(3), 0);
  const Term question = maker.make(4);
  Term found;
  const Known known = bindings.look_up(question, 0, found);
  const std::size_t pairs = store.pair_count();

  const Term instance = bindings.instance(question, 0);

  if (known == Known::kTerm) RC_ASSERT(found == instance && store.ground(instance));
  if (known == Known::kNever) RC_ASSERT(store.pair_count() > pairs || !store.ground(instance));
  if (known == Known::kOpen) RC_ASSERT(!store.ground(instance));
}

}  // namespace
}  // namespace skein::htn
