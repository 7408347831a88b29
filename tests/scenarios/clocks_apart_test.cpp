// SPDX-License-Identifier: Apache-2.0
// What is made up for in logs of several processes is no more than the turn that a death cut off.
#include "testing/clocks_apart.hpp"

#include <gtest/gtest.h>

namespace skein::testing {
namespace {

using Log = std::vector<journal::Record>;
constexpr double kRate = 20;

journal::Record message(double at, const char* node, std::int64_t sequence, const char* direction) {
  return journal::Record(MissionTime::seconds(at), node, "message")
      .with("slot", "Alarm")
      .with("from", "ground")
      .with("to", "heliv")
      .with("sequence", sequence)
      .with("direction", direction);
}
journal::Record sent(double at, std::int64_t sequence) {
  return message(at, "ground", sequence, "sent");
}
journal::Record received(double at, std::int64_t sequence) {
  return message(at, "heliv", sequence, "received");
}
journal::Record fault(double at, const char* what) {
  return journal::Record(MissionTime::seconds(at), "runner", "fault")
      .with("what", what)
      .with("target", "ground");
}
journal::Record resumed(double at) {
  return journal::Record(MissionTime::seconds(at), "ground", "resumed").with("from", at - 60);
}
std::string breaches(const Log& log) {
  return breaches_beyond_clocks(with_last_messages(log, kRate), kRate);
}

TEST(LastMessages, OfATurnThatDeathCutOffAreMadeUpForWhereOthersFollow) {
  EXPECT_EQ(breaches({sent(300, 4), received(300.3, 4), fault(446, "kill"), received(446.3, 5),
                      resumed(513), sent(514, 6), received(514.3, 6)}),
            "");
}

TEST(LastMessages, OfATurnThatDeathCutOffAreMadeUpForWhereNothingFollows) {
  EXPECT_EQ(breaches({sent(300, 4), received(300.3, 4), fault(446, "kill"), received(446.3, 5),
                      resumed(513)}),
            "");
  EXPECT_EQ(breaches({sent(300, 4), received(300.3, 4), fault(446, "kill"), resumed(513),
                      received(513.3, 5)}),
            "")
      << "its next life sent it";
}

TEST(LastMessages, OfNobodyAreNotMadeUpFor) {
  EXPECT_NE(breaches({sent(300, 4), received(300.3, 4), received(446.3, 5)}), "") << "none died";
  EXPECT_NE(breaches({sent(300, 4), received(300.3, 4), fault(446, "kill"), resumed(513),
                      received(600, 5)}),
            "")
      << "long after";
  EXPECT_NE(breaches({sent(300, 4), received(300.3, 4), fault(446, "kill"), received(446.3, 6),
                      resumed(513)}),
            "")
      << "not the next one";
}

}  // namespace
}  // namespace skein::testing
