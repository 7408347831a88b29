// SPDX-License-Identifier: Apache-2.0
// The laws of the blackboard, which hold over every transport. Built once for each of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/laws.hpp"
#include "testing/samples.hpp"

namespace skein::blackboard::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST_F(BlackboardLaws, StateReachesALateJoiner) {
  system.start(kMarvin);
  send(kMarvin, kGround, degree(2));
  send(kMarvin, kGround, degree(3));

  system.start(kGround);

  ASSERT_TRUE(
      system.run_until([&] { return !system.values<wire::AutonomyDegree>(kGround).empty(); }));
  ASSERT_TRUE(system.run_until_reachable(kGround, kMarvin));
  settle();
  const auto values = system.values<wire::AutonomyDegree>(kGround);
  ASSERT_EQ(values.size(), 1U);
  EXPECT_EQ(values[0].degree, 3);
}

TEST_F(BlackboardLaws, EveryInstanceOfAStateReachesALateJoiner) {
  system.start(kSim);
  for (std::uint32_t instance = 1; instance <= 40; ++instance) {
    wire::LinkState link;
    link.header.instance = instance;
    link.from = instance;
    link.to = kGround.number.value();  // in memory a link state goes to the two that it is about
    ASSERT_TRUE(system[kSim].publish(link, system.now()));
  }

  system.start(kGround);

  EXPECT_TRUE(
      system.run_until([&] { return system.values<wire::LinkState>(kGround).size() == 40; }));
}

TEST_F(BlackboardLaws, StateSetDuringACutArrivesAfterItOnce) {
  start_pair();
  send(kMarvin, kGround, degree(2));
  ASSERT_TRUE(
      system.run_until([&] { return !system.values<wire::AutonomyDegree>(kGround).empty(); }));

  system.set_link(kGround, kMarvin, false);
  send(kMarvin, kGround, degree(4));
  send(kMarvin, kGround, degree(5));
  ASSERT_TRUE(system.run_until_reachable(kGround, kMarvin, false));
  EXPECT_EQ(system.values<wire::AutonomyDegree>(kGround).size(), 1U);
  system.set_link(kGround, kMarvin, true);

  ASSERT_TRUE(
      system.run_until([&] { return system.values<wire::AutonomyDegree>(kGround).size() > 1; }));
  ASSERT_TRUE(system.run_until_reachable(kGround, kMarvin));
  settle();
  const auto values = system.values<wire::AutonomyDegree>(kGround);
  ASSERT_EQ(values.size(), 2U);
  EXPECT_EQ(values[1].degree, 5);
}

TEST_F(BlackboardLaws, EventsKeepTheirOrderAcrossSlots) {
  start_pair();

  std::vector<std::uint64_t> sent;
  for (std::uint64_t i = 1; i <= 100; ++i) {
    sent.push_back(i);
    if (i % 3 == 0) {
      send(kMarvin, kGround, sync_message(i));
    } else {
      send(kMarvin, kGround, task_event(i));
    }
  }

  ASSERT_TRUE(run_until_events(kGround, 100));
  EXPECT_EQ(events(kGround), sent);
  EXPECT_TRUE(
      system.run_until([&] { return system[kMarvin].unacknowledged(kGround.number) == 0; }));
}

TEST_F(BlackboardLaws, EventsSentDuringACutArriveOnceAndInOrder) {
  start_pair();
  send(kMarvin, kGround, task_event(1));
  ASSERT_TRUE(run_until_events(kGround, 1));

  system.set_link(kGround, kMarvin, false);
  send(kMarvin, kGround, task_event(2));
  send(kMarvin, kGround, task_event(3));
  ASSERT_TRUE(system.run_until_reachable(kGround, kMarvin, false));
  EXPECT_THAT(events(kGround), ElementsAre(1));
  system.set_link(kGround, kMarvin, true);

  ASSERT_TRUE(system.run_until_reachable(kGround, kMarvin));
  settle();
  EXPECT_THAT(events(kGround), ElementsAre(1, 2, 3, 900));
}

