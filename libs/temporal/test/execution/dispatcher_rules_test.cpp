// SPDX-License-Identifier: Apache-2.0
// The rules of the dispatcher one by one: windows of one instant, several waits, limits of
// contingent links, wake-ups, what a refusal and a contingency leave.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "controllability/random_stnu.hpp"
#include "controllability/stnu_builder.hpp"
#include "skein/temporal/dispatcher.hpp"
#include "skein/temporal/stnu_execution.hpp"

namespace skein::temporal {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::StnuBuilder;
using ::testing::UnorderedElementsAre;
using Why = Refused::Why;
using Kind = Contingency::Kind;

MissionTime at(Ticks ticks) { return MissionTime::nanoseconds(ticks); }

Dispatcher dispatcher_of(const StnuBuilder& builder, Ticks origin_at = 0) {
  const auto form = make_dispatchable(builder.build());
  EXPECT_TRUE(form.has_value());
  return Dispatcher(form.value(), at(origin_at));
}

DispatchEffect may_start(NodeIndex node, std::optional<MissionTime> until) {
  return MayStart{node, until};
}
DispatchEffect refused(NodeIndex node, Why why) { return Refused{node, why}; }
DispatchEffect missed(NodeIndex node, Ticks deadline) { return Missed{node, at(deadline)}; }
DispatchEffect contingency(std::uint32_t link, Kind kind, Ticks elapsed) {
  return Contingency{link, kind, Duration::nanoseconds(elapsed)};
}

/// z=0, a=1 from 1 to 10, c=2 the end 2 to 5 after a.
StnuBuilder task() { return StnuBuilder("z a c").contingent("a", "c", 2, 5).arc("z", "a", 1, 10); }

/// All that can be asked of a dispatcher.
struct Answers {
  std::vector<std::optional<DispatchWindow>> windows;
  std::vector<std::optional<MissionTime>> dates;
  std::vector<NodeIndex> startable;
  std::optional<MissionTime> wakeup, must_act_by;
  bool stopped, complete;
  bool operator==(const Answers&) const = default;
};

Answers answers_of(const Dispatcher& dispatcher, NodeIndex nodes) {
  Answers all{{},
              {},
              dispatcher.startable(),
              dispatcher.next_wakeup(),
              dispatcher.must_act_by(),
              dispatcher.stopped(),
              dispatcher.complete()};
  for (NodeIndex node = 0; node < nodes; ++node) {
    all.windows.push_back(dispatcher.window(node));
    all.dates.push_back(dispatcher.date(node));
  }
  return all;
}

TEST(DispatchableForm, OfDistancesThatDoNotFitIsANamedError) {
  // Each arc fits, and two of them; the third takes the date beyond.
  Stnu network = StnuBuilder("z a b c").build();
  network.arcs = {{0, 1, kLargest, kInfinite}, {1, 2, kLargest, kInfinite}};
  EXPECT_TRUE(make_dispatchable(network).has_value());

  network.arcs.push_back({2, 3, kLargest, kInfinite});
  const auto form = make_dispatchable(network);

  ASSERT_FALSE(form.has_value());
  EXPECT_EQ(form.error().fault, StnuFault::kOverflow);
}

TEST(DispatcherWindow, OfOneInstantIsOfferedThenAndOnlyThen) {
  const StnuBuilder appointment = StnuBuilder("z a").arc("z", "a", 5, 5);
  Dispatcher in_time = dispatcher_of(appointment);
  Dispatcher too_late = dispatcher_of(appointment);

  EXPECT_EQ(in_time.next_wakeup(), at(5));
  EXPECT_THAT(in_time.handle(TimePassed{}, at(4)), IsEmpty());
  EXPECT_THAT(in_time.handle(TimePassed{}, at(5)), ElementsAre(may_start(1, at(5))));
  EXPECT_EQ(in_time.next_wakeup(), at(6)) << "to tell that it was missed";
  EXPECT_THAT(in_time.handle(Executed{1}, at(5)), ElementsAre(DispatchEffect(Completed{})));

  EXPECT_THAT(too_late.handle(TimePassed{}, at(6)), ElementsAre(missed(1, 5)));
  EXPECT_EQ(too_late.next_wakeup(), std::nullopt);
}

TEST(DispatcherWindow, AnExecutionAfterItIsAMissAndARefusal) {
  Dispatcher dispatcher = dispatcher_of(StnuBuilder("z a").arc("z", "a", 1, 5));

  EXPECT_THAT(dispatcher.handle(Executed{1}, at(6)),
              ElementsAre(missed(1, 5), refused(1, Why::kStopped)));
  EXPECT_EQ(dispatcher.date(1), std::nullopt);
  EXPECT_FALSE(dispatcher.complete());
}

TEST(DispatcherWindow, IsNarrowedByAnExecutionAndOfferedOnce) {
  Dispatcher dispatcher = dispatcher_of(
      StnuBuilder("z a b").arc("z", "a", 0, 10).arc("z", "b", 0, 30).arc("a", "b", 0, 4));
  EXPECT_THAT(dispatcher.handle(TimePassed{}, at(0)), Contains(may_start(1, at(10))));

  dispatcher.handle(Executed{1}, at(3));

  EXPECT_EQ(dispatcher.window(2), (DispatchWindow{at(3), at(7)}));
  EXPECT_EQ(dispatcher.window(1), std::nullopt) << "it is done";
  EXPECT_THAT(dispatcher.handle(TimePassed{}, at(5)), IsEmpty());
  EXPECT_EQ(dispatcher.must_act_by(), at(7));
}

TEST(DispatcherWindow, WithoutALimitNothingMustBeDone) {
  Dispatcher dispatcher = dispatcher_of(StnuBuilder("z a"));

  EXPECT_THAT(dispatcher.handle(TimePassed{}, at(0)), ElementsAre(may_start(1, std::nullopt)));
  EXPECT_EQ(dispatcher.must_act_by(), std::nullopt);
  EXPECT_EQ(dispatcher.next_wakeup(), std::nullopt);
  EXPECT_THAT(dispatcher.handle(TimePassed{}, at(kLargest)), IsEmpty());
  EXPECT_FALSE(dispatcher.stopped());
}

TEST(DispatcherWindow, BeginsAtTheHourOfTheOriginWhateverThatIs) {
  for (const Ticks origin_at : {Ticks{-1'000}, Ticks{0}, Ticks{123'456'789}}) {
    Dispatcher dispatcher = dispatcher_of(task(), origin_at);

    EXPECT_EQ(dispatcher.date(0), at(origin_at));
    EXPECT_EQ(dispatcher.window(1), (DispatchWindow{at(origin_at + 1), at(origin_at + 10)}));
    EXPECT_THAT(dispatcher.handle(TimePassed{}, at(origin_at - 1)),
                ElementsAre(refused(0, Why::kTimeWentBack)));
  }
}

TEST(DispatcherWindow, TheOriginAloneIsCompleteAtOnce) {
  Dispatcher dispatcher = dispatcher_of(StnuBuilder("z"));

  EXPECT_THAT(dispatcher.handle(TimePassed{}, at(0)), ElementsAre(DispatchEffect(Completed{})));
  EXPECT_THAT(dispatcher.handle(TimePassed{}, at(1)), IsEmpty());
}

TEST(DispatcherLinks, EndsAtTheirLeastAndGreatestDurationAreNoContingency) {
  for (const Ticks duration : {2, 5}) {
    Dispatcher dispatcher = dispatcher_of(task());
    dispatcher.handle(Executed{1}, at(4));

    EXPECT_THAT(dispatcher.handle(Observed{2}, at(4 + duration)),
                ElementsAre(DispatchEffect(Completed{})));
    EXPECT_EQ(dispatcher.date(2), at(4 + duration));
  }
}

TEST(DispatcherLinks, OneInstantOutsideIsAContingencyThatSaysHowMuch) {
  Dispatcher early = dispatcher_of(task());
  Dispatcher late = dispatcher_of(task());
  early.handle(Executed{1}, at(4));
  late.handle(Executed{1}, at(4));

  EXPECT_THAT(early.handle(Observed{2}, at(5)), Contains(contingency(0, Kind::kEarly, 1)));
  EXPECT_THAT(late.handle(Observed{2}, at(10)), Contains(contingency(0, Kind::kLate, 6)));
  EXPECT_TRUE(early.stopped());
  EXPECT_TRUE(late.stopped());
}

TEST(DispatcherLinks, AfterAContingencyNothingIsOfferedAndEndsAreStillRecorded) {
  Dispatcher dispatcher = dispatcher_of(StnuBuilder("z a c b d x")
                                            .contingent("a", "c", 2, 5)
                                            .contingent("b", "d", 2, 9)
                                            .arc("z", "x", 3, 90));
  dispatcher.handle(Executed{1}, at(0));
  dispatcher.handle(Executed{3}, at(0));
  dispatcher.handle(Observed{2}, at(1));
  ASSERT_TRUE(dispatcher.stopped());

  EXPECT_THAT(dispatcher.handle(TimePassed{}, at(3)), IsEmpty()) << "x would be offered";
  EXPECT_THAT(dispatcher.startable(), IsEmpty());
  EXPECT_EQ(dispatcher.next_wakeup(), std::nullopt);
  EXPECT_THAT(dispatcher.handle(Observed{4}, at(4)), IsEmpty());
  EXPECT_EQ(dispatcher.date(4), at(4));
  EXPECT_THAT(dispatcher.handle(Executed{5}, at(4)), ElementsAre(refused(5, Why::kStopped)));
}

TEST(DispatcherLinks, EachOverdueEndIsToldOnceByItself) {
  Dispatcher dispatcher =
      dispatcher_of(StnuBuilder("z a c b d").contingent("a", "c", 2, 5).contingent("b", "d", 2, 9));
  dispatcher.handle(Executed{1}, at(0));
  dispatcher.handle(Executed{3}, at(0));

  EXPECT_EQ(dispatcher.next_wakeup(), at(6));
  EXPECT_THAT(dispatcher.handle(TimePassed{}, at(6)),
              ElementsAre(contingency(0, Kind::kOverdue, 6)));
  EXPECT_THAT(dispatcher.handle(TimePassed{}, at(9)), IsEmpty());
  EXPECT_THAT(dispatcher.handle(TimePassed{}, at(20)),
              ElementsAre(contingency(1, Kind::kOverdue, 20)));
}

TEST(DispatcherLinks, AnEndSeenTwiceIsRefusedAndKeepsItsDate) {
  Dispatcher dispatcher = dispatcher_of(task());
  dispatcher.handle(Executed{1}, at(1));
  dispatcher.handle(Observed{2}, at(4));

  EXPECT_THAT(dispatcher.handle(Observed{2}, at(5)), ElementsAre(refused(2, Why::kAlreadyDone)));
  EXPECT_EQ(dispatcher.date(2), at(4));
  EXPECT_FALSE(dispatcher.stopped());
}

TEST(DispatcherWaits, ANodeWaitsForTheLaterOfTwo) {
  // x at most 2 before c (3 after a at the earliest) and at most 1 before d (7 after b).
  const StnuBuilder two = StnuBuilder("z a c b d x")
                              .contingent("a", "c", 2, 5)
                              .contingent("b", "d", 2, 8)
                              .arc("z", "a", 0, 0)
                              .arc("z", "b", 0, 0)
                              .arc("x", "c", kMinusInfinite, 2)
                              .arc("x", "d", kMinusInfinite, 1)
                              .arc("z", "x", 0, 99);
  Dispatcher dispatcher = dispatcher_of(two);
  dispatcher.handle(Executed{1}, at(0));
  dispatcher.handle(Executed{3}, at(0));

  EXPECT_EQ(dispatcher.window(5)->from, at(7));
  dispatcher.handle(Observed{4}, at(2));
  EXPECT_EQ(dispatcher.window(5)->from, at(3)) << "the wait for c is left";
  EXPECT_THAT(dispatcher.handle(Observed{2}, at(2)), ElementsAre(may_start(5, at(99))));
}

TEST(DispatcherWaits, ANodeIsNotEnabledBeforeTheActivationItWaitsFor) {
  Dispatcher dispatcher =
      dispatcher_of(StnuBuilder("z a c x").contingent("a", "c", 2, 5).arc("x", "c", -99, 2));

  EXPECT_EQ(dispatcher.window(3), std::nullopt);
  EXPECT_THAT(dispatcher.handle(Executed{3}, at(50)), Contains(refused(3, Why::kNotEnabled)));
  dispatcher.handle(Executed{1}, at(60));
  EXPECT_EQ(dispatcher.window(3)->from, at(63));
}

TEST(DispatcherRefusals, LeaveEveryAnswerAsItWas) {
  Dispatcher dispatcher = dispatcher_of(
      StnuBuilder("z a c x").contingent("a", "c", 2, 5).arc("z", "a", 1, 10).arc("c", "x", 1, 4));
  dispatcher.handle(Executed{1}, at(2));
  dispatcher.handle(TimePassed{}, at(3));
  const Answers before = answers_of(dispatcher, 5);
  const std::vector<std::pair<DispatchInput, Ticks>> inputs = {
      {Executed{4}, 3}, {Observed{4}, 3}, {Executed{2}, 3}, {Observed{1}, 3}, {Executed{1}, 3},
      {Executed{0}, 3}, {Executed{3}, 3}, {Observed{2}, 2}, {Executed{3}, 1}, {TimePassed{}, 0}};

  for (const auto& [input, when] : inputs) {
    const auto effects = dispatcher.handle(input, at(when));

    ASSERT_EQ(effects.size(), 1U);
    EXPECT_TRUE(std::holds_alternative<Refused>(effects[0]));
    EXPECT_EQ(answers_of(dispatcher, 5), before);
  }
}

TEST(DispatcherRefusals, OneInstantTooEarlyIsRefusedAndTheNextIsNot) {
  Dispatcher dispatcher = dispatcher_of(task());

  EXPECT_THAT(dispatcher.handle(Executed{1}, at(0)), ElementsAre(refused(1, Why::kTooEarly)));
  EXPECT_THAT(dispatcher.handle(Executed{1}, at(1)), IsEmpty());
  EXPECT_EQ(dispatcher.date(1), at(1));
}

/// Plays a network to its end, asking at each step what the hours before the wake-up would bring.
void play_and_ask_early(const DispatchableNetwork& form, Random& random) {
  const std::vector<Ticks> durations = draw_durations(form.plan, random);
  Dispatcher dispatcher(form, at(0));
  Ticks now = 0;
  std::vector<int> offers(form.plan.nodes.size(), 0);
  const auto keep = [&](const std::vector<DispatchEffect>& effects) {
    for (const DispatchEffect& effect : effects) {
      if (const auto* offer = std::get_if<MayStart>(&effect)) ++offers[offer->node];
      ASSERT_FALSE(std::holds_alternative<Missed>(effect));
      ASSERT_FALSE(std::holds_alternative<Refused>(effect));
    }
  };
  keep(dispatcher.handle(TimePassed{}, at(0)));
  for (int step = 0; step < 200 && !dispatcher.complete(); ++step) {
    std::optional<std::pair<Ticks, NodeIndex>> end;
    for (std::size_t i = 0; i < durations.size(); ++i) {
      const ContingentLink& link = form.plan.contingent[i];
      const auto begun = dispatcher.date(link.activation);
      if (link.min == link.max || !begun || dispatcher.date(link.contingent)) continue;
      const std::pair<Ticks, NodeIndex> next{begun->count() + durations[i], link.contingent};
      if (!end || next < *end) end = next;
    }
    const auto startable = dispatcher.startable();
    if (!startable.empty() && (!end || end->first > now)) {
      keep(dispatcher.handle(Executed{startable[random.below(startable.size())]}, at(now)));
      continue;
    }
    const auto wakeup = dispatcher.next_wakeup();
    if (wakeup && wakeup->count() > now + 1) {
      Dispatcher early = dispatcher;
      ASSERT_THAT(early.handle(TimePassed{}, at(wakeup->count() - 1)), IsEmpty());
    }
    if (end && (!wakeup || end->first <= wakeup->count())) {
      now = end->first;
      keep(dispatcher.handle(Observed{end->second}, at(now)));
    } else {
      ASSERT_TRUE(wakeup.has_value()) << "stuck";
      now = wakeup->count();
      keep(dispatcher.handle(TimePassed{}, at(now)));
    }
  }
  ASSERT_TRUE(dispatcher.complete());
  for (const int count : offers) ASSERT_LE(count, 1);
}

TEST(DispatcherWakeups, NothingHappensBeforeThemAndNoNodeIsOfferedTwice) {
  Random random(90);
  int networks = 0;
  for (int i = 0; i < 1'500; ++i) {
    const Stnu network = testing::random_stnu({7, 3, 8, 10, true, 60}, random);
    const auto form = make_dispatchable(network);
    if (!form) continue;
    ++networks;
    play_and_ask_early(*form, random);
    ASSERT_FALSE(HasFatalFailure()) << "network " << i;
  }
  EXPECT_GT(networks, 200);
}

}  // namespace
}  // namespace skein::temporal
