// SPDX-License-Identifier: Apache-2.0
#include "skein/ground/inbox.hpp"

#include <gtest/gtest.h>

namespace skein::ground {
namespace {

namespace gs = ground_station;

class AnInbox : public ::testing::Test {
 protected:
  node::NodeNumber number(const char* name) const { return roster.find(name)->number; }
  Inbox::Read read(node::NodeNumber from, wire::Sample sample) {
    return inbox.read(node::Received{from, std::move(sample)}, MissionTime::seconds(5));
  }
  template <class Meaning>
  static Meaning as(const Inbox::Read& read) {
    const Meaning* meaning = read.input ? std::get_if<Meaning>(&*read.input) : nullptr;
    if (meaning == nullptr) ADD_FAILURE() << "it means something else, or nothing";
    return meaning == nullptr ? Meaning() : *meaning;
  }

  node::Roster roster{{"marvin", "heliv"}};
  Inbox inbox{roster,
              [](const std::string& text)
                  -> Result<std::vector<gs::OperatorDeed>, std::vector<std::string>> {
                if (text == "[]") return std::vector<gs::OperatorDeed>();
                return tl::unexpected(std::vector<std::string>{"not that", "nor that"});
              }};
};

TEST_F(AnInbox, KnowsAUavByItsNodeWhateverNameTheSampleGives) {
  wire::Telemetry telemetry;
  telemetry.uav = "heliv";
  wire::PerceptionReport look;
  look.uav = "somebody";
  wire::Sighting sighting;
  sighting.uav = "somebody";
  wire::PlanBoard board;
  board.uav = "heliv";

  EXPECT_EQ(as<gs::PerceptionReceived>(read(number("marvin"), sighting)).perception.uav, "marvin");
  EXPECT_EQ(as<world::Telemetry>(read(number("marvin"), telemetry)).uav, "marvin");
  EXPECT_EQ(as<gs::PerceptionReceived>(read(number("marvin"), look)).perception.uav, "marvin");
  EXPECT_EQ(as<gs::PlanBoardReceived>(read(number("marvin"), board)).uav, "marvin");
}

TEST_F(AnInbox, RefusesWhatComesFromNoUavOnceForEachSenderAndSlot) {
  const auto first = read(node::NodeNumber(77), wire::Telemetry());

  EXPECT_FALSE(first.input);
  ASSERT_TRUE(first.refusal);
  EXPECT_EQ(first.refusal->kind(), "dropped");
  EXPECT_EQ(first.refusal->text("why"), "not a UAV of this mission");
  EXPECT_FALSE(read(node::NodeNumber(77), wire::Telemetry()).refusal) << "said already";
  EXPECT_TRUE(read(node::NodeNumber(77), wire::TaskEvent()).refusal) << "another slot";
  EXPECT_TRUE(read(node::NodeNumber(78), wire::Telemetry()).refusal) << "another sender";
  EXPECT_TRUE(read(number("sim"), wire::Telemetry()).refusal) << "the simulator is no UAV";
}

TEST_F(AnInbox, TakesTheAnswerToACommandFromItsAddresseeOnly) {
  inbox.sent(7, number("marvin"));
  wire::RequestReply reply;
  reply.command = 7;
  reply.accepted = true;

  EXPECT_FALSE(read(number("heliv"), reply).input);
  EXPECT_TRUE(as<gs::RequestReplyReceived>(read(number("marvin"), reply)).accepted);
  inbox.sent(7, number("heliv"));
  EXPECT_FALSE(read(number("marvin"), reply).input) << "the number was given anew";
}

TEST_F(AnInbox, KnowsTheAddresseesOfTheLastCommands) {
  for (std::uint64_t command = 1; command <= 3 * Inbox::kAddressees; ++command)
    inbox.sent(command, number("marvin"));
  wire::RequestReply reply;
  reply.command = 2 * Inbox::kAddressees + 1;

  EXPECT_FALSE(read(number("heliv"), reply).input);
  reply.command = 1;
  EXPECT_TRUE(read(number("heliv"), reply).input) << "nobody waits for it any more";
}

TEST_F(AnInbox, TakesRequestsOfOperatorsFromNobodyElse) {
  wire::OperatorRequest request;
  request.who = "ada";
  request.number = 3;
  request.request = "[]";

  EXPECT_FALSE(read(number("marvin"), request).input);
  EXPECT_TRUE(as<gs::OperatorRequest>(read(roster.operators(), request)).problems.empty());
}

TEST_F(AnInbox, HandsOnWhyARequestCannotBeRead) {
  wire::OperatorRequest request;
  request.request = "gibberish";

  EXPECT_EQ(as<gs::OperatorRequest>(read(roster.operators(), request)).problems,
            (std::vector<std::string>{"not that", "nor that"}));
}

TEST_F(AnInbox, TellsWhoIsHeardAndWhatWasDelivered) {
  const auto reach = inbox.read(node::Reachability{number("heliv"), true, false}, MissionTime());
  const auto other = inbox.read(node::Reachability{number("sim"), true, false}, MissionTime());
  const auto delivered = inbox.read(node::Delivered{number("heliv"), 9}, MissionTime());

  EXPECT_EQ(as<gs::PeerReachable>(reach).uav, "heliv");
  EXPECT_FALSE(other.input);
  EXPECT_EQ(as<gs::CommandDelivered>(delivered).command, gs::CommandNumber(9));
}

}  // namespace
}  // namespace skein::ground