TEST_F(BlackboardLaws, RepeatedCutsNeverRepeatAnEvent) {
  start_pair();

  std::vector<std::uint64_t> sent;
  for (std::uint64_t i = 1; i <= 5; ++i) {
    send(kMarvin, kGround, task_event(i));
    ASSERT_TRUE(run_until_events(kGround, i));
    sent.push_back(i);
    system.set_link(kGround, kMarvin, false);
    ASSERT_TRUE(system.run_until_reachable(kGround, kMarvin, false));
    system.set_link(kGround, kMarvin, true);
    ASSERT_TRUE(system.run_until_reachable(kGround, kMarvin));
  }
  settle();

  sent.push_back(900);
  EXPECT_EQ(events(kGround), sent);
}

TEST_F(BlackboardLaws, MoreEventsThanATransportKeepSurviveACut) {
  start_pair();
  system.set_link(kGround, kMarvin, false);

  std::vector<std::uint64_t> sent;
  for (std::uint64_t i = 1; i <= 3 * kEventDepth; ++i) {
    send(kMarvin, kGround, task_event(i));
    sent.push_back(i);
  }
  system.set_link(kGround, kMarvin, true);

  ASSERT_TRUE(run_until_events(kGround, sent.size()));
  EXPECT_EQ(events(kGround), sent);
}

TEST_F(BlackboardLaws, ARestartedSenderStartsANewSequence) {
  start_pair();
  send(kMarvin, kGround, task_event(1));
  ASSERT_TRUE(run_until_events(kGround, 1));

  system.kill(kMarvin);
  system.start(kMarvin);
  send(kMarvin, kGround, task_event(2));
  send(kMarvin, kGround, task_event(3));

  ASSERT_TRUE(run_until_events(kGround, 3));
  EXPECT_THAT(events(kGround), ElementsAre(1, 2, 3));
  const auto reports = system.reports<Reachability>(kGround);
  ASSERT_FALSE(reports.empty());
  EXPECT_TRUE(reports.back().restarted);
}

TEST_F(BlackboardLaws, ARestartedReceiverGetsOnlyWhatWasNotAcknowledged) {
  start_pair();
  send(kMarvin, kGround, task_event(1));
  send(kMarvin, kGround, task_event(2));
  ASSERT_TRUE(run_until_events(kGround, 2));
  ASSERT_TRUE(
      system.run_until([&] { return system[kMarvin].unacknowledged(kGround.number) == 0; }));

  system.kill(kGround);
  ASSERT_TRUE(system.run_until_reachable(kMarvin, kGround, false));
  send(kMarvin, kGround, task_event(3));
  system.start(kGround);

  ASSERT_TRUE(system.run_until_reachable(kGround, kMarvin));
  settle();
  EXPECT_THAT(events(kGround), ElementsAre(3, 900));
}

TEST_F(BlackboardLaws, AnEventThatExpiresDuringACutIsReportedAndNeverDelivered) {
  start_pair();
  system.set_link(kGround, kMarvin, false);
  send(kMarvin, kGround, task_event(1));
  send(kMarvin, kGround, task_event(2), {.expires = MissionTime::seconds(10)});
  send(kMarvin, kGround, task_event(3));
  ASSERT_TRUE(system.run_until_reachable(kGround, kMarvin, false));

  system.mission = MissionTime::seconds(11);
  system.set_link(kGround, kMarvin, true);

  ASSERT_TRUE(run_until_events(kGround, 2));
  settle();
  EXPECT_THAT(events(kGround), ElementsAre(1, 3, 900));
  const auto expired = system.reports<EventExpired>(kMarvin);
  ASSERT_EQ(expired.size(), 1U);
  EXPECT_EQ(expired[0].sequence, 2U);
  EXPECT_EQ(expired[0].to, kGround.number);
}

