// SPDX-License-Identifier: Apache-2.0
// Terms and their store; maps over the leaves of terms.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>

#include "testing/planner_lab.hpp"

namespace skein::htn {
namespace {

constexpr std::size_t kDeep = 200'000;  // more than the stack has room for

using test::Lab;

TEST(TermStore, KeepsEveryTermOnce) {
  Lab lab;

  EXPECT_EQ(lab.term("(at truck (1 \"x\" 2.5) . tail)"),
            lab.term("(at truck (1 \"x\" 2.5) . tail)"));
  EXPECT_NE(lab.term("(a b)"), lab.term("(a b c)"));
  EXPECT_NE(lab.term("(a b)"), lab.term("(a . b)"));
  EXPECT_NE(lab.term("a"), lab.term("\"a\""));
}

TEST(TermStore, IgnoresTheCaseOfSymbolsAndKeepsThatOfStrings) {
  TermStore store;

  EXPECT_EQ(store.symbol("Truck-One-Of-Many"), store.symbol("tRUCK-oNE-oF-mANY"));
  EXPECT_EQ(store.name(store.symbol("TRUCK")), "truck");
  EXPECT_NE(store.string("Truck"), store.string("truck"));
  EXPECT_EQ(store.text(store.string("Truck")), "Truck");
}

TEST(TermStore, KnowsNilAndTFromTheStart) {
  TermStore store;

  EXPECT_EQ(store.symbol("NIL"), kNil);
  EXPECT_EQ(store.symbol("t"), kTrue);
  EXPECT_EQ(store.list({}), kNil);
  EXPECT_EQ(TermStore::boolean(true), kTrue);
  EXPECT_EQ(TermStore::boolean(false), kNil);
  EXPECT_EQ(Term{}, kNil);
}

TEST(TermStore, TellsNumbersOfDifferentKindsApart) {
  TermStore store;

  EXPECT_EQ(store.integer(1), store.integer(1));
  EXPECT_NE(store.integer(1), store.number(real(1)));
  EXPECT_NE(store.number(single(1)), store.number(real(1)));
}

TEST(TermStore, FindsPairsWithoutMakingThem) {
  TermStore store;
  const Term a = store.symbol("a");
  const std::size_t before = store.pair_count();

  EXPECT_FALSE(store.find_pair(a, kNil).has_value());
  EXPECT_EQ(store.pair_count(), before);
  const Term made = store.pair(a, kNil);
  EXPECT_EQ(store.find_pair(a, kNil), made);
}

TEST(TermStore, HoldsManyTermsOfEachKind) {
  TermStore store;
  std::vector<Term> symbols;
  std::vector<Term> numbers;
  std::vector<Term> pairs;
  constexpr std::int64_t kMany = 20'000;
  for (std::int64_t at = 0; at < kMany; ++at) {
    symbols.push_back(store.symbol("name-" + std::to_string(at)));
    numbers.push_back(store.integer(at));
    pairs.push_back(store.pair(symbols.back(), numbers.back()));
  }

  for (std::int64_t at = 0; at < kMany; ++at) {
    const auto index = static_cast<std::size_t>(at);
    ASSERT_EQ(store.symbol("NAME-" + std::to_string(at)), symbols[index]);
    ASSERT_EQ(store.integer(at), numbers[index]);
    ASSERT_EQ(store.pair(symbols[index], numbers[index]), pairs[index]);
    ASSERT_EQ(store.value(numbers[index]).numerator, at);
  }
  EXPECT_GT(store.memory_bytes(), static_cast<std::size_t>(kMany) * 8);
}

TEST(TermStore, HasOneRepresentativeForAllThatEqualp) {
  Lab lab;
  const auto loose = [&](const std::string& text) { return lab.store.loose(lab.term(text)); };

  EXPECT_EQ(loose("1"), loose("1.0"));
  EXPECT_EQ(loose("1.0"), loose("1.0d0"));
  EXPECT_EQ(loose("1/2"), loose("0.5d0"));
  EXPECT_EQ(loose("\"Karma\""), loose("\"KARMA\""));
  EXPECT_EQ(loose("(p 1 (\"A\" 2.0))"), loose("(p 1.0 (\"a\" 2))"));
  EXPECT_NE(loose("(p 1)"), loose("(p 2.0)"));
  EXPECT_NE(loose("\"a\""), loose("a"));
  EXPECT_NE(loose("1.5"), loose("1"));
}

TEST(TermStore, IsItsOwnRepresentativeWithoutFloatsRatiosAndStrings) {
  Lab lab;
  const Term plain = lab.term("(at (truck 1) (2 3))");
  const std::size_t before = lab.store.pair_count();

  EXPECT_EQ(lab.store.loose(plain), plain);
  EXPECT_EQ(lab.store.pair_count(), before);
}

TEST(TermStore, HasARepresentativeThatRepresentsItself) {
  Lab lab;
  for (const char* text : {"(1.0 \"X\")", "1/3", "((1d300 2.5) . 3.0)", "\"\""}) {
    const Term loose = lab.store.loose(lab.term(text));

    EXPECT_EQ(lab.store.loose(loose), loose) << text;
  }
}

TEST(TermStore, PrintsWhatItReads) {
  Lab lab;
  for (const char* text :
       {"nil", "a", "-12", "1/3", "\"Two words\"", R"("a \"quote\" and \\")", "(a)",
        "(a (b c) ((d)) nil)", "(a . b)", "(a b . c)", "((a . b) . (1))", "((nil))"}) {
    const Term term = lab.term(text);

    EXPECT_EQ(lab.term(lab.store.to_text(term)), term) << text;
  }
  EXPECT_EQ(lab.store.to_text(lab.term("(a . (b . (c . nil)))")), "(a b c)");
  EXPECT_EQ(lab.store.to_text(lab.term("(a . (b . c))")), "(a b . c)");
  EXPECT_EQ(lab.store.to_text(lab.term("()")), "nil");
}

TEST(TermStore, PrintsHostObjectsByTheirLabelAndKeepsTheirValue) {
  TermStore store;
  const auto value = std::make_shared<const std::any>(std::string("path"));
  const Term object = store.object(value, "route 7");

  EXPECT_EQ(store.to_text(store.pair(object, kNil)), "(#<route 7>)");
  EXPECT_EQ(std::any_cast<std::string>(store.host_value(object)), "path");
  EXPECT_NE(store.object(value, "route 7"), object);
  EXPECT_TRUE(store.ground(object));
}

TEST(TermStore, KnowsWhatOccursAnywhereInsideATerm) {
  TermStore store;
  const Term slot(TermKind::kSlot, 3);
  const Term variable(TermKind::kVariable, 3);
  const Term local(TermKind::kLocal, 3);
  const Term a = store.symbol("a");
  const auto inside = [&](Term term) {
    return store.content(store.pair(a, store.pair(store.pair(term, a), kNil)));
  };

  EXPECT_EQ(inside(a), 0);
  EXPECT_EQ(inside(slot), kHasSlot);
  EXPECT_EQ(inside(variable), kHasVariable);
  EXPECT_EQ(inside(local), kHasLocal);
  EXPECT_EQ(inside(store.integer(1)), 0);
  EXPECT_EQ(inside(store.number(real(1))), kHasLooseEqual);
  EXPECT_EQ(inside(store.string("x")), kHasLooseEqual);
  EXPECT_EQ(store.content(store.pair(slot, store.pair(variable, store.string("x")))),
            kHasSlot | kHasVariable | kHasLooseEqual);
}

TEST(TermStore, CallsGroundWhatHoldsNoVariableOfAnyKind) {
  TermStore store;

  EXPECT_TRUE(store.ground(store.pair(store.string("x"), store.integer(1))));
  for (const TermKind kind : {TermKind::kSlot, TermKind::kVariable, TermKind::kLocal}) {
    EXPECT_FALSE(store.ground(Term(kind, 0)));
    EXPECT_FALSE(store.ground(store.pair(kNil, Term(kind, 0))));
  }
}

TEST(TermStore, TellsProperListsFromDottedOnes) {
  Lab lab;

  EXPECT_TRUE(lab.store.is_list(lab.term("()")));
  EXPECT_TRUE(lab.store.is_list(lab.term("(a (b . c))")));
  EXPECT_FALSE(lab.store.is_list(lab.term("(a . b)")));
  EXPECT_FALSE(lab.store.is_list(lab.term("a")));
  EXPECT_EQ(lab.store.items(lab.term("(a b . c)")),
            (std::vector<Term>{lab.term("a"), lab.term("b")}));
}

TEST(TermStore, NeverRecursOnTermsNestedDeeperThanTheStack) {
  Lab lab;
  const Term deep = lab.nested(kDeep, lab.store.string("Core"));

  EXPECT_EQ(lab.nested(kDeep, lab.store.string("Core")), deep);
  EXPECT_EQ(lab.store.loose(deep), lab.nested(kDeep, lab.store.string("core")));
  EXPECT_EQ(lab.store.content(deep), kHasLooseEqual);
  const std::string text = lab.store.to_text(deep);
  EXPECT_EQ(text.size(), 2 * kDeep + 6);
  EXPECT_EQ(text.substr(kDeep - 1, 8), "(\"Core\")");
}

TEST(TermStore, NeverRecursOnLongLists) {
  Lab lab;
  const std::vector<Term> items(kDeep, lab.store.symbol("x"));
  const Term list = lab.store.list(items);

  EXPECT_TRUE(lab.store.is_list(list));
  EXPECT_EQ(lab.store.items(list).size(), kDeep);
  EXPECT_EQ(lab.store.to_text(list).size(), 2 * kDeep + 1);
}

TEST(MapLeaves, ReplacesOnlyTheLeavesItIsAskedFor) {
  TermStore store;
  const Term local(TermKind::kLocal, 1);
  const std::array<Term, 3> items{store.symbol("a"), local, Term(TermKind::kVariable, 1)};
  const Term term = store.list(items, local);

  const Term mapped = map_leaves(store, term, kHasLocal,
                                 [&](Term leaf) { return store.integer(leaf.index() + 1); });

  EXPECT_EQ(store.to_text(mapped), "(a 2 ?_1 . 2)");
}

TEST(MapLeaves, GivesBackUntouchedTermsWithoutAskingTheLeaf) {
  Lab lab;
  const Term term = lab.term("(a (b c))");

  const Term mapped = map_leaves(lab.store, term, kHasSlot, [](Term leaf) {
    ADD_FAILURE();
    return leaf;
  });

  EXPECT_EQ(mapped, term);
}

TEST(MapLeaves, NeverRecursOnDeepTerms) {
  Lab lab;
  const Term deep = lab.nested(kDeep, Term(TermKind::kSlot, 0));

  const Term mapped = map_leaves(lab.store, deep, kHasSlot, [](Term) { return kTrue; });

  EXPECT_EQ(mapped, lab.nested(kDeep, kTrue));
}

}  // namespace
}  // namespace skein::htn
