// SPDX-License-Identifier: Apache-2.0
#include "unread.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skein::spy_tool {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

class UnreadTopics : public ::testing::Test {
 protected:
  void see(bool writer, const std::string& topic, const std::string& partition) {
    blackboard::Endpoint endpoint;
    endpoint.writer = writer;
    endpoint.topic = topic;
    endpoint.partitions = {partition};
    unread.see(blackboard::EndpointSeen{endpoint, false});
  }
  Unread unread;
};

TEST_F(UnreadTopics, AreThoseThatNobodyReadsWhereTheyAreWritten) {
  see(true, "Telemetry", "radio/a>b");
  see(false, "Telemetry", "radio/*");
  see(true, "UavBoard", "world");
  see(true, "Alarm", "radio/a>b");
  see(false, "Alarm", "radio/b>a");

  EXPECT_THAT(unread.topics(), ElementsAre("Alarm", "UavBoard"));
}

TEST_F(UnreadTopics, AreNotThoseOfWhichSomeWritersAreRead) {
  see(true, "Alarm", "radio/a>b");
  see(true, "Alarm", "radio/b>a");
  see(false, "Alarm", "radio/b>a");

  EXPECT_THAT(unread.topics(), IsEmpty());
}

TEST_F(UnreadTopics, AreNotThoseThatWereReadForATime) {
  see(true, "Alarm", "radio/a>b");
  see(false, "Alarm", "radio/a>b");
  unread.see(blackboard::EndpointGone{"anybody"});

  EXPECT_THAT(unread.topics(), IsEmpty());
}

}  // namespace
}  // namespace skein::spy_tool
