// SPDX-License-Identifier: Apache-2.0
#include "commands.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mav.hpp"

namespace skein::autopilot {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr mavlink::Address kOwn{245, 191};
constexpr mavlink::Address kAutopilot{1, 1};
Duration at(double seconds) { return Duration::seconds(seconds); }

mavlink::CommandLong a_command(std::uint16_t command, float param1 = 0) {
  mavlink::CommandLong one;
  one.command = command;
  one.param1 = param1;
  one.target_system = one.target_component = 1;
  return one;
}

class CommandsTest : public ::testing::Test {
 protected:
  /// What was sent since the last call: command and confirmation.
  std::vector<std::pair<int, int>> sent() {
    std::vector<std::pair<int, int>> all;
    mavlink::Parser parser;
    for (const Effect& effect : out_.take()) {
      for (const auto& frame : parser.take(std::get<Transmit>(effect).bytes)) {
        const auto message = mavlink::to_message(frame);
        const auto& command = std::get<mavlink::CommandLong>(*message);
        all.emplace_back(command.command, command.confirmation);
      }
    }
    return all;
  }
  std::vector<Commands::Outcome> hear(std::uint16_t command, std::uint8_t result, double seconds,
                                      std::uint8_t target = 0) {
    mavlink::CommandAck ack;
    ack.command = command;
    ack.result = result;
    ack.target_system = target;
    return commands_.hear(ack, kAutopilot, at(seconds), out_);
  }

  Outbox out_{kOwn};
  Commands commands_{kOwn};
};

TEST_F(CommandsTest, AreSentAgainUntilTheyAreAnswered) {
  commands_.ask(a_command(400), at(0), out_);
  EXPECT_THAT(sent(), ElementsAre(std::pair(400, 0)));
  EXPECT_THAT(commands_.step(at(0.4), out_), IsEmpty());
  EXPECT_THAT(sent(), IsEmpty());
  EXPECT_THAT(commands_.step(at(0.5), out_), IsEmpty());
  EXPECT_THAT(sent(), ElementsAre(std::pair(400, 1)));

  const auto outcomes = hear(400, mav::kAccepted, 0.6);

  ASSERT_THAT(outcomes, SizeIs(1));
  EXPECT_TRUE(outcomes[0].accepted);
  EXPECT_THAT(commands_.step(at(10), out_), IsEmpty());
  EXPECT_THAT(sent(), IsEmpty());
}

TEST_F(CommandsTest, AfterFiveTimesThereIsNoAnswer) {
  const auto ticket = commands_.ask(a_command(22), at(0), out_);
  std::vector<Commands::Outcome> outcomes;
  for (int i = 1; i <= 5 && outcomes.empty(); ++i) outcomes = commands_.step(at(i * 0.5), out_);

  EXPECT_THAT(sent(), SizeIs(5));
  ASSERT_THAT(outcomes, SizeIs(1));
  EXPECT_EQ(outcomes[0].ticket, ticket);
  EXPECT_EQ(outcomes[0].why, "the autopilot did not answer NAV_TAKEOFF");
}

TEST_F(CommandsTest, ARefusalSaysWhatWasRefused) {
  commands_.ask(a_command(400), at(0), out_);

  const auto outcomes = hear(400, 2, 0.1);

  ASSERT_THAT(outcomes, SizeIs(1));
  EXPECT_EQ(outcomes[0].why, "the autopilot answered COMPONENT_ARM_DISARM by 'denied'");
}

TEST_F(CommandsTest, AnswersHaveNoNumberSoOneOfAKindIsUnderWay) {
  const auto first = commands_.ask(a_command(511, 33), at(0), out_);
  const auto second = commands_.ask(a_command(511, 30), at(0), out_);
  commands_.ask(a_command(400), at(0), out_);
  EXPECT_THAT(sent(), ElementsAre(std::pair(511, 0), std::pair(400, 0)));

  EXPECT_EQ(hear(511, 0, 0.1).at(0).ticket, first);
  EXPECT_THAT(sent(), ElementsAre(std::pair(511, 0)));
  EXPECT_EQ(hear(511, 0, 0.2).at(0).ticket, second);
}

TEST_F(CommandsTest, AModeThatIsReplacedIsNotSentAgain) {
  commands_.ask(a_command(176, 1), at(0), out_);
  const auto second = commands_.ask(a_command(176, 2), at(0.1), out_);
  EXPECT_THAT(sent(), SizeIs(1));

  EXPECT_THAT(commands_.step(at(0.5), out_), SizeIs(1));
  EXPECT_THAT(sent(), SizeIs(1)) << "the second";
  EXPECT_EQ(hear(176, 0, 0.6).at(0).ticket, second);
}

TEST_F(CommandsTest, InProgressIsWaitedForAndBusyIsTriedAgain) {
  commands_.ask(a_command(22), at(0), out_);
  EXPECT_THAT(hear(22, mav::kInProgress, 0.1), IsEmpty());
  EXPECT_THAT(commands_.step(at(9), out_), IsEmpty());
  EXPECT_THAT(sent(), SizeIs(1));
  EXPECT_THAT(hear(22, mav::kTemporarilyRejected, 9.5), IsEmpty());
  EXPECT_THAT(commands_.step(at(10.5), out_), IsEmpty());
  EXPECT_THAT(sent(), SizeIs(1));
}

TEST_F(CommandsTest, AnswersToOthersMeanNothing) {
  commands_.ask(a_command(400), at(0), out_);

  EXPECT_THAT(hear(400, 0, 0.1, 255), IsEmpty());
  EXPECT_THAT(hear(22, 0, 0.1), IsEmpty());
  EXPECT_THAT(hear(400, 0, 0.1, 245), SizeIs(1));
}

TEST_F(CommandsTest, DroppedOnesAreSilent) {
  commands_.ask(a_command(400), at(0), out_);
  (void)sent();
  commands_.drop();

  EXPECT_THAT(commands_.step(at(5), out_), IsEmpty());
  EXPECT_THAT(hear(400, 0, 5), IsEmpty());
  EXPECT_THAT(sent(), IsEmpty());
}

}  // namespace
}  // namespace skein::autopilot
