// SPDX-License-Identifier: Apache-2.0
// Logs of nodes whose clocks differ are put in the order of cause and effect.
#include "by_cause.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/journal/lines/execution.hpp"
#include "skein/journal/lines/radio.hpp"
#include "skein/journal/lines/truth.hpp"

namespace skein::laws {
namespace {

using journal::Record;
using ::testing::ElementsAre;

const Duration kSkew = Duration::seconds(1);

Record message(double at, const std::string& direction, std::uint64_t sequence = 7) {
  return journal::record_of(MissionTime::seconds(at), direction == "sent" ? "heliv" : "karma",
                            journal::lines::Message{.slot = "Decision",
                                                    .from = "heliv",
                                                    .to = "karma",
                                                    .sequence = sequence,
                                                    .direction = direction});
}

Record sync(double at, const std::string& direction) {
  return journal::record_of(
      MissionTime::seconds(at), direction == "sent" ? "heliv" : "karma",
      journal::lines::Sync{.id = 3, .from = "heliv", .to = "karma", .direction = direction});
}

Record restart(double at) {
  return journal::record_of(MissionTime::seconds(at), "runner",
                            journal::lines::Fault{.what = "restart", .target = "heliv"});
}

TEST(ByCause, WhatIsInOrderStays) {
  const std::vector<Record> log{message(1, "sent"), message(2, "received"), sync(2, "sent"),
                                sync(2.5, "received")};

  EXPECT_EQ(by_cause(log, kSkew), log);
}

TEST(ByCause, WhatIsReceivedBeforeItWasSentComesRightAfterIt) {
  EXPECT_THAT(
      by_cause({message(1, "received"), message(1.2, "sent"), message(1.3, "sent", 8)}, kSkew),
      ElementsAre(message(1.2, "sent"), message(1.2, "received"), message(1.3, "sent", 8)));
  EXPECT_THAT(by_cause({sync(1, "received"), sync(1.5, "sent")}, kSkew),
              ElementsAre(sync(1.5, "sent"), sync(1.5, "received")));
}

TEST(ByCause, OfOneInstantTheSendingComesFirst) {
  EXPECT_THAT(by_cause({message(0, "received"), message(0, "sent")}, kSkew),
              ElementsAre(message(0, "sent"), message(0, "received")));
}

TEST(ByCause, MessagesKeepTheOrderInWhichTheyWereSent) {
  EXPECT_THAT(by_cause({message(1, "received", 1), message(1, "received", 2),
                        message(1.1, "sent", 1), message(1.2, "sent", 2)},
                       kSkew),
              ElementsAre(message(1.1, "sent", 1), message(1.1, "received", 1),
                          message(1.2, "sent", 2), message(1.2, "received", 2)));
}

TEST(ByCause, NoClocksDifferByMoreThanThat) {
  const std::vector<Record> log{message(1, "received"), message(2.5, "sent")};

  EXPECT_EQ(by_cause(log, kSkew), log);
}

TEST(ByCause, WhatASenderSaidInAnEarlierLifeIsNotItsCause) {
  EXPECT_THAT(
      by_cause({message(1, "sent"), restart(5), message(9, "received"), message(9.5, "sent")},
               kSkew),
      ElementsAre(message(1, "sent"), restart(5), message(9.5, "sent"), message(9.5, "received")));
}

}  // namespace
}  // namespace skein::laws