TEST_F(BlackboardLaws, WhatASenderGaveUpIsALossForTheReceiver) {
  start_pair();
  settle();  // so that the session is open
  system.set_link(kGround, kMarvin, false);
  send(kMarvin, kGround, task_event(1), {.expires = MissionTime::seconds(10)});
  send(kMarvin, kGround, task_event(2), {.expires = MissionTime::seconds(10)});
  ASSERT_TRUE(system.run_until_reachable(kGround, kMarvin, false));

  system.mission = MissionTime::seconds(11);
  ASSERT_TRUE(system.run_until([&] { return system.reports<EventExpired>(kMarvin).size() == 2; }));
  system.set_link(kGround, kMarvin, true);

  ASSERT_TRUE(system.run_until([&] { return !system.reports<EventsLost>(kGround).empty(); }));
  const auto lost = system.reports<EventsLost>(kGround);
  EXPECT_EQ(lost[0].first, 2U);
  EXPECT_EQ(lost[0].last, 3U);
  ASSERT_TRUE(system.run_until_reachable(kGround, kMarvin));
  send(kMarvin, kGround, sync_message(900));
  ASSERT_TRUE(run_until_events(kGround, 2));
  EXPECT_THAT(events(kGround), ElementsAre(900, 900));
}

TEST_F(BlackboardLaws, AStreamIsHeardFromItsFirstSampleOnByWhoIsConnected) {
  start_pair();
  settle();

  send(kMarvin, kGround, telemetry(0.5));

  EXPECT_TRUE(system.run_until([&] { return !system.values<wire::Telemetry>(kGround).empty(); }));
}

TEST_F(BlackboardLaws, StreamsDuringACutAreLost) {
  start_pair();
  system.set_link(kGround, kMarvin, false);
  send(kMarvin, kGround, telemetry(0.25));
  ASSERT_TRUE(system.run_until_reachable(kGround, kMarvin, false));

  system.set_link(kGround, kMarvin, true);
  ASSERT_TRUE(system.run_until_reachable(kGround, kMarvin));
  const bool heard = system.run_until([&] {
    send(kMarvin, kGround, telemetry(0.75));
    return !system.values<wire::Telemetry>(kGround).empty();
  });

  ASSERT_TRUE(heard);
  for (const auto& value : system.values<wire::Telemetry>(kGround)) EXPECT_EQ(value.energy, 0.75);
}

TEST_F(BlackboardLaws, ReachabilityIsLostAndComesBack) {
  start_pair();

  system.set_link(kGround, kMarvin, false);
  ASSERT_TRUE(system.run_until_reachable(kGround, kMarvin, false));
  system.set_link(kGround, kMarvin, true);
  ASSERT_TRUE(system.run_until_reachable(kGround, kMarvin));

  const auto reports = system.reports<Reachability>(kGround);
  ASSERT_GE(reports.size(), 3U);
  EXPECT_TRUE(reports[0].reachable);
  EXPECT_FALSE(reports[1].reachable);
  EXPECT_TRUE(reports[2].reachable);
  for (const auto& report : reports) EXPECT_FALSE(report.restarted);
}

TEST_F(BlackboardLaws, ACutInOneDirectionStopsOnlyThatDirection) {
  start_pair();

  system.set_condition(kMarvin, kGround, {.up = false, .latency = {}, .loss = 0});

  ASSERT_TRUE(system.run_until([&] { return !system[kGround].reachable(kMarvin.number); }));
  EXPECT_TRUE(system[kMarvin].reachable(kGround.number));
  send(kGround, kMarvin, sync_message(7));
  ASSERT_TRUE(run_until_events(kMarvin, 1));
}

