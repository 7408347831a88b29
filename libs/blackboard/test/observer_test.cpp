// SPDX-License-Identifier: Apache-2.0
// Which endpoints DDS matches, without DDS; with it: fastdds_observer_test.cpp.
#include "skein/blackboard/observer.hpp"

#include <gtest/gtest.h>

namespace skein::blackboard {
namespace {

Endpoint writer(EndpointQos qos = {true, Durability::kTransientLocal}) {
  Endpoint endpoint;
  endpoint.writer = endpoint.keyed = true;
  endpoint.topic = "Clock";
  endpoint.type = "skein::idl::Clock";
  endpoint.qos = qos;
  return endpoint;
}

Endpoint reader(EndpointQos qos = {true, Durability::kTransientLocal}) {
  Endpoint endpoint = writer(qos);
  endpoint.writer = false;
  return endpoint;
}

TEST(Refusals, AreNoneBetweenEquals) { EXPECT_TRUE(refusals(writer(), reader()).empty()); }

TEST(Refusals, AreNoneWhereTheWriterOffersMore) {
  EXPECT_TRUE(refusals(writer(), reader({})).empty());
}

TEST(Refusals, NameEachPolicyOfWhichTheWriterOffersLess) {
  const auto causes = refusals(writer({}), reader());
  ASSERT_EQ(causes.size(), 2U);
  EXPECT_EQ(causes[0], "the writer offers best effort, the reader asks for reliable");
  EXPECT_EQ(causes[1], "the writer offers volatile, the reader asks for transient-local");
}

TEST(Refusals, NameAnotherTypeAndAMissingKey) {
  Endpoint other = writer();
  other.type = "other::Clock";
  other.keyed = false;
  EXPECT_EQ(refusals(other, reader()).size(), 2U);
}

TEST(Refusals, HoldForOwnershipInBothDirectionsAndForLongerDeadlines) {
  EndpointQos exclusive, punctual;
  exclusive.exclusive = true;
  punctual.deadline = Duration::milliseconds(100);
  EXPECT_EQ(refusals(writer(exclusive), reader({})).size(), 1U);
  EXPECT_EQ(refusals(writer({}), reader(exclusive)).size(), 1U);
  EXPECT_EQ(refusals(writer({}), reader(punctual)).size(), 1U);
  EXPECT_TRUE(refusals(writer(punctual), reader({})).empty());
}

TEST(Partitions, MeetByNameOrByThePatternOfOneSide) {
  EXPECT_TRUE(partitions_meet({"world"}, {"world", "x"}));
  EXPECT_TRUE(partitions_meet({"radio/marvin>ground"}, {"radio/*"}));
  EXPECT_TRUE(partitions_meet({"radio/?>b"}, {"radio/a>b"}));
  EXPECT_FALSE(partitions_meet({"radio/a>b"}, {"onboard/*"}));
  EXPECT_FALSE(partitions_meet({"radio/*"}, {"rad?o/*"})) << "two patterns";
}

TEST(Partitions, AreTheDefaultOneWhereThereAreNone) {
  EXPECT_TRUE(partitions_meet({}, {}));
  EXPECT_TRUE(partitions_meet({}, {""}));
  EXPECT_TRUE(partitions_meet({}, {"*"}));
  EXPECT_FALSE(partitions_meet({}, {"world"}));
}

}  // namespace
}  // namespace skein::blackboard
