// SPDX-License-Identifier: Apache-2.0
#include "skein/journal/hand_on.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/journal/lines/mission.hpp"
#include "skein/journal/lines/truth.hpp"

namespace skein::journal {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Who hears of phases and faults.
struct Listener {
  void hear(const lines::Phase& line, const Written& when) {
    heard.push_back("phase " + line.name + " by " + when.node);
  }
  void hear(const lines::Fault& line, const Written& when) {
    heard.push_back("fault " + line.what + " at " + to_text(when.at));
  }
  bool take(const Record& record) { return hand_on<lines::Phase, lines::Fault>(record, *this); }

  std::vector<std::string> heard;
};

const MissionTime kAt = MissionTime::seconds(2);

TEST(HandOn, GivesALineToWhoTakesItsKind) {
  Listener listener;

  EXPECT_TRUE(listener.take(record_of(kAt, "ground", lines::Phase{.name = "search"})));
  EXPECT_TRUE(
      listener.take(record_of(kAt, "sim", lines::Fault{.what = "kill", .target = "marvin"})));

  EXPECT_THAT(listener.heard, ElementsAre("phase search by ground", "fault kill at 2"));
}

TEST(HandOn, PassesOverOtherKinds) {
  Listener listener;

  EXPECT_TRUE(listener.take(record_of(kAt, "ground", lines::Step{.name = "one"})));
  EXPECT_TRUE(listener.take(Record(kAt, "ground", "of no kind")));

  EXPECT_THAT(listener.heard, IsEmpty());
}

TEST(HandOn, SaysWhenALineLacksWhatItMustHaveOrHasItInAnotherShape) {
  Listener listener;

  EXPECT_FALSE(listener.take(Record(kAt, "sim", "fault").with("what", "kill")));
  EXPECT_FALSE(listener.take(Record(kAt, "sim", "phase").with("name", 3)));

  EXPECT_THAT(listener.heard, IsEmpty());
}

}  // namespace
}  // namespace skein::journal
