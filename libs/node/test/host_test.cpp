// SPDX-License-Identifier: Apache-2.0
#include "skein/node/host.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "testing/hosts.hpp"

namespace skein::node {
namespace {

using journal::Record;
using testing::abort_request;
using testing::at;
using testing::Diary;
using testing::FakeNode;
using testing::Hosts;
using testing::link;
using testing::Station;

TEST_F(Hosts, StartingTellsTheNodeItsIncarnation) {
  open("marvin", 3);

  (*this)["marvin"].host->start(now());

  ASSERT_EQ((*this)["marvin"].diary.all<Started>().size(), 1U);
  EXPECT_EQ((*this)["marvin"].diary.all<Started>()[0].incarnation, 3U);
  EXPECT_FALSE((*this)["marvin"].diary.all<Started>()[0].first_life);
}

TEST_F(Hosts, TheNodeIsToldThatItLivesForTheFirstTime) {
  open("marvin", 3);

  (*this)["marvin"].host->start(now(), true);

  EXPECT_TRUE((*this)["marvin"].diary.all<Started>()[0].first_life);
}

TEST_F(Hosts, WhatComesBeforeTheStartIsHandledAndLoggedAfterIt) {
  open("marvin", 2);
  Station& marvin = (*this)["marvin"];
  advance(1);
  const bool heard_before = marvin.host->all_peers_heard();
  act("ground", {Send{number("marvin"), abort_request(7)}});
  advance(1);
  const std::size_t given_before = marvin.diary.all<Received>().size();
  const std::size_t logged_before = marvin.records.size();

  marvin.host->start(now());

  EXPECT_TRUE(heard_before);
  EXPECT_EQ(given_before, 0U);
  EXPECT_EQ(logged_before, 0U);
  EXPECT_EQ(marvin.diary.samples<wire::TaskRequest>().size(), 1U);
  ASSERT_FALSE(marvin.records.empty());
  EXPECT_EQ(marvin.records[0].at(), now().mission);
}

// It may be killed before it starts, and then nobody would handle it.
TEST_F(Hosts, AnEventIsAcknowledgedOnceTheNodeThatItIsForHasStarted) {
  open("marvin", 2);
  advance(1);
  act("ground", {Send{number("marvin"), abort_request(7), at(60), 31}});
  advance(3);
  const std::size_t delivered_before = (*this)["ground"].diary.all<Delivered>().size();

  (*this)["marvin"].host->start(now());
  advance(3);

  EXPECT_EQ(delivered_before, 0U);
  EXPECT_EQ((*this)["ground"].diary.all<Delivered>().size(), 1U);
  EXPECT_EQ((*this)["marvin"].diary.samples<wire::TaskRequest>().size(), 1U);
}

TEST_F(Hosts, ASampleGoesToTheNodeItIsFor) {
  meet();

  act("ground", {Send{number("marvin"), abort_request(7)}});
  settle();

  const auto received = (*this)["marvin"].diary.all<Received>();
  ASSERT_EQ(received.size(), 1U);
  EXPECT_EQ(received[0].from, number("ground"));
  EXPECT_EQ(std::get<wire::TaskRequest>(received[0].sample).id, 7U);
  EXPECT_TRUE((*this)["heliv"].diary.all<Received>().empty());
}

TEST_F(Hosts, OnboardSamplesPassBetweenAUavAndItsVehicle) {
  meet();
  wire::Telemetry telemetry;
  telemetry.uav = "heliv";

  act("sim", {Send{number("heliv"), telemetry}});
  settle();

  EXPECT_EQ((*this)["heliv"].diary.samples<wire::Telemetry>().size(), 1U);
  EXPECT_TRUE((*this)["marvin"].diary.samples<wire::Telemetry>().empty());
}

TEST_F(Hosts, WorldSamplesReachTheRuntimeAndNotTheNode) {
  wire::Clock clock;
  clock.time = 5;

  (*this)["sim"].host->publish(clock, now());
  settle();

  ASSERT_EQ((*this)["marvin"].world.size(), 1U);
  EXPECT_EQ(std::get<wire::Clock>((*this)["marvin"].world[0]).time, 5);
  EXPECT_TRUE((*this)["marvin"].diary.all<Received>().empty());
}

TEST_F(Hosts, ANodeCanPublishToTheWorld) {
  wire::MissionState state;
  state.finished = true;

  act("ground", {Publish{state}});
  settle();

  ASSERT_EQ((*this)["sim"].world.size(), 1U);
  EXPECT_TRUE(std::get<wire::MissionState>((*this)["sim"].world[0]).finished);
}

TEST_F(Hosts, ReachabilityIsLoggedAndGivenToTheNode) {
  meet();
  set_link("ground", "marvin", false);
  advance(5);

  const std::string last = (*this)["ground"].lines("reach").back();
  EXPECT_NE(last.find(R"("kind":"reach","peer":"marvin","reachable":false})"), std::string::npos);
  const auto known = (*this)["ground"].diary.all<Reachability>();
  ASSERT_EQ(known.size(), 3U);  // both UAVs came, one went
  EXPECT_TRUE(known[0].reachable);
  EXPECT_EQ(known[2].peer, number("marvin"));
  EXPECT_FALSE(known[2].reachable);
}

TEST_F(Hosts, ARestartOfAPeerIsGivenToTheNode) {
  meet();

  stations_.erase("marvin");
  start("marvin", 2);
  advance(1.5);

  const auto known = (*this)["ground"].diary.all<Reachability>();
  ASSERT_EQ(known.size(), 3U);
  EXPECT_TRUE(known.back().restarted);
}

TEST_F(Hosts, MalformedContentIsLoggedOnceAndGoesNoFurther) {
  meet();
  wire::Telemetry wrong;
  wrong.header.origin = number("ground").value();
  wrong.header.incarnation = wrong.header.sequence_number = 1;
  wrong.position.x = std::numeric_limits<float>::quiet_NaN();

  for (int i = 0; i < 3; ++i) hub_.inject("radio/ground>marvin", wrong);
  settle();

  EXPECT_EQ((*this)["marvin"].lines("dropped"),
            (std::vector<std::string>{
                R"({"at":0.2,"node":"marvin","kind":"dropped","slot":"Telemetry",)"
                R"("origin":"ground","field":"position.x","why":"not a finite number"})"}));
  EXPECT_TRUE((*this)["marvin"].diary.all<Received>().empty());
}

TEST_F(Hosts, AnEventThatExpiresIsLoggedAndGivenBackToItsSender) {
  meet();
  set_link("ground", "marvin", false);

  act("ground", {Send{number("marvin"), abort_request(7), at(2)}});
  advance(4);

  const auto lines = (*this)["ground"].lines("expired");
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NE(lines[0].find(R"("slot":"TaskRequest","to":"marvin","sequence":1)"), std::string::npos);
  const auto undelivered = (*this)["ground"].diary.all<Undelivered>();
  ASSERT_EQ(undelivered.size(), 1U);
  EXPECT_EQ(undelivered[0].to, number("marvin"));
  EXPECT_EQ(undelivered[0].slot, wire::Slot::kTaskRequest);
  EXPECT_EQ(undelivered[0].sequence, 1U);
}

TEST_F(Hosts, ItIsSaidOfWhatExpiresWhoAskedAndWhetherItMayHaveArrived) {
  meet();
  set_link("ground", "marvin", false);
  advance(4);

  act("ground",
      {Send{number("marvin"), abort_request(7), now().mission + Duration::seconds(2), 31}});
  advance(4);

  const auto undelivered = (*this)["ground"].diary.all<Undelivered>();
  ASSERT_EQ(undelivered.size(), 1U);
  EXPECT_EQ(undelivered[0].receipt, 31U);
  EXPECT_FALSE(undelivered[0].may_have_arrived);
}

TEST_F(Hosts, WhatIsRefusedThoughAReceiptWasAskedForIsUndeliveredAtOnce) {
  meet();

  act("ground", {Send{number("sim"), abort_request(7), at(60), 31},
                 Send{number("sim"), abort_request(8), at(60)}});

  const auto undelivered = (*this)["ground"].diary.all<Undelivered>();
  ASSERT_EQ(undelivered.size(), 1U);
  EXPECT_EQ(undelivered[0].receipt, 31U);
  EXPECT_EQ(undelivered[0].sequence, 0U);
  EXPECT_FALSE(undelivered[0].may_have_arrived);
  EXPECT_EQ((*this)["ground"].lines("unsent").size(), 2U);
}

TEST_F(Hosts, WithoutTheWorldWhatIsPublishedReachesNobodyAndPeersAreHeardAllTheSame) {
  world = false;
  for (const char* name : {"ground", "marvin"}) start(name, 2);
  meet();
  const std::size_t heard = (*this)["sim"].world.size();

  act("ground", {Publish{wire::MissionState{}}, Send{number("marvin"), abort_request(7)}});
  wire::Clock clock;
  (*this)["sim"].host->publish(clock, now());
  settle();

  EXPECT_EQ((*this)["sim"].world.size(), heard);
  EXPECT_TRUE((*this)["marvin"].world.empty());
  EXPECT_TRUE((*this)["ground"].lines("unsent").empty());
  EXPECT_EQ((*this)["marvin"].diary.samples<wire::TaskRequest>().size(), 1U);
}

TEST_F(Hosts, ASenderThatAskedForAReceiptIsToldThatItsEventIsThere) {
  meet();

  act("ground", {Send{number("marvin"), abort_request(7), at(60), 31},
                 Send{number("marvin"), abort_request(8), at(60)}});
  advance(2);

  const auto delivered = (*this)["ground"].diary.all<Delivered>();
  ASSERT_EQ(delivered.size(), 1U);
  EXPECT_EQ(delivered[0].to, number("marvin"));
  EXPECT_EQ(delivered[0].receipt, 31U);
}

TEST_F(Hosts, WhatTheSenderGaveUpIsLoggedAsLostByTheReceiver) {
  meet();
  set_link("ground", "marvin", false);
  act("ground", {Send{number("marvin"), abort_request(7), at(2)}});
  advance(4);

  set_link("ground", "marvin", true);
  advance(2);

  const auto lines = (*this)["marvin"].lines("lost");
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NE(lines[0].find(R"("to":"marvin","sequence":1,"last":1,"from":"ground")"),
            std::string::npos)
      << lines[0];
  EXPECT_TRUE((*this)["marvin"].diary.samples<wire::TaskRequest>().empty());
}

TEST_F(Hosts, WhatCannotBeSentIsLoggedWithTheReason) {
  meet();
  wire::Telemetry wrong;
  wrong.uav = "\xff";

  act("ground", {Send{number("marvin"), wire::Clock{}}, Send{number("sim"), abort_request(1)},
                 Send{NodeNumber(99), abort_request(1)}, Send{number("marvin"), wrong}});

  const auto lines = (*this)["ground"].lines("unsent");
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_NE(lines[0].find(R"("slot":"Clock","to":"marvin","why":")"), std::string::npos);
  EXPECT_NE(lines[1].find(R"("slot":"TaskRequest","to":"sim")"), std::string::npos);
  EXPECT_NE(lines[2].find(R"("to":"node 99")"), std::string::npos);
  EXPECT_NE(lines[3].find(R"("slot":"Telemetry","to":"marvin")"), std::string::npos);
  EXPECT_TRUE((*this)["ground"].lines("message").empty());
}

TEST_F(Hosts, WhatCannotBePublishedIsLoggedAndStopsNothing) {
  wire::JournalEntry too_long;
  too_long.record.assign(wire::kMaximumString + 1, 'x');
  wire::MissionState state;
  state.phase = "\xff";

  (*this)["ground"].host->publish(too_long, now());
  act("ground", {Publish{state}, Publish{abort_request(1)}});

  const auto lines = (*this)["ground"].lines("unsent");
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_NE(lines[0].find(R"("slot":"JournalEntry","to":"world")"), std::string::npos);
  EXPECT_NE(lines[1].find(R"("slot":"MissionState","to":"world")"), std::string::npos);
  EXPECT_NE(lines[2].find(R"("slot":"TaskRequest","to":"world")"), std::string::npos);
}

TEST_F(Hosts, AWakeupComesWhenMissionTimeIsThereAndOnlyThen) {
  Diary& diary = (*this)["marvin"].diary;
  diary.wakeup = at(1);

  advance(0.9);
  const auto early = diary.all<Wakeup>().size();
  advance(0.2);

  EXPECT_EQ(early, 0U);
  EXPECT_EQ(diary.all<Wakeup>().size(), 1U);
  EXPECT_FALSE((*this)["marvin"].host->next_mission_wakeup());
}

TEST_F(Hosts, EffectsAreCarriedOutInTheirOrder) {
  act("marvin", {Log{Record(at(0), "marvin", "first")},
                 StartJob{5, [](const TimeIsUp&) { return std::any(1); }},
                 Log{Record(at(0), "marvin", "second")}, Finish{}});

  const Station& marvin = (*this)["marvin"];
  ASSERT_EQ(marvin.records.size(), 2U);
  EXPECT_EQ(marvin.records[0].kind(), "first");
  EXPECT_EQ(marvin.records[1].kind(), "second");
  ASSERT_EQ(marvin.jobs.size(), 1U);
  EXPECT_EQ(marvin.jobs[0].id, 5U);
  EXPECT_EQ(marvin.finishes, 1);
}

TEST_F(Hosts, AJobsResultReachesTheNode) {
  (*this)["marvin"].host->job_done({5, std::any(std::string("route"))}, now());

  const auto done = (*this)["marvin"].diary.all<JobDone>();
  ASSERT_EQ(done.size(), 1U);
  EXPECT_EQ(done[0].id, 5U);
  EXPECT_EQ(std::any_cast<std::string>(done[0].result), "route");
}

TEST_F(Hosts, SteppingWithNothingToDoIsNotBusy) {
  meet();

  EXPECT_FALSE((*this)["marvin"].host->step(now()));
}

TEST_F(Hosts, PeersAreAllHeardAfterTheFirstHeartbeats) {
  EXPECT_FALSE((*this)["ground"].host->all_peers_heard());

  meet();

  for (const char* name : {"ground", "sim", "marvin", "heliv"}) {
    EXPECT_TRUE((*this)[name].host->all_peers_heard()) << name;
  }
}

TEST_F(Hosts, APeerThatTheRadioHoldsDownIsNotWaitedFor) {
  (*this)["sim"].host->publish(link(number("ground"), number("marvin"), false), now());
  (*this)["sim"].host->publish(link(number("marvin"), number("ground"), false), now());
  meet();

  EXPECT_TRUE((*this)["ground"].host->all_peers_heard());
  EXPECT_TRUE((*this)["ground"].diary.all<Reachability>().size() == 1);
}

TEST_F(Hosts, AChannelThatCannotBeOpenedIsAFailure) {
  class Refusing final : public blackboard::Transport {
   public:
    Result<void, Failure> open(const blackboard::TransportPlan&) override {
      return failure("no such interface");
    }
    bool write(std::size_t, const wire::Sample&) override { return false; }
    Result<void, Failure> set_up(std::size_t, bool) override { return {}; }
    std::vector<blackboard::Arrival> take() override { return {}; }
    void on_arrival(std::function<void()>) override {}
  } transport;
  Diary diary;

  const auto host = Host::open(roster_, *roster_.find("marvin"), std::make_unique<FakeNode>(diary),
                               transport, {}, {});

  ASSERT_FALSE(host.has_value());
  EXPECT_EQ(host.error().why, "no such interface");
}

}  // namespace
}  // namespace skein::node
