// SPDX-License-Identifier: Apache-2.0
// Contradictions in time against Floyd and Warshall on the network of starts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <bit>

#include "skein/auction/member_conflicts.hpp"
#include "skein/foundation/random.hpp"
#include "testing/road_team.hpp"

namespace skein::auction {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t kMembers = 3;

/// Whole seconds, so that sums are exact.
double whole(Random& random, std::uint64_t below) {
  return static_cast<double>(random.below(below));
}

Lot crowded(std::uint64_t seed) {
  Random random(seed, "contradictory windows");
  Lot lot;
  const auto count = static_cast<std::uint32_t>(2 + random.below(5));
  for (std::uint32_t n = 0; n < count; ++n) {
    RoadTask task = a_task(n)
                        .lasting(whole(random, 20))
                        .members(1 + static_cast<std::uint32_t>(random.below(kMembers)));
    if (random.chance(0.5)) task.from(whole(random, 60));
    if (random.chance(0.5)) task.by(20 + whole(random, 100));
    if (random.chance(0.4)) task.pinned(static_cast<std::uint32_t>(random.below(kMembers)));
    for (std::uint32_t m = 0; m < kMembers; ++m) {
      if (random.chance(0.15)) task.not_for(m);
    }
    lot.tasks.push_back(task);
  }
  for (std::uint32_t then = 0; then < count; ++then) {
    if (random.chance(0.6)) continue;
    const auto first = static_cast<std::uint32_t>(random.below(count));
    if (first < then || random.chance(0.1))
      lot.precedences.push_back({TaskNumber(first), TaskNumber(then)});
  }
  return lot;
}

/// Whether the tasks of these numbers can all be dated, by all shortest paths.
class Dates {
 public:
  explicit Dates(const Lot& lot) : at_most_(lot.tasks.size() + 1) {
    for (auto& row : at_most_) row.assign(at_most_.size(), kInfinity);
    for (std::size_t i = 0; i < lot.tasks.size(); ++i) {
      number_[lot.tasks[i].number] = i + 1;
      bound(i + 1, 0, -lot.tasks[i].earliest);
      bound(0, i + 1, lot.tasks[i].deadline - lot.tasks[i].duration);
    }
    for (const Precedence& one : lot.precedences) add(lot, one);
  }
  void add(const Lot& lot, const Precedence& one) {
    const std::size_t before = number_.at(one.first), after = number_.at(one.then);
    const double lasts = lot.tasks[before - 1].duration;
    bound(after, before, -lasts - one.delay.least);
    bound(before, after, lasts + one.delay.most);
    circular_ = circular_ || one.first == one.then;
  }
  /// Tasks that take no time and wait for each other are in no order, though they have a date.
  bool exist() {
    for (std::size_t via = 0; via < at_most_.size(); ++via) {
      for (std::size_t a = 0; a < at_most_.size(); ++a) {
        for (std::size_t b = 0; b < at_most_.size(); ++b)
          bound(a, b, at_most_[a][via] + at_most_[via][b]);
      }
    }
    for (std::size_t a = 0; a < at_most_.size(); ++a) circular_ = circular_ || at_most_[a][a] < 0;
    return !circular_;
  }

