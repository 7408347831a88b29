// SPDX-License-Identifier: Apache-2.0
#include "agenda.hpp"

#include <gtest/gtest.h>

namespace skein::interaction {
namespace {

class AnAgenda : public ::testing::Test {
 protected:
  static MissionTime at(double seconds) { return MissionTime::seconds(seconds); }

  Agenda agenda{3};
};

TEST_F(AnAgenda, IsEmptyUntilSomethingIsSet) {
  EXPECT_EQ(agenda.next(), std::nullopt);
  EXPECT_EQ(agenda.take(at(0)), std::nullopt);
  agenda.clear(1);
  EXPECT_EQ(agenda.next(), std::nullopt);
}

TEST_F(AnAgenda, GivesTheTimersOfOneInstantInTheirOrder) {
  agenda.set(2, at(5));
  agenda.set(0, at(5));
  agenda.set(1, at(7));
  EXPECT_EQ(agenda.next(), at(5));
  EXPECT_EQ(agenda.take(at(7)), std::nullopt) << "it is not the first";
  EXPECT_EQ(agenda.take(at(5)), 0U);
  EXPECT_EQ(agenda.take(at(5)), 2U);
  EXPECT_EQ(agenda.take(at(5)), std::nullopt);
  EXPECT_EQ(agenda.next(), at(7));
}

TEST_F(AnAgenda, ATimerHasOneInstant) {
  agenda.set(1, at(5));
  agenda.set(1, at(9));
  EXPECT_EQ(agenda.next(), at(9));
  agenda.clear(1);
  EXPECT_EQ(agenda.next(), std::nullopt);
}

}  // namespace
}  // namespace skein::interaction
