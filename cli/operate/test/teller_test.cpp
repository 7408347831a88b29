// SPDX-License-Identifier: Apache-2.0
#include "../src/teller.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace skein::operate_tool {
namespace {

using wire::CommandState;

wire::OperatorReply reply(CommandState state, const char* why = "") {
  wire::OperatorReply reply;
  wire::CommandEntry command;
  command.command = 7;
  command.uav = "marvin";
  command.what = "DEGREE 1";
  command.state = state;
  command.why = why;
  reply.commands = {command};
  return reply;
}

TEST(Teller, SaysEachStateOfACommandOnce) {
  std::ostringstream out;
  Teller teller(out);

  teller.tell(reply(CommandState::kIssued));
  teller.tell(reply(CommandState::kIssued));
  teller.tell(reply(CommandState::kDelivered));
  teller.tell(reply(CommandState::kAcknowledged));

  EXPECT_EQ(out.str(),
            "marvin: DEGREE 1: issued\nmarvin: DEGREE 1: delivered\n"
            "marvin: DEGREE 1: acknowledged\n");
}

TEST(Teller, SaysWhatAReplyPassedOver) {
  std::ostringstream out;

  Teller(out).tell(reply(CommandState::kAcknowledged));

  EXPECT_EQ(out.str(),
            "marvin: DEGREE 1: issued\nmarvin: DEGREE 1: delivered\n"
            "marvin: DEGREE 1: acknowledged\n");
}

TEST(Teller, DoesNotSayOfWhatEndedOtherwiseThatItWasDelivered) {
  std::ostringstream out;

  Teller(out).tell(reply(CommandState::kExpired, "no answer"));

  EXPECT_EQ(out.str(), "marvin: DEGREE 1: issued\nmarvin: DEGREE 1: expired: no answer\n");
}

TEST(Teller, SaysOnceThatWhatNeedsNoCommandIsDone) {
  std::ostringstream out;
  Teller teller(out);
  wire::OperatorReply reply;
  reply.accepted = true;
  teller.tell(reply);
  EXPECT_EQ(out.str(), "") << "accepted, not carried out";

  reply.complete = true;
  teller.tell(reply);
  teller.tell(reply);

  EXPECT_EQ(out.str(), "done\n");
}

TEST(Teller, DoesNotSayThatWhatWasRefusedIsDone) {
  std::ostringstream out;
  wire::OperatorReply reply;
  reply.complete = true;

  Teller(out).tell(reply);
  EXPECT_EQ(out.str(), "");

  reply.accepted = true;
  reply.problems = {"no plan of 'marvin' is held"};
  Teller(out).tell(reply);
  EXPECT_EQ(out.str(), "");
}

}  // namespace
}  // namespace skein::operate_tool
