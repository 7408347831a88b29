// SPDX-License-Identifier: Apache-2.0
// The state: order of facts, undo, equals, indexes, origins; protections.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <span>
#include <vector>

#include "proof/fact_base.hpp"
#include "search/protections.hpp"
#include "testing/planner_lab.hpp"

namespace skein::htn {
namespace {

/// A state in which facts are text.
class World : public test::Lab {
 public:
  FactBase facts{store};

  void add(const std::string& atom, StepIndex step = kInitialState) { facts.add(term(atom), step); }
  void remove(const std::string& atom, StepIndex step = 0) { facts.remove(term(atom), step); }
  bool holds(const std::string& atom) { return facts.holds(term(atom)); }
  StepIndex producer(const std::string& atom) { return facts.producer(facts.find(term(atom))); }

  std::string all(const std::string& predicate) {
    return listed(facts.all(store.symbol(predicate)));
  }
  /// The list a goal takes whose slots are unknown.
  std::string candidates(const std::string& predicate,
                         const std::vector<IndexedPosition>& positions) {
    const auto known = [](const IndexedPosition& position) -> std::optional<Term> {
      if (position.pattern.is(TermKind::kSlot)) return std::nullopt;
      return position.pattern;
    };
    return listed(facts.candidates(store.symbol(predicate), positions, known).first);
  }

