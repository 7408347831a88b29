// SPDX-License-Identifier: Apache-2.0
// Operators' requests and boards over the wire's types.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <utility>

#include "skein/translation/sensing.hpp"
#include "testing/station.hpp"

namespace skein::ground {
namespace {

namespace gs = ground_station;
using testing::at;
using testing::Station;

/// Reads one word as a UAV to take in hand; everything else is wrong in two ways.
Result<std::vector<gs::OperatorDeed>, std::vector<std::string>> read_name(const std::string& text) {
  if (text == "marvin" || text == "heliv") {
    return std::vector<gs::OperatorDeed>{gs::Action(gs::TakeInHand{text, false})};
  }
  return tl::unexpected(std::vector<std::string>{"not a UAV", "not a name either"});
}

wire::OperatorRequest request(std::uint64_t number, const std::string& text) {
  wire::OperatorRequest request;
  request.who = "ada";
  request.number = number;
  request.request = text;
  return request;
}

wire::Telemetry telemetry(double x) {
  wire::Telemetry sample;
  sample.uav = "marvin";
  sample.position = {static_cast<float>(x), 0, 50};
  sample.airborne = true;
  return sample;
}

TEST(OperatorRequests, BecomeCommandsAndAreAnsweredAtOnceAndAtTheirEnd) {
  Station station({}, 3, read_name);

  station.from("operator", request(1, "marvin"), 1);

  ASSERT_EQ(station.sent<wire::DegreeCommand>().size(), 1U);
  const auto asked = station.published<wire::OperatorReply>();
  ASSERT_EQ(asked.size(), 1U);
  EXPECT_TRUE(asked[0].accepted);
  EXPECT_FALSE(asked[0].complete);
  ASSERT_EQ(asked[0].commands.size(), 1U);
  EXPECT_EQ(station.records("asked").size(), 1U);
  EXPECT_EQ(station.records("hand")[0].text("holder"), "ada");

  wire::RequestReply reply;
  reply.command = asked[0].commands[0].command;
  reply.accepted = true;
  station.from("marvin", reply, 2);

  const auto ended = station.published<wire::OperatorReply>();
  ASSERT_EQ(ended.size(), 1U);
  EXPECT_TRUE(ended[0].complete);
  EXPECT_EQ(ended[0].commands[0].state, wire::CommandState::kAcknowledged);
  EXPECT_EQ(ended[0].commands[0].settled, at(2).count());
}

TEST(OperatorRequests, ThatSayNothingOfSenseAreRefusedWithEveryReason) {
  Station station({}, 3, read_name);

  station.from("operator", request(1, "karma?"), 1);

  const auto replies = station.published<wire::OperatorReply>();
  ASSERT_EQ(replies.size(), 1U);
  EXPECT_FALSE(replies[0].accepted);
  EXPECT_TRUE(replies[0].complete);
  EXPECT_THAT(replies[0].problems, ::testing::ElementsAre("not a UAV", "not a name either"));
}

TEST(OperatorRequests, ComeFromOperatorsOnly) {
  Station station({}, 3, read_name);

  station.from("marvin", request(1, "heliv"), 1);
  EXPECT_TRUE(station.published<wire::OperatorReply>().empty());
  EXPECT_EQ(station.records("dropped").size(), 1U);
  station.from_stranger(request(2, "heliv"), 1);
  EXPECT_TRUE(station.published<wire::OperatorReply>().empty());
}

TEST(OperatorBoards, TellOfEveryUavAndTheMissionOnceSomethingHappened) {
  Station station;

  station.from("marvin", telemetry(10), 1);

  ASSERT_EQ(station.published<wire::UavBoard>().size(), 2U);
  EXPECT_EQ(station.published<wire::UavBoard>()[0].uav, "marvin");
  EXPECT_EQ(station.published<wire::UavBoard>()[0].position.x, 10);
  EXPECT_EQ(station.published<wire::UavBoard>()[1].located_at, wire::kNoInstant);
  EXPECT_EQ(station.published<wire::UavTasks>().size(), 2U);
  ASSERT_EQ(station.published<wire::GroundBoard>().size(), 1U);
  EXPECT_THAT(station.published<wire::GroundBoard>()[0].uavs,
              ::testing::ElementsAre("marvin", "heliv"));
}

TEST(OperatorBoards, TellOnlyWhatChangedAndNotMoreOftenThanTheirPeriod) {
  Station station;
  station.from("marvin", telemetry(10), 1);

  station.from("marvin", telemetry(11), 1.1);
  EXPECT_TRUE(station.all<node::Publish>().empty());
  EXPECT_EQ(station.node().next_wakeup(), at(1.5));

  station.give(node::Wakeup{}, 1.5);
  ASSERT_EQ(station.all<node::Publish>().size(), 1U);
  EXPECT_EQ(station.published<wire::UavBoard>()[0].position.x, 11);
  EXPECT_EQ(station.node().next_wakeup(), std::nullopt);
}

using Boards = std::map<std::pair<wire::Slot, std::uint32_t>, wire::Sample>;

void note(const Station& station, Boards& last) {
  for (const node::Publish& one : station.all<node::Publish>())
    last[{wire::slot_of(one.sample), wire::header_of(one.sample).instance}] = one.sample;
}

/// Some seconds of Marvin, until nothing is due; gives the boards that were told last.
Boards live(Station& station) {
  Boards last;
  for (int i = 0; i < 40; ++i) {
    station.from("marvin", telemetry(i), 1 + 0.2 * i);
    note(station, last);
    wire::TaskEvent event;
    event.uav = "marvin";
    event.id = static_cast<std::uint64_t>(1 + i / 4);
    event.type = "goto";
    event.state = static_cast<wire::TaskState>(i % 4);
    station.from("marvin", event, 1.1 + 0.2 * i);
    note(station, last);
  }
  station.give(node::Wakeup{}, 10);
  note(station, last);
  return last;
}

TEST(OperatorBoards, AreNotMadeWhileALifeIsLivedAgainAndAllAreToldAtItsEnd) {
  Station lived, again;
  const Boards last = live(lived);

  again.node().begin_recall();
  EXPECT_TRUE(live(again).empty());
  Boards told;
  for (const node::Effect& effect : again.node().end_recall()) {
    const wire::Sample& board = std::get<node::Publish>(effect).sample;
    told[{wire::slot_of(board), wire::header_of(board).instance}] = board;
  }

  EXPECT_EQ(told.size(), 5U);  // two UAVs, their tasks, the ground station
  EXPECT_TRUE(told == last);
  EXPECT_EQ(again.node().next_wakeup(), lived.node().next_wakeup());
  again.from("marvin", telemetry(40), 11);
  EXPECT_EQ(again.published<wire::UavBoard>().size(), 1U);  // what was told is not told twice
  EXPECT_TRUE(again.published<wire::UavTasks>().empty());
}

TEST(OperatorBoards, OfALifeInWhichNoneWasDueAreNotTold) {
  Station again;
  again.node().begin_recall();

  EXPECT_TRUE(again.node().end_recall().empty());
}

}  // namespace
}  // namespace skein::ground
