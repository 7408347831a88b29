// SPDX-License-Identifier: Apache-2.0
#include "interaction/area_mapping.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/scouting.hpp"

namespace skein::decision_node {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class FieldMapping : public ::testing::Test {
 protected:
  void takes_all() { mapping_.share().take({course_.host.config().world->zones[0].polygon}); }

  testing::ScoutingCourse course_;
  AreaMapping mapping_{course_.surroundings(), course_};
};

TEST_F(FieldMapping, FailsBeforeTheAreaIsShared) {
  mapping_.map("sweep");

  EXPECT_THAT(course_.failed, ElementsAre("sweep: the area is not shared"));
  EXPECT_THAT(course_.given, IsEmpty());
}

TEST_F(FieldMapping, IsAFlightAndALookAlongIt) {
  takes_all();

  mapping_.map("sweep");

  ASSERT_THAT(course_.given, SizeIs(2));
  EXPECT_EQ(course_.given[0].task.type, "goto");
  EXPECT_EQ(course_.given[0].along, std::nullopt);
  EXPECT_EQ(course_.given[1].along, course_.given[0].task.id);
  EXPECT_THAT(course_.told, IsEmpty()) << "it runs when the executive says so";
}

TEST_F(FieldMapping, HasEndedWhereNothingIsLeft) {
  takes_all();
  mapping_.map("sweep");
  mapping_.share().flown();

  mapping_.map("sweep");

  EXPECT_THAT(course_.told, ElementsAre("sweep ended"));
  EXPECT_THAT(course_.given, SizeIs(2));
}

// Found by random missions (--sharing 118): the role was about to begin its loop anew, and was not
// told once it had.
TEST_F(FieldMapping, WhatHasNoOwnerIsSharedBeforeTheRoleIsDone) {
  mapping_.share().agree({interaction::row_of("heliv", {{0, 0}, {100, 0}, {100, 200}, {0, 200}})});
  mapping_.share().lose("heliv");

  mapping_.map("sweep");

  EXPECT_THAT(course_.told, ElementsAre("member lost", "sweep ended"));
}

TEST_F(FieldMapping, WhatIsFlownOverIsLeftNoMore) {
  takes_all();
  mapping_.map("sweep");
  const double all = mapping_.share().area_left();
  const auto way = course_.way_of(course_.given[0]);
  ASSERT_THAT(way, SizeIs(::testing::Ge(3U)));

  for (std::size_t i = 0; 2 * i < way.size(); ++i) {
    course_.stands_at(way[i]);
    mapping_.see();
  }

  EXPECT_LT(mapping_.share().area_left(), all - 1000);
  EXPECT_GT(mapping_.share().area_left(), 1000);
}

TEST_F(FieldMapping, OffersWhatItCanMapOnceItHoldsARole) { EXPECT_TRUE(mapping_.offer({})); }

}  // namespace
}  // namespace skein::decision_node
