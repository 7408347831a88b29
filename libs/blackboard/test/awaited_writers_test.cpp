// SPDX-License-Identifier: Apache-2.0
#include "adapters/rtps/awaited_writers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skein::blackboard::rtps {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;
using wire::Slot;
using Reader = AwaitedWriters::Reader;

class WritersAwaited : public ::testing::Test {
 protected:
  void SetUp() override {
    mailbox_.on_arrival([this] { ++notified_; });
    awaited_.await(0, reading("radio/a>ground"));
    awaited_.await(1, reading("radio/b>ground"));
  }
  static LinkPlan reading(const std::string& partition) {
    LinkPlan link;
    link.config.partition = partition;
    link.reads = {Slot::kTelemetry, Slot::kTaskEvent, Slot::kHeartbeat};
    link.readers_wait = true;
    return link;
  }
  void found(const std::string& topic, const std::vector<std::string>& partitions) {
    awaited_.found(topic, "skein::idl::" + topic, partitions);
  }
  Mailbox mailbox_;
  AwaitedWriters awaited_{mailbox_};
  int notified_ = 0;
};

TEST_F(WritersAwaited, AreToldOfOnceAndWakeTheOwner) {
  found("Telemetry", {"radio/b>ground"});
  found("Telemetry", {"radio/b>ground"});

  EXPECT_EQ(notified_, 1);
  EXPECT_THAT(awaited_.take(), ElementsAre(Reader{1, Slot::kTelemetry}));
  EXPECT_THAT(awaited_.take(), IsEmpty());
}

TEST_F(WritersAwaited, AreNotThoseOfOtherPartitionsTopicsOrOfReadersThatDoNotWait) {
  found("Telemetry", {"radio/a>b"});
  found("Telemetry", {});
  found("rt/chatter", {"radio/a>ground"});
  found("SyncMessage", {"radio/a>ground"});
  found("Heartbeat", {"radio/a>ground"});

  EXPECT_EQ(notified_, 0);
  EXPECT_THAT(awaited_.take(), IsEmpty());
}

TEST_F(WritersAwaited, AreThoseInManyPartitionsToo) {
  found("TaskEvent", {"nowhere", "radio/*"});

  EXPECT_EQ(notified_, 1);
  EXPECT_THAT(awaited_.take(),
              UnorderedElementsAre(Reader{0, Slot::kTaskEvent}, Reader{1, Slot::kTaskEvent}));
}

TEST_F(WritersAwaited, OfAnotherTypeAreRefusedAndNotRead) {
  awaited_.found("Telemetry", "skein::idl::TaskEvent", {"radio/b>ground"});

  EXPECT_EQ(notified_, 1);
  EXPECT_THAT(awaited_.take(), IsEmpty());
  const std::vector<Arrival> arrivals = mailbox_.take();
  ASSERT_EQ(arrivals.size(), 1U);
  EXPECT_EQ(arrivals[0].channel, 1U);
  const auto* malformed = std::get_if<Malformed>(&arrivals[0].content);
  ASSERT_NE(malformed, nullptr);
  EXPECT_EQ(malformed->slot, Slot::kTelemetry);
  EXPECT_EQ(malformed->violation.field, "type");
  EXPECT_EQ(malformed->violation.why, "is skein::idl::TaskEvent, not skein::idl::Telemetry");
}

TEST_F(WritersAwaited, OfAnotherTypeAreRefusedWhereNobodyWaitsToo) {
  found("Telemetry", {"radio/b>ground"});
  (void)awaited_.take();
  awaited_.found("Telemetry", "std_msgs::msg::String", {"radio/b>ground"});
  awaited_.found("Heartbeat", "std_msgs::msg::String", {"radio/b>ground"});

  EXPECT_EQ(mailbox_.take().size(), 2U);
}

TEST_F(WritersAwaited, OfAnotherTypeForOthersAreNoneOfOurBusiness) {
  awaited_.found("Telemetry", "skein::idl::TaskEvent", {"radio/a>b"});
  awaited_.found("rt/chatter", "std_msgs::msg::String", {"radio/b>ground"});

  EXPECT_THAT(mailbox_.take(), IsEmpty());
  EXPECT_EQ(notified_, 0);
}

}  // namespace
}  // namespace skein::blackboard::rtps
