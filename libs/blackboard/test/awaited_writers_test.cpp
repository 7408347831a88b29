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
  Mailbox mailbox_;
  AwaitedWriters awaited_{mailbox_};
  int notified_ = 0;
};

TEST_F(WritersAwaited, AreToldOfOnceAndWakeTheOwner) {
  awaited_.found("Telemetry", {"radio/b>ground"});
  awaited_.found("Telemetry", {"radio/b>ground"});

  EXPECT_EQ(notified_, 1);
  EXPECT_THAT(awaited_.take(), ElementsAre(Reader{1, Slot::kTelemetry}));
  EXPECT_THAT(awaited_.take(), IsEmpty());
}

TEST_F(WritersAwaited, AreNotThoseOfOtherPartitionsTopicsOrOfReadersThatDoNotWait) {
  awaited_.found("Telemetry", {"radio/a>b"});
  awaited_.found("Telemetry", {});
  awaited_.found("rt/chatter", {"radio/a>ground"});
  awaited_.found("SyncMessage", {"radio/a>ground"});
  awaited_.found("Heartbeat", {"radio/a>ground"});

  EXPECT_EQ(notified_, 0);
  EXPECT_THAT(awaited_.take(), IsEmpty());
}

TEST_F(WritersAwaited, AreThoseInManyPartitionsToo) {
  awaited_.found("TaskEvent", {"nowhere", "radio/*"});

  EXPECT_EQ(notified_, 1);
  EXPECT_THAT(awaited_.take(),
              UnorderedElementsAre(Reader{0, Slot::kTaskEvent}, Reader{1, Slot::kTaskEvent}));
}

}  // namespace
}  // namespace skein::blackboard::rtps