 private:
  void bound(std::size_t from, std::size_t to, double most) {
    at_most_[from][to] = std::min(at_most_[from][to], most);
  }
  std::vector<std::vector<double>> at_most_;
  std::map<TaskNumber, std::size_t> number_;
  bool circular_ = false;
};

bool can_be_dated(const Lot& lot) { return Dates(lot).exist(); }

bool can_be_dated(Lot lot, TaskNumber first, TaskNumber then) {
  lot.precedences.push_back({first, then});
  return can_be_dated(lot);
}

std::set<MemberNumber> everybody() {
  std::set<MemberNumber> all;
  for (std::uint32_t m = 0; m < kMembers; ++m) all.insert(MemberNumber(m));
  return all;
}

/// Who is in every crew that may do the task. Nobody, if no crew may.
std::set<MemberNumber> needed_for(const Task& task) {
  std::optional<std::uint32_t> in_all;
  for (std::uint32_t crew = 0; crew < 1U << kMembers; ++crew) {
    const auto has = [crew](MemberNumber member) { return (crew >> member.value() & 1U) != 0; };
    const bool many = std::popcount(crew) >= static_cast<int>(task.least_members);
    const bool may = std::none_of(task.forbidden.begin(), task.forbidden.end(), has);
    if (many && may && (!task.pinned || has(*task.pinned))) in_all = in_all.value_or(crew) & crew;
  }
  std::set<MemberNumber> needed;
  for (const MemberNumber one : everybody())
    if ((in_all.value_or(0) >> one.value() & 1U) != 0) needed.insert(one);
  return needed;
}

bool is_of_time(const Contradiction& one) { return one.why.find("pinned") == std::string::npos; }

RC_GTEST_PROP(ContradictoryWindows, AreNamedIfAndOnlyIfTheTasksCannotBeDated,
              (std::uint64_t seed)) {
  Lot lot = crowded(seed);
  for (Task& task : lot.tasks) task.duration += 1;  // an order of tasks without duration is no date
  const auto found = contradictions(lot);

  const bool named = std::any_of(found.begin(), found.end(), is_of_time);

  RC_ASSERT(named == !can_be_dated(lot));
}

/// Half of the precedences with bounds, in whole seconds.
Lot delayed(std::uint64_t seed) {
  Lot lot = crowded(seed);
  for (Task& task : lot.tasks) task.duration += 1;
  Random random(seed, "delays");
  for (Precedence& one : lot.precedences) {
    if (random.chance(0.3)) continue;
    one.delay.least = whole(random, 30);
    if (random.chance(0.7)) one.delay.most = one.delay.least + whole(random, 40);
  }
  return lot;
}

RC_GTEST_PROP(ContradictoryWindows, WithDelaysTooTheyAreNamedIfAndOnlyIfTheTasksCannotBeDated,
              (std::uint64_t seed)) {
  const Lot lot = delayed(seed);
  const auto found = contradictions(lot);

  RC_ASSERT(std::any_of(found.begin(), found.end(), is_of_time) == !can_be_dated(lot));
  for (const Contradiction& one : found)
    for (const TaskNumber task : one.chain)
      RC_ASSERT(one.chain.size() == 1 || one.why.find(to_text(task)) != std::string::npos ||
                one.why == "each is to end before the next begins");
}

// Found by the property: what was said of who may do it hid that it could not be dated.
TEST(ContradictoryWindows, AreNamedBesideOtherMistakes) {
  const auto found = contradictions(
      {{a_task(11).lasting(7).by(37).pinned(1).not_for(1), a_task(12).lasting(5).from(56)},
       {{TaskNumber(11), TaskNumber(12), {13, 18}}}});

  EXPECT_EQ(found.size(), 2U);
  EXPECT_TRUE(std::any_of(found.begin(), found.end(), is_of_time));
}

TEST(ContradictoryWindows, ACircleThroughAGreatestDelayIsSaidBoundByBound) {
  const auto found = contradictions({{a_task(11).lasting(20), a_task(12).lasting(30), a_task(13)},
                                     {{TaskNumber(11), TaskNumber(12), {60, 300}},
                                      {TaskNumber(12), TaskNumber(13)},
                                      {TaskNumber(11), TaskNumber(13), {0, 80}}}});

  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0].chain,
              ::testing::ElementsAre(TaskNumber(11), TaskNumber(12), TaskNumber(13)));
  EXPECT_THAT(
      found[0].why,
      ::testing::AllOf(
          ::testing::HasSubstr("12 begins 60 s or more after the end of 11, which lasts"),
          ::testing::HasSubstr("13 begins after the end of 12, which lasts 30 s"),
          ::testing::HasSubstr("13 begins within 80 s of the end of 11, which lasts 20 s")));
}

/// The chain alone: its precedences, when its first may begin, and when its last must have ended.
Lot alone(const Lot& lot, const std::vector<TaskNumber>& chain) {
  const auto task = [&](TaskNumber number) { return lot.tasks.at(number.value()); };
  Lot result;
  const std::size_t count = chain.size();
  for (std::size_t i = 0; i < count; ++i) {
    Task link = task(chain[i]);
    if (i > 0) link.earliest = -kInfinity;
    if (i + 1 < count) link.deadline = kInfinity;
    result.tasks.push_back(link);
    if (i > 0) result.precedences.push_back({chain[i - 1], chain[i]});
  }
  return result;
}