TEST_F(BlackboardLaws, ASharedPartitionKeepsTheTwoDirectionsApart) {
  system.start(kMarvin);
  system.start(kSim);
  ASSERT_TRUE(system.run_until_reachable(kMarvin, kSim));

  wire::FunctionalStatus status;
  status.id = 1;
  send(kSim, kMarvin, status);
  wire::FunctionalRequest request;
  request.id = 2;
  send(kMarvin, kSim, request);

  ASSERT_TRUE(system.run_until([&] {
    return !system.values<wire::FunctionalStatus>(kMarvin).empty() &&
           !system.values<wire::FunctionalRequest>(kSim).empty();
  }));
  EXPECT_THAT(system.values<wire::FunctionalRequest>(kMarvin), IsEmpty());
  EXPECT_THAT(system.values<wire::FunctionalStatus>(kSim), IsEmpty());
  EXPECT_THAT(system.reports<Dropped>(kMarvin), IsEmpty());
}

TEST_F(BlackboardLaws, JournalEntriesReachALateReaderOfTheWorldInOrder) {
  system.start(kSim);
  for (int i = 0; i < 300; ++i) {
    wire::JournalEntry entry;
    entry.record = std::to_string(i);
    ASSERT_TRUE(system[kSim].publish(entry, system.now()));
  }

  system.start(kGround);

  ASSERT_TRUE(
      system.run_until([&] { return system.values<wire::JournalEntry>(kGround).size() == 300; }));
  const auto entries = system.values<wire::JournalEntry>(kGround);
  for (std::size_t i = 0; i < entries.size(); ++i) EXPECT_EQ(entries[i].record, std::to_string(i));
}

TEST_F(BlackboardLaws, AFullStoreRefusesAndLosesNothing) {
  system.held_events = 8;
  start_pair();
  system.set_link(kGround, kMarvin, false);
  for (std::uint64_t i = 1; i <= 8; ++i) send(kMarvin, kGround, task_event(i));

  const auto refused = system[kMarvin].send(task_event(9), kGround.number, system.now());
  system.set_link(kGround, kMarvin, true);

  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error(), Refusal::kFull);
  ASSERT_TRUE(run_until_events(kGround, 8));
  ASSERT_TRUE(
      system.run_until([&] { return system[kMarvin].unacknowledged(kGround.number) == 0; }));
  ASSERT_TRUE(system.run_until_reachable(kGround, kMarvin));
  settle();
  EXPECT_THAT(events(kGround), ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 900));
}

