// SPDX-License-Identifier: Apache-2.0
// The dispatcher: windows, waits, contingencies, refusals; and that no execution breaks a
// requirement.
#include "skein/temporal/dispatcher.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "controllability/random_stnu.hpp"
#include "controllability/stnu_builder.hpp"
#include "multi_agent/two_uavs.hpp"
#include "skein/temporal/stnu_controllability.hpp"
#include "skein/temporal/stnu_execution.hpp"
#include "skein/temporal_lab/stnu_generator.hpp"
#include "test_cases.hpp"

namespace skein::temporal {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::random_stnu;
using testing::StnuBuilder;

MissionTime at(Ticks ticks) { return MissionTime::nanoseconds(ticks); }

DispatchableNetwork form_of(const Stnu& network) {
  auto form = make_dispatchable(network);
  EXPECT_TRUE(form.has_value()) << (form ? "" : to_text(form.error(), network));
  return form.value_or(DispatchableNetwork{});
}

DispatchEffect may_start(NodeIndex node, std::optional<MissionTime> until) {
  return MayStart{node, until};
}
DispatchEffect refused(NodeIndex node, Refused::Why why) { return Refused{node, why}; }
DispatchEffect contingency(Contingency::Kind kind, Ticks elapsed) {
  return Contingency{0, kind, Duration::nanoseconds(elapsed)};
}

// z=0, a=1, c=2, x=3: x is at least 1 before c or after it, at most 3 before; c is 2 to 5 after a.
Stnu task_with_wait() {
  return StnuBuilder("z a c x")
      .contingent("a", "c", 2, 5)
      .arc("x", "c", kMinusInfinite, 2)
      .arc("z", "a", 1, 10)
      .arc("z", "x", 0, 30)
      .build();
}

TEST(DispatchableNetwork, ANodeThatMayNotComeTooEarlyBeforeAnEndWaits) {
  const DispatchableNetwork form = form_of(task_with_wait());

  EXPECT_THAT(form.waits, ElementsAre(WaitEdge{3, 0, 3}));
}

TEST(DispatchableNetwork, WhatIsNotControllableHasNone) {
  const Stnu network = StnuBuilder("z a c").contingent("a", "c", 2, 5).arc("a", "c", 0, 4).build();

  EXPECT_EQ(make_dispatchable(network).error().fault, StnuFault::kNotControllable);
}

TEST(DispatchableNetwork, TheOriginCannotBeAnEnd) {
  const Stnu network = StnuBuilder("z a").contingent("a", "z", 2, 5).build();

  EXPECT_EQ(make_dispatchable(network).error().fault, StnuFault::kContingentOrigin);
}

TEST(DispatchableNetwork, ANodeThatMustPrecedeTheOriginHasNone) {
  const Stnu network = StnuBuilder("z a").arc("a", "z", 1, 5).build();

  EXPECT_TRUE(check_dynamic_controllability(network)->controllable);
  EXPECT_EQ(make_dispatchable(network).error().fault, StnuFault::kNotControllable);
}

TEST(DispatchableNetwork, BadLinksAreNamedErrors) {
  const Stnu network = StnuBuilder("z a").arc("a", "z", 6, 5).build();

  EXPECT_EQ(make_dispatchable(network).error().fault, StnuFault::kEmptyInterval);
}

TEST(Dispatcher, OffersANodeWhenItsWindowOpens) {
  Dispatcher dispatcher(form_of(task_with_wait()), at(100));

  EXPECT_THAT(dispatcher.handle(TimePassed{}, at(100)), IsEmpty());
  EXPECT_EQ(dispatcher.next_wakeup(), at(101));
  EXPECT_THAT(dispatcher.handle(TimePassed{}, at(101)), ElementsAre(may_start(1, at(110))));
  EXPECT_EQ(dispatcher.must_act_by(), at(110));
  EXPECT_THAT(dispatcher.startable(), ElementsAre(1U));
}

TEST(Dispatcher, AWaitEndsAtItsDateOrWithTheObservation) {
  for (const bool seen : {false, true}) {
    Dispatcher dispatcher(form_of(task_with_wait()), at(0));
    dispatcher.handle(TimePassed{}, at(1));
    EXPECT_THAT(dispatcher.handle(Executed{1}, at(1)), IsEmpty());
    EXPECT_EQ(dispatcher.window(3)->from, at(4));

    if (seen) {
      EXPECT_THAT(dispatcher.handle(Observed{2}, at(3)), ElementsAre(may_start(3, at(30))));
    } else {
      EXPECT_EQ(dispatcher.next_wakeup(), at(4));
      EXPECT_THAT(dispatcher.handle(TimePassed{}, at(4)), ElementsAre(may_start(3, at(30))));
    }
  }
}

TEST(Dispatcher, TellsOnceThatEverythingIsDone) {
  Dispatcher dispatcher(form_of(task_with_wait()), at(0));

  dispatcher.handle(Executed{1}, at(1));
  dispatcher.handle(Observed{2}, at(3));

  EXPECT_THAT(dispatcher.handle(Executed{3}, at(3)), ElementsAre(DispatchEffect(Completed{})));
  EXPECT_THAT(dispatcher.handle(TimePassed{}, at(9)), IsEmpty());
  EXPECT_TRUE(dispatcher.complete());
  EXPECT_EQ(dispatcher.next_wakeup(), std::nullopt);
  EXPECT_EQ(dispatcher.date(3), at(3));
}

TEST(Dispatcher, AnEndBeforeItsTimeIsAContingency) {
  Dispatcher dispatcher(form_of(task_with_wait()), at(0));
  dispatcher.handle(Executed{1}, at(1));

  EXPECT_THAT(dispatcher.handle(Observed{2}, at(2)),
              ElementsAre(contingency(Contingency::Kind::kEarly, 1)));
  EXPECT_TRUE(dispatcher.stopped());
  EXPECT_THAT(dispatcher.handle(Executed{3}, at(9)),
              ElementsAre(refused(3, Refused::Why::kStopped)));
}

TEST(Dispatcher, AnEndThatDoesNotComeIsAContingencyAsSoonAsItIsLate) {
  Dispatcher dispatcher(form_of(task_with_wait()), at(0));
  dispatcher.handle(Executed{1}, at(1));
  dispatcher.handle(Executed{3}, at(4));

  EXPECT_THAT(dispatcher.handle(TimePassed{}, at(6)), IsEmpty());
  EXPECT_EQ(dispatcher.next_wakeup(), at(7));
  EXPECT_THAT(dispatcher.handle(TimePassed{}, at(7)),
              ElementsAre(contingency(Contingency::Kind::kOverdue, 6)));
  EXPECT_THAT(dispatcher.handle(TimePassed{}, at(8)), IsEmpty());
  EXPECT_THAT(dispatcher.handle(Observed{2}, at(9)),
              Contains(contingency(Contingency::Kind::kLate, 8)));
}

TEST(Dispatcher, AnEndThatNobodyAskedForIsAContingency) {
  Dispatcher dispatcher(form_of(task_with_wait()), at(0));

  EXPECT_THAT(dispatcher.handle(Observed{2}, at(1)),
              ElementsAre(contingency(Contingency::Kind::kUnasked, 0)));
}

TEST(Dispatcher, ALastDateThatPassesIsTold) {
  Dispatcher dispatcher(form_of(task_with_wait()), at(0));

  EXPECT_THAT(dispatcher.handle(TimePassed{}, at(11)),
              ElementsAre(DispatchEffect(Missed{1, at(10)})));
  EXPECT_TRUE(dispatcher.stopped());
  EXPECT_THAT(dispatcher.startable(), IsEmpty());
}

TEST(Dispatcher, InputsThatMakeNoSenseAreRefusedAndChangeNothing) {
  using Why = Refused::Why;
  Dispatcher dispatcher(form_of(task_with_wait()), at(0));
  dispatcher.handle(Executed{1}, at(2));

  EXPECT_THAT(dispatcher.handle(Executed{77}, at(2)), ElementsAre(refused(77, Why::kUnknownNode)));
  EXPECT_THAT(dispatcher.handle(Observed{77}, at(2)), ElementsAre(refused(77, Why::kUnknownNode)));
  EXPECT_THAT(dispatcher.handle(Executed{2}, at(2)), ElementsAre(refused(2, Why::kNotControlled)));
  EXPECT_THAT(dispatcher.handle(Observed{3}, at(2)), ElementsAre(refused(3, Why::kNotContingent)));
  EXPECT_THAT(dispatcher.handle(Executed{1}, at(2)), ElementsAre(refused(1, Why::kAlreadyDone)));
  EXPECT_THAT(dispatcher.handle(Executed{3}, at(2)), ElementsAre(refused(3, Why::kTooEarly)));
  EXPECT_THAT(dispatcher.handle(Observed{2}, at(1)), ElementsAre(refused(2, Why::kTimeWentBack)));
  EXPECT_FALSE(dispatcher.stopped());
  EXPECT_EQ(dispatcher.date(3), std::nullopt);
  EXPECT_EQ(dispatcher.window(77), std::nullopt);
}

TEST(Dispatcher, ANodeThatFollowsAnotherIsNotEnabledBeforeIt) {
  const Stnu network = StnuBuilder("z a b").arc("a", "b", 3, 5).build();
  Dispatcher dispatcher(form_of(network), at(0));

  EXPECT_THAT(dispatcher.handle(Executed{2}, at(8)),
              Contains(refused(2, Refused::Why::kNotEnabled)));
}

TEST(Dispatcher, AFixedContingentLinkIsExecutedLikeARequirement) {
  const Stnu network = StnuBuilder("z a c").contingent("a", "c", 4, 4).build();
  Dispatcher dispatcher(form_of(network), at(0));
  dispatcher.handle(Executed{1}, at(2));

  EXPECT_EQ(dispatcher.window(2), (DispatchWindow{at(6), at(6)}));
}

void expect_kept(const Execution& run, const std::string& what) {
  EXPECT_TRUE(run.complete) << what;
  EXPECT_THAT(run.violated, IsEmpty()) << what;
  EXPECT_THAT(run.contingencies, IsEmpty()) << what;
}

constexpr StartPolicy kPolicies[] = {StartPolicy::kEarliest, StartPolicy::kLatest,
                                     StartPolicy::kRandom};

const int kRuns = skein::testing::cases(100, 1'000);

TEST(Execution, ManyRunsOfEachPlanKeepEveryRequirement) {
  Random random(60);
  for (int plan = 0; plan < 5; ++plan) {
    const Stnu network = generate_stnu(
        {.nodes = 60, .contingent = 12, .lanes = 4, .extra_arcs_percent = 65, .break_it = false},
        random);
    const DispatchableNetwork form = form_of(network);
    for (int run = 0; run < kRuns; ++run) {
      expect_kept(execute(form, draw_durations(network, random), kPolicies[run % 3], random),
                  "plan");
    }
  }
}

TEST(Execution, ManyRunsOfEachRandomNetworkKeepEveryRequirement) {
  Random random(61);
  int networks = 0;
  std::size_t waits = 0;
  while (networks < 40) {
    const Stnu network = random_stnu({9, 4, 10, 12, true, 60}, random);
    const auto form = make_dispatchable(network);
    if (!form || form->waits.empty()) continue;
    ++networks;
    waits += form->waits.size();
    for (int run = 0; run < kRuns; ++run) {
      expect_kept(execute(*form, draw_durations(network, random), kPolicies[run % 3], random),
                  "random");
    }
  }
  EXPECT_GT(waits, 40U);
}

TEST(Execution, ManyRandomNetworksKeepEveryRequirement) {
  Random random(62);
  int networks = 0;
  const int tried = skein::testing::cases(800, 4'000);
  for (int i = 0; i < tried; ++i) {
    const auto nodes = static_cast<std::uint32_t>(3 + random.below(9));
    const Stnu network = random_stnu({nodes, 1 + nodes / 3, 2 * nodes, 12, true, 80}, random);
    const auto form = make_dispatchable(network);
    ASSERT_EQ(form.has_value(), check_dynamic_controllability(network)->controllable);
    if (!form) continue;
    ++networks;
    for (const StartPolicy policy : kPolicies) {
      for (int run = 0; run < 5; ++run) {
        expect_kept(execute(*form, draw_durations(network, random), policy, random),
                    "network " + std::to_string(i));
      }
    }
  }
  EXPECT_GT(networks, tried / 8);
}

TEST(Execution, WithoutItsWaitsAFormBreaksARequirement) {
  DispatchableNetwork form = form_of(task_with_wait());
  form.waits.clear();
  Random random(1);

  const Execution run = execute(form, {5}, StartPolicy::kEarliest, random);

  EXPECT_THAT(run.violated, ElementsAre(LinkRef{LinkKind::kRequirement, 0}));
}

TEST(Execution, ALateEndIsReportedAndNothingMoreIsStarted) {
  const Stnu network = task_with_wait();
  Random random(1);

  const Execution run = execute(form_of(network), {9}, StartPolicy::kEarliest, random);

  EXPECT_FALSE(run.complete);
  ASSERT_EQ(run.contingencies.size(), 1U);
  EXPECT_EQ(run.contingencies[0].kind, Contingency::Kind::kOverdue);
}

TEST(Execution, EqualSeedsGiveEqualRuns) {
  const Stnu network = testing::two_uavs();
  const DispatchableNetwork form = form_of(network);
  const auto play = [&] {
    Random random(8);
    return execute(form, draw_durations(network, random), StartPolicy::kRandom, random);
  };

  EXPECT_EQ(play(), play());
}

// The plan of the thesis: the slot in which both monitor may start from 9:00:30 to 9:24:30.
TEST(TwoUavs, TheJointSlotMayStartAtAnyTimeOfItsWindowAndNoOther) {
  const auto starts_at = [](Ticks second) {
    Stnu network = testing::two_uavs();
    const NodeIndex monitor = testing::node_named(network, "monitor");
    network.arcs.push_back({0, monitor, second * kTicksPerSecond, second * kTicksPerSecond});
    return *check_dynamic_controllability(network);
  };

  EXPECT_TRUE(check_dynamic_controllability(testing::two_uavs())->controllable);
  EXPECT_TRUE(starts_at(30).controllable);
  EXPECT_TRUE(starts_at(1470).controllable);
  EXPECT_FALSE(starts_at(29).controllable);
  EXPECT_TRUE(starts_at(29).consistent);
  EXPECT_FALSE(starts_at(1471).controllable);
  EXPECT_TRUE(starts_at(1471).consistent);
}

TEST(TwoUavs, EveryExecutionLandsBothInTime) {
  const Stnu network = testing::two_uavs();
  const DispatchableNetwork form = form_of(network);
  Random random(9);
  for (int run = 0; run < kRuns; ++run) {
    expect_kept(execute(form, draw_durations(network, random), kPolicies[run % 3], random),
                "two UAVs");
  }
}

}  // namespace
}  // namespace skein::temporal