RC_GTEST_PROP(ContradictoryWindows, WhatIsNamedIsACircleOfConstraintsThatNothingCanBeLeftOutOf,
              (std::uint64_t seed)) {
  const Lot lot = crowded(seed);
  for (const Contradiction& one : contradictions(lot)) {
    if (!is_of_time(one) || one.why == "each is to end before the next begins") continue;
    const Lot named = alone(lot, one.chain);

    RC_ASSERT(!can_be_dated(named));
    for (std::size_t i = 0; i < named.precedences.size(); ++i) {
      Lot less = named;
      less.precedences.erase(less.precedences.begin() + static_cast<std::ptrdiff_t>(i));
      RC_ASSERT(can_be_dated(less));
    }
    for (const TaskNumber task : one.chain)
      RC_ASSERT(one.why.find(to_text(task)) != std::string::npos || one.chain.size() == 1);
  }
}

bool is_pair(const MemberConflict& one, TaskNumber first, TaskNumber then) {
  return one.member && one.tasks.size() == 2 &&
         std::set(one.tasks.begin(), one.tasks.end()) == std::set{first, then};
}

RC_GTEST_PROP(ContradictoryWindows, TwoThatNeedOneMemberAreNamedIfAndOnlyIfNeitherOrderCanBeDated,
              (std::uint64_t seed)) {
  const Lot lot = crowded(seed);
  const auto found = member_conflicts(lot, everybody());
  if (!can_be_dated(lot)) return;
  const auto of_time = contradictions(lot);  // a circle of tasks that last 0 s has dates
  RC_PRE(std::none_of(of_time.begin(), of_time.end(), is_of_time));

  for (const Task& one : lot.tasks) {
    for (const Task& other : lot.tasks) {
      if (!(one.number < other.number)) continue;
      const auto first = needed_for(one), second = needed_for(other);
      const bool share = std::any_of(first.begin(), first.end(),
                                     [&](auto member) { return second.contains(member); });
      const bool expected = share && !can_be_dated(lot, one.number, other.number) &&
                            !can_be_dated(lot, other.number, one.number);
      const auto named = std::count_if(found.begin(), found.end(), [&](const auto& conflict) {
        return is_pair(conflict, one.number, other.number);
      });
      RC_ASSERT(named == (expected ? 1 : 0));
    }
  }
}

/// Whether some order of these tasks can be dated together with all others.
bool some_order_can_be_dated(const Lot& lot, std::vector<TaskNumber> tasks) {
  std::sort(tasks.begin(), tasks.end());
  do {
    Lot ordered = lot;
    for (std::size_t i = 1; i < tasks.size(); ++i)
      ordered.precedences.push_back({tasks[i - 1], tasks[i]});
    if (can_be_dated(ordered)) return true;
  } while (std::next_permutation(tasks.begin(), tasks.end()));
  return false;
}

/// That last for some time, for whom they are pinned to.
Lot sound(Lot lot, std::optional<MemberNumber> pinned_to = {}) {
  for (Task& task : lot.tasks) {
    task.duration += 1;
    if (pinned_to) task.pinned = pinned_to;
    if (task.pinned) task.forbidden.erase(*task.pinned);
  }
  return lot;
}

std::vector<TaskNumber> that_need(const Lot& lot, MemberNumber member) {
  std::vector<TaskNumber> tasks;
  for (const Task& task : lot.tasks)
    if (needed_for(task).contains(member)) tasks.push_back(task.number);
  return tasks;
}

RC_GTEST_PROP(ContradictoryWindows, OfMoreThatNeedOneMemberNoOrderCanBeDatedAndNoneCanBeLeftOut,
              (std::uint64_t seed)) {
  const Lot lot = sound(crowded(seed));
  for (const MemberConflict& one : member_conflicts(lot, everybody())) {
    if (!one.member) continue;
    for (const TaskNumber task : one.tasks)
      RC_ASSERT(needed_for(lot.tasks.at(task.value())).contains(*one.member));
    RC_ASSERT(!some_order_can_be_dated(lot, one.tasks));
    for (const TaskNumber task : one.tasks)
      RC_ASSERT(one.why.find(to_text(task) + " ") != std::string::npos);
  }
}

// Many for one, so that there are threes and fours of which any two fit.
RC_GTEST_PROP(ContradictoryWindows, MoreThatNeedOneMemberAreNamedIfAndOnlyIfNoOrderCanBeDated,
              (std::uint64_t seed)) {
  for (const auto pinned_to : {std::optional<MemberNumber>(), std::optional(MemberNumber(0))}) {
    Lot lot = sound(crowded(seed), pinned_to);
    lot.precedences.clear();
    if (!can_be_dated(lot)) continue;
    const auto found = member_conflicts(lot, everybody());
    for (const MemberNumber member : everybody()) {
      const auto tasks = that_need(lot, member);
      const bool named = std::any_of(found.begin(), found.end(), [&](const MemberConflict& one) {
        return one.member && std::all_of(one.tasks.begin(), one.tasks.end(), [&](TaskNumber task) {
                 return std::find(tasks.begin(), tasks.end(), task) != tasks.end();
               });
      });
      RC_ASSERT(named == !some_order_can_be_dated(lot, tasks));
    }
    for (const MemberConflict& one : found) {
      for (const TaskNumber task : one.tasks) {
        if (!one.member || one.tasks.size() < 2) continue;
        std::vector<TaskNumber> others = one.tasks;
        std::erase(others, task);
        RC_ASSERT(some_order_can_be_dated(lot, others));
      }
    }
  }
}

