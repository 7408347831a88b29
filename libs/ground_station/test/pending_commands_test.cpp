// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/pending_commands.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/builders.hpp"

namespace skein::ground_station {
namespace {

using testing::abort_of;
using testing::at;
using ::testing::ElementsAre;
using testing::id;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using testing::start_of;

PendingCommands with_grace() { return PendingCommands(Duration::seconds(5)); }

IssueCommand to(const std::string& uav, Request request, double expires = 100) {
  return {uav, std::move(request), at(expires), "anna"};
}

TEST(PendingCommands, AreNumberedAndKeptUntilTheyAreTaken) {
  PendingCommands commands = with_grace();
  const CommandNumber first = commands.issue(to("marvin", start_of(3)));
  const CommandNumber second = commands.issue(to("marvin", start_of(4)));
  EXPECT_EQ(first, CommandNumber(1));
  EXPECT_EQ(second, CommandNumber(2));
  ASSERT_NE(commands.find(first), nullptr);
  EXPECT_EQ(commands.find(first)->asked_by, "anna");

  EXPECT_TRUE(commands.take(first).has_value());

  EXPECT_FALSE(commands.take(first).has_value());
  EXPECT_EQ(commands.find(first), nullptr);
  EXPECT_NE(commands.find(second), nullptr);
}

TEST(PendingCommands, AreDeliveredOnceAndNotAfterTheyAreOver) {
  PendingCommands commands = with_grace();
  const CommandNumber number = commands.issue(to("marvin", start_of(3)));
  const CommandNumber over = commands.issue(to("marvin", start_of(4)));
  commands.take(over);

  const auto delivered = commands.deliver(number);

  ASSERT_TRUE(delivered.has_value());
  EXPECT_EQ(delivered->state, CommandState::kDelivered);
  EXPECT_EQ(delivered->what, "START 3 goto");
  EXPECT_EQ(delivered->task, id(3));
  EXPECT_FALSE(commands.deliver(number).has_value());
  EXPECT_FALSE(commands.deliver(over).has_value());
}

TEST(PendingCommands, AreGivenUpInTheOrderOfTheirExpiryAndOnlyAfterTheGrace) {
  PendingCommands commands = with_grace();
  EXPECT_EQ(commands.next_wakeup(), std::nullopt);
  commands.issue(to("marvin", start_of(3), 20));
  const CommandNumber sooner = commands.issue(to("heliv", start_of(3), 10));

  EXPECT_EQ(commands.next_wakeup(), at(15));
  EXPECT_EQ(commands.given_up(at(14)), std::nullopt);
  EXPECT_EQ(commands.given_up(at(30)), sooner);
  commands.take(sooner);
  EXPECT_EQ(commands.next_wakeup(), at(25));
}

TEST(PendingCommands, ToldOfAUavAreItsOwnInTheOrderOfTheirIssue) {
  PendingCommands commands = with_grace();
  const CommandNumber first = commands.issue(to("marvin", start_of(9)));
  commands.issue(to("heliv", start_of(4)));
  const CommandNumber second = commands.issue(to("marvin", abort_of(5)));

  const auto of_marvin = commands.of("marvin");

  ASSERT_THAT(of_marvin, SizeIs(2));
  EXPECT_EQ(of_marvin[0].first, first);
  EXPECT_EQ(of_marvin[1].first, second);
  EXPECT_THAT(commands.started_for("marvin"), ElementsAre(id(9)));
  EXPECT_THAT(commands.started_for("karma"), IsEmpty());
}

TEST(PendingCommands, TheLastChangeOfDegreeAmongThoseThatWaitCounts) {
  PendingCommands commands = with_grace();
  const CommandNumber start = commands.issue(to("marvin", start_of(9)));
  const CommandNumber down = commands.issue(to("marvin", mission::ChangeDegree{1}));
  const CommandNumber up = commands.issue(to("marvin", mission::ChangeDegree{4}));

  EXPECT_EQ(commands.last_degree_of({start}), std::nullopt);
  EXPECT_EQ(commands.last_degree_of({down, up, start}), 4);
  commands.take(up);
  EXPECT_EQ(commands.last_degree_of({down, up, start}), 1);
}

}  // namespace
}  // namespace skein::ground_station