 private:
  std::string listed(FactBase::Cursor at) {
    std::string out;
    for (; at.fact != kNoFact; at = facts.next(at)) {
      out += (out.empty() ? "" : " ") + store.to_text(facts.atom(at.fact));
    }
    return out;
  }
};

TEST(FactBase, ListsTheFactsOfAPredicateNewestFirst) {
  World world;
  world.add("(p a)");
  world.add("(q x)");
  world.add("(p b)");
  world.add("(p c)");

  EXPECT_EQ(world.all("p"), "(p c) (p b) (p a)");
  EXPECT_EQ(world.all("q"), "(q x)");
  EXPECT_EQ(world.all("unheard-of"), "");
}

TEST(FactBase, KeepsThePlaceOfAFactThatIsAddedAgain) {
  World world;
  world.add("(p a)");
  world.add("(p b)");
  world.add("(p a)");

  EXPECT_EQ(world.all("p"), "(p b) (p a)");
}

TEST(FactBase, MovesAFactToTheFrontThatIsDeletedAndAdded) {
  World world;
  world.add("(p a)");
  world.add("(p b)");
  world.remove("(p a)");
  world.add("(p a)");

  EXPECT_EQ(world.all("p"), "(p a) (p b)");
}

TEST(FactBase, BringsAnUndoneDeletionBackAtTheFront) {
  World world;
  for (const char* atom : {"(p a)", "(p b)", "(p c)"}) world.add(atom);
  const FactBase::Mark mark = world.facts.mark();
  world.remove("(p a)");

  world.facts.undo(mark);

  EXPECT_EQ(world.all("p"), "(p a) (p c) (p b)");
}

TEST(FactBase, FindsAFactByItsArgumentsAsTheyAreSpeltNow) {
  World world;
  const auto found = [&](const std::string& atom) {
    const std::vector<Term> items = world.store.items(world.term(atom));
    const FactIndex fact = world.facts.find(items[0], std::span(items).subspan(1));
    EXPECT_EQ(fact, world.facts.find(world.term(atom))) << atom;
    return fact != kNoFact;
  };
  world.add("(fuel u 1.0)");
  EXPECT_TRUE(found("(fuel u 1.0)"));
  EXPECT_FALSE(found("(fuel u 1)"));
  const FactBase::Mark mark = world.facts.mark();
  world.remove("(fuel u 1.0)");
  EXPECT_FALSE(found("(fuel u 1.0)"));
  world.add("(fuel u 1)");

  EXPECT_TRUE(found("(fuel u 1)"));
  EXPECT_FALSE(found("(fuel u 1.0)"));
  for (int at = 0; at < 1'000; ++at) world.add("(fuel v " + std::to_string(at) + ")");
  world.facts.undo(mark);
  EXPECT_TRUE(found("(fuel u 1.0)"));
  EXPECT_FALSE(found("(fuel u 1)"));
  EXPECT_FALSE(found("(fuel v 7)"));
  EXPECT_FALSE(found("(fuel)"));
  EXPECT_FALSE(found("(never u)"));
}

TEST(FactBase, ForgetsAnUndoneAddition) {
  World world;
  world.add("(p a)");
  const FactBase::Mark mark = world.facts.mark();
  world.add("(p b)");
  world.add("(r)");

  world.facts.undo(mark);

  EXPECT_EQ(world.all("p"), "(p a)");
  EXPECT_FALSE(world.holds("(r)"));
}

TEST(FactBase, DoesNotUndoWhatItForgot) {
  World world;
  world.add("(p a)");
  world.facts.forget_trail();
  world.add("(p b)");

  world.facts.undo(0);

  EXPECT_EQ(world.all("p"), "(p a)");
}

TEST(FactBase, AddsNothingThatIsEqualpToAFactInForce) {
  World world;
  world.add("(cost 1)");
  world.add("(cost 1.0)");
  world.add("(name \"Karma\")");
  world.add("(name \"KARMA\")");

  EXPECT_EQ(world.all("cost"), "(cost 1)");
  EXPECT_EQ(world.all("name"), "(name \"Karma\")");
  EXPECT_FALSE(world.holds("(cost 1.0)"));
}

TEST(FactBase, DeletesNothingThatIsOnlyEqualp) {
  World world;
  world.add("(cost 1)");

  world.remove("(cost 1.0)");

  EXPECT_TRUE(world.holds("(cost 1)"));
}

TEST(FactBase, TakesTheNewSpellingOfAFactThatWasDeleted) {
  World world;
  world.add("(cost 1)");
  world.remove("(cost 1)");
  world.add("(cost 1.0)");

  EXPECT_EQ(world.all("cost"), "(cost 1.0)");
  EXPECT_EQ(world.store.to_text(
                world.facts.arguments(world.facts.all(world.store.symbol("cost")).fact)[0]),
            "1.0");
}

TEST(FactBase, BringsTheOldSpellingBackWhenItsReplacementIsUndone) {
  World world;
  world.add("(cost karma 1)");
  const FactBase::Mark mark = world.facts.mark();
  world.remove("(cost karma 1)");
  world.add("(cost karma 1.0)");

  world.facts.undo(mark);

  EXPECT_EQ(world.all("cost"), "(cost karma 1)");
  ASSERT_TRUE(world.holds("(cost karma 1)"));
  EXPECT_EQ(world.facts.arguments(world.facts.find(world.term("(cost karma 1)")))[1],
            world.store.integer(1));
}

TEST(FactBase, IgnoresTheDeletionOfWhatDoesNotHold) {
  World world;
  world.add("(p a)");
  const FactBase::Mark mark = world.facts.mark();

  world.remove("(p b)");
  world.remove("(unheard of)");

  EXPECT_EQ(world.facts.mark(), mark);
  EXPECT_EQ(world.all("p"), "(p a)");
}

TEST(FactBase, GivesTheArgumentsOfAFact) {
  World world;
  world.add("(at karma (p 1) 2.5)");
  world.add("(dawn)");

  const auto arguments =
      world.facts.arguments(world.facts.find(world.term("(at karma (p 1) 2.5)")));

  ASSERT_EQ(arguments.size(), 3U);
  EXPECT_EQ(world.store.to_text(arguments[1]), "(p 1)");
  EXPECT_TRUE(world.facts.arguments(world.facts.find(world.term("(dawn)"))).empty());
}

TEST(FactBase, KnowsTheStepThatProducedAFact) {
  World world;
  world.add("(p a)");
  world.add("(p b)", 4);
  const FactBase::Mark mark = world.facts.mark();

  EXPECT_EQ(world.producer("(p a)"), kInitialState);
  EXPECT_EQ(world.producer("(p b)"), 4U);
  world.add("(p b)", 7);
  EXPECT_EQ(world.producer("(p b)"), 7U);
  world.facts.undo(mark);
  EXPECT_EQ(world.producer("(p b)"), 4U);
}

TEST(FactBase, KnowsTheLastDeleterWhileItRecords) {
  World world;
  world.facts.record_deleters();
  world.add("(p a)");
  world.remove("(p a)", 3);
  const FactBase::Mark mark = world.facts.mark();
  world.add("(p a)", 4);
  world.remove("(p a)", 5);

  EXPECT_EQ(world.facts.deleter(world.term("(p a)")), 5U);
  world.facts.undo(mark);
  EXPECT_EQ(world.facts.deleter(world.term("(p a)")), 3U);
  EXPECT_EQ(world.facts.deleter(world.term("(p other)")), kInitialState);
}

TEST(FactBase, ListsAllAtomsInForce) {
  World world;
  world.add("(p a)");
  world.add("(q)");
  world.remove("(p a)");

  EXPECT_EQ(world.facts.atoms(), (std::vector<Term>{world.term("(q)")}));
}

// ---- indexes ---------------------------------------------------------------------------------

World& with_ten_uavs(World& world) {
  for (int at = 0; at < 10; ++at) {
    const std::string uav = "u" + std::to_string(at);
    world.add("(at " + uav + " p" + std::to_string(at % 3) + ")");
    world.add("(goal (photo " + uav + " z" + std::to_string(at % 4) + "))");
  }
  return world;
}

TEST(FactBaseIndex, OfAnyArgumentHoldsTheFactsWithThatValueNewestFirst) {
  World world;
  with_ten_uavs(world);

  EXPECT_EQ(world.candidates("at", {{{1, Path::kWhole}, world.term("p1")}}),
            "(at u7 p1) (at u4 p1) (at u1 p1)");
  EXPECT_EQ(world.candidates("at", {{{0, Path::kWhole}, world.term("u5")}}), "(at u5 p2)");
}

TEST(FactBaseIndex, OfTheItemsOfListArgumentsHoldsTheFactsWithThatItem) {
  World world;
  with_ten_uavs(world);

  EXPECT_EQ(world.candidates("goal", {{{0, 2}, world.term("z3")}}),
            "(goal (photo u7 z3)) (goal (photo u3 z3))");
  EXPECT_EQ(world.candidates("goal", {{{0, 1}, world.term("u6")}}), "(goal (photo u6 z2))");
}

TEST(FactBaseIndex, IsTheShortestOfThoseThatAreKnown) {
  World world;
  with_ten_uavs(world);

  EXPECT_EQ(world.candidates("at", {{{0, Path::kWhole}, Term(TermKind::kSlot, 0)},
                                    {{1, Path::kWhole}, world.term("p0")}}),
            "(at u9 p0) (at u6 p0) (at u3 p0) (at u0 p0)");
}

TEST(FactBaseIndex, IsEmptyForAValueThatNoFactHas) {
  World world;
  with_ten_uavs(world);

  EXPECT_EQ(world.candidates("at", {{{1, Path::kWhole}, world.term("nowhere")}}), "");
  EXPECT_EQ(world.candidates("goal", {{{0, 3}, world.term("z3")}}), "");
}

TEST(FactBaseIndex, FollowsAdditionsDeletionsAndUndoing) {
  World world;
  with_ten_uavs(world);
  const std::vector<IndexedPosition> at_p1{{{1, Path::kWhole}, world.term("p1")}};
  world.candidates("at", at_p1);
  const FactBase::Mark mark = world.facts.mark();

  world.remove("(at u4 p1)");
  world.add("(at new p1)");
  EXPECT_EQ(world.candidates("at", at_p1), "(at new p1) (at u7 p1) (at u1 p1)");
  world.facts.undo(mark);

  EXPECT_EQ(world.candidates("at", at_p1), "(at u4 p1) (at u7 p1) (at u1 p1)");
}

// ---- against a plain list --------------------------------------------------------------------

/// A state as a list with the newest first, and what undoing does to it.
class ListModel {
 public:
  explicit ListModel(TermStore& store) : store_(store) {}
  void add(Term atom) {
    for (const Term fact : facts) {
      if (store_.loose(fact) == store_.loose(atom)) return;
    }
    facts.insert(facts.begin(), atom);
    changes_.push_back({true, atom});
  }
  void remove(Term atom) {
    if (std::erase(facts, atom) > 0) changes_.push_back({false, atom});
  }
  std::size_t mark() const { return changes_.size(); }
  void undo(std::size_t mark) {
    for (; changes_.size() > mark; changes_.pop_back()) {
      if (changes_.back().added) {
        std::erase(facts, changes_.back().atom);
      } else {
        facts.insert(facts.begin(), changes_.back().atom);
      }
    }
  }
  std::vector<Term> facts;

 private:
  struct Change {
    bool added;
    Term atom;
  };
  TermStore& store_;
  std::vector<Change> changes_;
};

Term atom_of(World& world, std::uint8_t byte) {
  static const std::vector<std::string> kItems{"a", "b", "1", "1.0", "\"x\"", "\"X\""};
  const std::string& item = kItems[byte % kItems.size()];
  const std::string other = byte & 64U ? "c" : "d";
  return world.term(byte & 128U ? "(p (" + other + " " + item + ") " + other + ")"
                                : "(p " + item + " " + other + ")");
}

std::vector<Term> drained(const FactBase& facts, FactBase::Cursor at) {
  std::vector<Term> out;
  for (; at.fact != kNoFact; at = facts.next(at)) out.push_back(facts.atom(at.fact));
  return out;
}

// The facts of the scan whose argument 0, or second item of it, is the value.
std::vector<Term> scanned(const TermStore& store, const std::vector<Term>& facts, Term value,
                          bool inner) {
  std::vector<Term> out;
  for (const Term fact : facts) {
    Term argument = store.items(fact)[1];
    if (inner && !argument.is(TermKind::kPair)) continue;
    if (inner) argument = store.items(argument)[1];
    if (argument == value) out.push_back(fact);
  }
  return out;
}

std::vector<Term> indexed(World& world, const std::vector<IndexedPosition>& positions) {
  const auto known = [](const IndexedPosition& position) {
    return std::optional<Term>(position.pattern);
  };
  return drained(world.facts,
                 world.facts.candidates(world.store.symbol("p"), positions, known).first);
}

RC_GTEST_PROP(FactBaseProperty, AgreesWithAPlainListUnderAnyChangesAndUndoing,
              (const std::vector<std::pair<std::uint8_t, std::uint8_t>>& changes)) {
  World world;
  ListModel model(world.store);
  std::vector<std::pair<FactBase::Mark, std::size_t>> marks;
  for (const auto& [change, what] : changes) {
    if (change % 8 < 4) {
      world.facts.add(atom_of(world, what), what);
      model.add(atom_of(world, what));
    } else if (change % 8 < 6) {
      world.facts.remove(atom_of(world, what), what);
      model.remove(atom_of(world, what));
    } else if (change % 8 == 6) {
      marks.emplace_back(world.facts.mark(), model.mark());
    } else if (!marks.empty()) {
      world.facts.undo(marks.back().first);
      model.undo(marks.back().second);
      marks.pop_back();
    }
    RC_ASSERT(drained(world.facts, world.facts.all(world.store.symbol("p"))) == model.facts);
  }
  for (const char* text : {"a", "1", "1.0", "\"X\""}) {
    const Term value = world.term(text);
    const auto whole = indexed(world, {{{0, Path::kWhole}, value}});
    const auto inner = indexed(world, {{{0, 1}, value}});
    const bool all = model.facts.size() <= 6;  // short lists are not worth an index
    RC_ASSERT(whole == (all ? model.facts : scanned(world.store, model.facts, value, false)));
    RC_ASSERT(inner == (all ? model.facts : scanned(world.store, model.facts, value, true)));
  }
}

RC_GTEST_PROP(FactBaseProperty, HoldsExactlyWhatItLists, (const std::vector<std::uint8_t>& added)) {
  World world;
  for (const std::uint8_t byte : added) world.facts.add(atom_of(world, byte), 0);

  for (int byte = 0; byte < 256; ++byte) {
    const Term atom = atom_of(world, static_cast<std::uint8_t>(byte));
    const std::vector<Term> all = world.facts.atoms();
    RC_ASSERT(world.facts.holds(atom) == (std::find(all.begin(), all.end(), atom) != all.end()));
  }
}

// ---- protections -----------------------------------------------------------------------------

TEST(Protections, AreCounted) {
  World world;
  Protections protections;
  const Term atom = world.term("(at karma p1)");

  protections.add(atom);
  protections.add(atom);
  protections.release(atom);

  EXPECT_EQ(protections.count(atom), 1U);
  protections.release(atom);
  EXPECT_TRUE(protections.empty());
  protections.release(atom);
  EXPECT_EQ(protections.count(atom), 0U);
}

TEST(Protections, AreRestoredByUndo) {
  World world;
  Protections protections;
  const Term first = world.term("(p a)");
  const Term second = world.term("(p b)");
  protections.add(first);
  const Protections::Mark mark = protections.mark();

  protections.release(first);
  protections.add(second);
  protections.add(second);
  protections.undo(mark);

  EXPECT_EQ(protections.count(first), 1U);
  EXPECT_EQ(protections.count(second), 0U);
}

TEST(Protections, KeepWhatTheyForgetToUndo) {
  World world;
  Protections protections;
  const Term atom = world.term("(p a)");
  protections.add(atom);
  protections.forget_trail();

  protections.undo(protections.mark());

  std::vector<Term> all;
  protections.for_each([&](Term one) { all.push_back(one); });
  EXPECT_EQ(all, (std::vector<Term>{atom}));
}

}  // namespace
}  // namespace skein::htn