// Each lasts 50 of the 100 s: any two fit, and of twenty there are too many for the interval.
TEST(ContradictoryWindows, OfManyTasksAnIntervalThatIsTooFullIsFound) {
  Lot lot;
  for (std::uint32_t i = 0; i < 3; ++i)
    lot.tasks.push_back(a_task(31 + i).from(1000).lasting(50).by(1100).pinned(1));
  for (std::uint32_t i = 0; i < 20; ++i) lot.tasks.push_back(a_task(51 + i).lasting(5).pinned(1));

  const auto found = member_conflicts(lot, everybody());

  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0].tasks,
              ::testing::ElementsAre(TaskNumber(31), TaskNumber(32), TaskNumber(33)));
}

TEST(ContradictoryWindows, ThreeOfWhichAnyTwoFitAreSaidWithTheirDates) {
  const auto found = member_conflicts(
      {{a_task(41).from(10).lasting(40).by(100).pinned(2), a_task(42).lasting(40).by(110).pinned(2),
        a_task(43).from(5).lasting(40).by(119).pinned(2)},
       {}},
      everybody());

  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].why,
            "they fit in no order: 41 begins at 10 s at the earliest, lasts 40 s and must end by "
            "100 s; 42 begins at 0 s at the earliest, lasts 40 s and must end by 110 s; 43 begins "
            "at 5 s at the earliest, lasts 40 s and must end by 119 s");
}

RC_GTEST_PROP(ContradictoryWindows, ATaskForMoreThanMayDoItIsNamedWithHowManyMay,
              (std::uint64_t seed)) {
  const Lot lot = crowded(seed);
  const auto found = member_conflicts(lot, everybody());

  for (const Task& task : lot.tasks) {
    const std::size_t may = kMembers - task.forbidden.size();
    const bool named = std::any_of(found.begin(), found.end(), [&](const MemberConflict& one) {
      return one.tasks == std::vector{task.number} &&
             one.why == "it is for " + std::to_string(task.least_members) + " members, and " +
                            std::to_string(may) + " may do it";
    });
    RC_ASSERT(named == (may < task.least_members));
  }
}

TEST(ContradictoryWindows, EveryBoundThatTakesPartIsSaid) {
  const auto found = contradictions(
      {{a_task(11).from(100).lasting(20), a_task(12).lasting(30), a_task(13).lasting(5).by(140)},
       {{TaskNumber(11), TaskNumber(12)}, {TaskNumber(12), TaskNumber(13)}}});

  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].why,
            "the last cannot end before 155 s, its deadline is 140 s: 11 begins at 100 s at the "
            "earliest and lasts 20 s, then 12 lasts 30 s, then 13 lasts 5 s");
}

TEST(ContradictoryWindows, AJointTaskWhoseMembersCannotBeThereTogetherIsSaidWithBothOrders) {
  Task joint = a_task(21).from(50).by(80).lasting(30).members(3);
  const auto found = member_conflicts(
      {{joint, a_task(22).from(40).by(100).lasting(50).pinned(1)}, {}}, everybody());

  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].member, MemberNumber(1));
  EXPECT_EQ(found[0].why,
            "after 21 (ends at 80 s at the earliest, lasts 30 s) 22 cannot end before 130 s, and "
            "must by 100 s; after 22 (ends at 90 s at the earliest, lasts 50 s) 21 cannot end "
            "before 120 s, and must by 80 s");
}

TEST(ContradictoryWindows, WhatNobodyMayDoNeedsNobody) {
  Task forbidden = a_task(31).by(10).lasting(10).pinned(1);
  forbidden.forbidden = {MemberNumber(1)};
  const Task pinned = a_task(32).by(10).lasting(10).pinned(1);

  EXPECT_THAT(member_conflicts({{forbidden, pinned}, {}}, everybody()), ::testing::IsEmpty());
}

}  // namespace
}  // namespace skein::auction