TEST_F(BlackboardLaws, ALargeEventGoesThroughWhole) {
  start_pair();
  wire::TaskRequest request;
  request.task.parameters.push_back({"path", std::string(60'000, 'x'), {}});
  for (int i = 0; i < 4; ++i) {
    request.task.parameters.push_back({"points", "", std::vector<double>(4096, 1.5)});
  }

  send(kGround, kMarvin, request);

  ASSERT_TRUE(system.run_until([&] { return !system.values<wire::TaskRequest>(kMarvin).empty(); }));
  EXPECT_EQ(system.values<wire::TaskRequest>(kMarvin)[0].task, request.task);
}

TEST_F(BlackboardLaws, LatencyDelaysWithoutReordering) {
  start_pair();
  const Duration latency = Duration::milliseconds(150);
  system.set_condition(kMarvin, kGround, {.up = true, .latency = latency, .loss = 0});
  const Duration sent = system.now().steady;

  for (std::uint64_t i = 1; i <= 5; ++i) send(kMarvin, kGround, task_event(i));

  ASSERT_TRUE(run_until_events(kGround, 5));
  EXPECT_GE(system.now().steady - sent, latency);
  EXPECT_THAT(events(kGround), ElementsAre(1, 2, 3, 4, 5));
}

TEST_F(BlackboardLaws, WhatIsMalformedIsReportedAndGoesNoFurther) {
  system.start(kGround);
  const auto intruder = system.medium().transport("intruder");
  TransportPlan plan;
  plan.self = kMarvin.number;
  plan.channels = radio_link(kMarvin, kGround);
  ASSERT_TRUE(intruder->open(plan));
  wire::PlanBoard board;
  board.header.origin = kMarvin.number.value();
  board.header.incarnation = 1;
  board.tasks.resize(3);
  const auto write = [&](std::uint64_t sequence, wire::TaskState state) {
    board.header.sequence_number = sequence;
    board.tasks[sequence].state = state;
    ASSERT_TRUE(intruder->write(0, board));
    const std::size_t before = system.received(kGround).size();
    ASSERT_TRUE(system.run_until([&] { return system.received(kGround).size() > before; }));
    board.tasks[sequence].state = wire::TaskState::kEnded;
  };

  write(1, static_cast<wire::TaskState>(77));
  write(2, static_cast<wire::TaskState>(78));
  write(1, wire::TaskState::kRunning);

  const auto dropped = system.reports<Dropped>(kGround);
  ASSERT_EQ(dropped.size(), 2U);
  EXPECT_EQ(dropped[0].slot, wire::Slot::kPlanBoard);
  EXPECT_EQ(dropped[0].origin, kMarvin.number);
  EXPECT_EQ(dropped[0].field, "tasks[1].state");
  EXPECT_EQ(dropped[0].why, "77 is not a value of the enumeration");
  EXPECT_TRUE(dropped[0].first);
  EXPECT_EQ(dropped[1].field, "tasks[2].state");
  EXPECT_FALSE(dropped[1].first);
  EXPECT_EQ(system.values<wire::PlanBoard>(kGround).size(), 1U);
}

TEST_F(BlackboardLaws, AStrangerOnAChannelIsRefused) {
  system.start(kGround);
  const auto intruder = system.medium().transport("intruder");
  TransportPlan plan;
  plan.self = NodeNumber(66);
  plan.channels = radio_link({NodeNumber(66), "marvin"}, kGround);
  ASSERT_TRUE(intruder->open(plan));
  wire::PlanBoard board;
  board.header.origin = 66;
  board.header.incarnation = 1;
  board.header.sequence_number = 1;

  ASSERT_TRUE(intruder->write(0, board));

  ASSERT_TRUE(system.run_until([&] { return !system.received(kGround).empty(); }));
  EXPECT_EQ(system.reports<Dropped>(kGround).at(0).field, "header.origin");
  EXPECT_THAT(system.values<wire::PlanBoard>(kGround), IsEmpty());
}

TEST_F(BlackboardLaws, ASpyReadsWhatOthersSay) {
  const auto spy = system.medium().transport("spy");
  TransportPlan plan;
  plan.self = NodeNumber(99);
  ChannelConfig any = radio_link(kMarvin, kGround)[0];
  any.partition = "radio/*";
  plan.channels.push_back(any);
  ASSERT_TRUE(spy->open(plan));
  start_pair();

  send(kMarvin, kGround, degree(4));

  bool seen = false;
  EXPECT_TRUE(system.run_until([&] {
    for (const Arrival& arrival : spy->take()) {
      const auto* sample = std::get_if<wire::Sample>(&arrival.content);
      seen = seen || (sample != nullptr && std::holds_alternative<wire::AutonomyDegree>(*sample));
    }
    return seen;
  }));
}

TEST_F(BlackboardLaws, WhatASenderMayNotSendIsRefused) {
  system.start(kMarvin);
  wire::Telemetry wrong = telemetry(std::numeric_limits<double>::infinity());
  Blackboard& marvin = system[kMarvin];

  EXPECT_EQ(marvin.send(degree(2), NodeNumber(42), system.now()).error(), Refusal::kNoChannel);
  EXPECT_EQ(marvin.send(wire::Clock{}, kGround.number, system.now()).error(), Refusal::kNoChannel);
  EXPECT_EQ(marvin.publish(degree(2), system.now()).error(), Refusal::kNoChannel);
  EXPECT_EQ(marvin.send(wrong, kGround.number, system.now()).error(), Refusal::kMalformed);
}

}  // namespace
}  // namespace skein::blackboard::testing
