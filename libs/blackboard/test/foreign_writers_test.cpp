// SPDX-License-Identifier: Apache-2.0
// A blackboard over each DDS against writers of each DDS that know nothing of Skein: what they say
// wrong is refused, counted and named once, and what others say right is read all the same.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <limits>
#include <mutex>

#include "skein/blackboard/blackboard.hpp"
#include "skein/blackboard/dds_transport.hpp"
#include "skein/blackboard/domain_lease.hpp"
#include "testing/foreign_writer.hpp"

namespace skein::blackboard::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const Node kGround{NodeNumber(1), "ground"};
const Node kMarvin{NodeNumber(3), "marvin"};
constexpr const char* kPartition = "radio/marvin>ground";

struct Pair {
  DdsVendor ours, theirs;
};

template <class T>
T said_by_marvin(std::uint64_t sequence, std::uint64_t incarnation = 1) {
  T sample;
  sample.header.origin = kMarvin.number.value();
  sample.header.incarnation = incarnation;
  sample.header.sequence_number = sequence;
  sample.header.expires = wire::kNever;
  return sample;
}

wire::AutonomyDegree degree(std::uint64_t sequence, std::uint8_t value,
                            std::uint64_t incarnation = 1) {
  auto sample = said_by_marvin<wire::AutonomyDegree>(sequence, incarnation);
  sample.uav = "marvin";
  sample.degree = value;
  return sample;
}

class ForeignWriters : public ::testing::TestWithParam<Pair> {
 protected:
  ForeignWriters() {
    DdsConfig config;
    config.domain = lease_.domain();
    config.network.dds = GetParam().ours;
    transport_ = make_dds_transport(std::move(config));
    transport_->on_arrival([this] {
      const std::lock_guard lock(mutex_);
      arrived_ = true;
      wake_.notify_one();
    });
    Config settings;
    settings.self = kGround.number;
    settings.channels = radio_link(kGround, kMarvin);
    auto opened = Blackboard::open(std::move(settings), *transport_);
    if (opened) ground_ = std::make_unique<Blackboard>(std::move(*opened));
  }
  /// Nobody arrives any more when what is woken by it is gone.
  ~ForeignWriters() override {
    ground_.reset();
    transport_.reset();
  }
  void SetUp() override { ASSERT_NE(ground_, nullptr); }

  std::unique_ptr<ForeignWriter> writer(wire::Slot topic, wire::Slot type) const {
    return make_foreign_writer(GetParam().theirs, {lease_.domain(), topic, type, kPartition});
  }
  std::unique_ptr<ForeignWriter> writer(wire::Slot slot) const { return writer(slot, slot); }

  /// One more heartbeat of marvin's to the ground station.
  void beat(ForeignWriter& by, std::uint64_t incarnation) {
    auto heartbeat = said_by_marvin<wire::Heartbeat>(++sequence_, incarnation);
    heartbeat.header.destination = kGround.number.value();
    by.write(bytes_of(heartbeat));
  }

  bool run_until(const std::function<bool()>& condition, double seconds = 30) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    while (std::chrono::steady_clock::now() < deadline) {
      for (Incoming& incoming : ground_->step(now())) received_.push_back(std::move(incoming));
      if (condition()) return true;
      std::unique_lock lock(mutex_);
      wake_.wait_for(lock, std::chrono::milliseconds(20), [this] { return arrived_; });
      arrived_ = false;
    }
    return false;
  }
  template <class T>
  std::vector<T> reports() const {
    std::vector<T> found;
    for (const Incoming& incoming : received_)
      if (const auto* report = std::get_if<T>(&incoming)) found.push_back(*report);
    return found;
  }
  std::vector<int> degrees() const {
    std::vector<int> found;
    for (const Received& one : reports<Received>())
      if (const auto* said = std::get_if<wire::AutonomyDegree>(&one.sample))
        found.push_back(said->degree);
    return found;
  }

  std::uint64_t sequence_ = 0;  ///< of the last heartbeat

 private:
  static Now now() {
    const auto since = std::chrono::steady_clock::now().time_since_epoch();
    return {{}, Duration::nanoseconds(std::chrono::nanoseconds(since).count())};
  }

  DomainLease lease_ = claim_domain().value();
  std::unique_ptr<Transport> transport_;
  std::unique_ptr<Blackboard> ground_;
  std::vector<Incoming> received_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool arrived_ = false;
};

TEST_P(ForeignWriters, AnEnumerationOutOfRangeIsRefusedAndNamedOnce) {
  const auto marvin = writer(wire::Slot::kPlanBoard);
  auto board = said_by_marvin<wire::PlanBoard>(1);
  board.tasks.resize(2);
  for (const std::size_t wrong : {0, 1}) {
    board.tasks[wrong].state = static_cast<wire::TaskState>(17);
    ASSERT_TRUE(marvin->write(bytes_of(board)));
    ASSERT_TRUE(run_until([&] { return reports<Dropped>().size() == wrong + 1; }));
    board.tasks[wrong].state = wire::TaskState::kEnded;
  }

  const auto dropped = reports<Dropped>();
  EXPECT_EQ(dropped[0].field, "tasks[0].state");
  EXPECT_EQ(dropped[0].origin, kMarvin.number);
  EXPECT_TRUE(dropped[0].first);
  EXPECT_FALSE(dropped[1].first);
  EXPECT_THAT(reports<Received>(), IsEmpty());
}

TEST_P(ForeignWriters, ANumberThatIsNotFiniteIsRefused) {
  const auto marvin = writer(wire::Slot::kTelemetry);
  std::uint64_t sequence = 0;

  ASSERT_TRUE(run_until([&] {
    auto telemetry = said_by_marvin<wire::Telemetry>(++sequence);
    telemetry.position.z = std::numeric_limits<float>::quiet_NaN();
    marvin->write(bytes_of(telemetry));
    return !reports<Dropped>().empty();
  }));

  EXPECT_EQ(reports<Dropped>()[0].field, "position.z");
  EXPECT_THAT(reports<Received>(), IsEmpty());
}

TEST_P(ForeignWriters, WhatIsCutShortAnywhereIsRefusedAndWhatFollowsIsRead) {
  const auto marvin = writer(wire::Slot::kAutonomyDegree);
  const Bytes whole = bytes_of(degree(1, 2));
  // What is left out of the last three bytes may be taken for the padding of RTPS.
  std::size_t cuts = 0;
  for (std::size_t length = 4; length + 4 < whole.size(); length += 5) {
    ASSERT_TRUE(marvin->write(Bytes(whole.begin(), whole.begin() + static_cast<long>(length))));
    ASSERT_TRUE(run_until([&] { return reports<Dropped>().size() == cuts + 1; })) << length;
    ++cuts;
  }

  ASSERT_TRUE(marvin->write(whole));

  EXPECT_TRUE(run_until([&] { return !degrees().empty(); }));
  EXPECT_THAT(degrees(), ElementsAre(2));
}

TEST_P(ForeignWriters, WhatIsNotCdrVersionOneIsRefused) {
  const auto marvin = writer(wire::Slot::kAutonomyDegree);
  Bytes bytes = bytes_of(degree(1, 2));
  bytes[1] = 7;  // XCDR2

  ASSERT_TRUE(marvin->write(bytes));

  ASSERT_TRUE(run_until([&] { return !reports<Dropped>().empty(); }));
  EXPECT_EQ(reports<Dropped>()[0].why, "not CDR version 1");
}

TEST_P(ForeignWriters, WhatIsTooLargeIsRefusedAndWhatFollowsIsRead) {
  const auto marvin = writer(wire::Slot::kPlanBoard);
  auto board = said_by_marvin<wire::PlanBoard>(1);
  board.tasks.resize(wire::kMaximumSequence + 1);
  ASSERT_TRUE(marvin->write(bytes_of(board)));
  ASSERT_TRUE(run_until([&] { return !reports<Dropped>().empty(); }));
  EXPECT_EQ(reports<Dropped>()[0].field, "tasks");
  EXPECT_EQ(reports<Dropped>()[0].origin, kMarvin.number);

  auto next = said_by_marvin<wire::PlanBoard>(2);
  next.tasks.resize(2);
  ASSERT_TRUE(marvin->write(bytes_of(next)));

  EXPECT_TRUE(run_until([&] { return reports<Received>().size() == 1; }));
}

TEST_P(ForeignWriters, AMegabyteOfNothingInParticularIsRefused) {
  const auto marvin = writer(wire::Slot::kPlanBoard);
  Bytes bytes(1'000'000, 0xA5);
  std::ranges::copy(bytes_of(said_by_marvin<wire::PlanBoard>(1)), bytes.begin());
  std::fill(bytes.begin() + 60, bytes.end(), std::uint8_t{0xA5});

  ASSERT_TRUE(marvin->write(bytes));

  EXPECT_TRUE(run_until([&] { return !reports<Dropped>().empty(); }));
  EXPECT_THAT(reports<Received>(), IsEmpty());
}

TEST_P(ForeignWriters, AnotherTypeUnderAKnownTopicIsNotHeardAndHarmsNobody) {
  const auto wrong = writer(wire::Slot::kAutonomyDegree, wire::Slot::kTelemetry);
  ASSERT_TRUE(wrong->write(bytes_of(said_by_marvin<wire::Telemetry>(1))));
  EXPECT_FALSE(run_until([&] { return !reports<Received>().empty(); }, 0.5));

  const auto right = writer(wire::Slot::kAutonomyDegree);
  ASSERT_TRUE(right->write(bytes_of(degree(2, 3))));

  ASSERT_TRUE(run_until([&] { return !degrees().empty(); }));
  EXPECT_THAT(degrees(), ElementsAre(3));
}

TEST_P(ForeignWriters, AnotherTypeUnderAKnownTopicIsNamedOnceForEachWriter) {
  const auto wrong = writer(wire::Slot::kAutonomyDegree, wire::Slot::kTelemetry);
  ASSERT_TRUE(run_until([&] { return reports<Dropped>().size() == 1; }));
  const auto another = writer(wire::Slot::kAutonomyDegree, wire::Slot::kTelemetry);
  ASSERT_TRUE(run_until([&] { return reports<Dropped>().size() == 2; }));

  const auto dropped = reports<Dropped>();
  EXPECT_EQ(dropped[0].slot, wire::Slot::kAutonomyDegree);
  EXPECT_EQ(dropped[0].field, "type");
  EXPECT_EQ(dropped[0].why, "is skein::idl::Telemetry, not skein::idl::AutonomyDegree");
  EXPECT_TRUE(dropped[0].first);
  EXPECT_FALSE(dropped[1].first);
}

TEST_P(ForeignWriters, WhatIsRefusedAgainAndAgainIsNamedTheTenthTimeWithTheCount) {
  const auto marvin = writer(wire::Slot::kAutonomyDegree);
  for (std::uint64_t i = 1; i <= 12; ++i) {
    Bytes bytes = bytes_of(degree(i, 2));
    bytes[1] = 7;  // XCDR2
    ASSERT_TRUE(marvin->write(bytes));
    ASSERT_TRUE(run_until([&] { return reports<Dropped>().size() == i; }));
  }
  std::vector<std::string> named;
  for (const Dropped& one : reports<Dropped>())
    if (one.first) named.push_back(one.why);
  EXPECT_THAT(named, ElementsAre("not CDR version 1", "not CDR version 1 (10 times)"));
}

TEST_P(ForeignWriters, TwoWhoSpeakByTurnsInOneNameAreNamedOnce) {
  const auto marvin = writer(wire::Slot::kHeartbeat);
  const auto other = writer(wire::Slot::kHeartbeat);
  ASSERT_TRUE(run_until([&] {
    beat(*marvin, 20);
    beat(*other, 19);
    return reports<Dropped>().size() > 3;
  }));

  const auto dropped = reports<Dropped>();
  EXPECT_EQ(dropped[0].field, "header.incarnation");
  EXPECT_EQ(dropped[0].origin, kMarvin.number);
  EXPECT_TRUE(dropped[0].first);
  EXPECT_FALSE(dropped[1].first);
}

// A node that starts again with a clock that was set back, say.
TEST_P(ForeignWriters, AnOlderLifeAloneIsNotTakenForTwo) {
  const auto marvin = writer(wire::Slot::kHeartbeat);
  ASSERT_TRUE(run_until([&] {
    beat(*marvin, 20);
    return !reports<Reachability>().empty();
  }));
  EXPECT_FALSE(run_until(
      [&] {
        beat(*marvin, 19);
        return !reports<Dropped>().empty();
      },
      2));
}

TEST_P(ForeignWriters, OldStatesThatAreReplayedDoNotComeAfterNewOnes) {
  const auto marvin = writer(wire::Slot::kAutonomyDegree);
  const auto say = [&](const wire::AutonomyDegree& sample) {
    ASSERT_TRUE(marvin->write(bytes_of(sample)));
  };
  say(degree(1, 2));
  ASSERT_TRUE(run_until([&] { return degrees().size() == 1; }));
  say(degree(2, 3));
  ASSERT_TRUE(run_until([&] { return degrees().size() == 2; }));

  say(degree(1, 2));
  say(degree(2, 3));
  say(degree(3, 4));

  ASSERT_TRUE(run_until([&] { return degrees().size() == 3; }));
  EXPECT_THAT(degrees(), ElementsAre(2, 3, 4));
  ASSERT_EQ(reports<Dropped>().size(), 1U);
  EXPECT_EQ(reports<Dropped>()[0].slot, wire::Slot::kAutonomyDegree);
  EXPECT_EQ(reports<Dropped>()[0].field, "header.sequence_number");
  EXPECT_TRUE(reports<Dropped>()[0].first);
}

TEST_P(ForeignWriters, EventsThatAreReplayedAreHandledOnce) {
  const auto says = writer(wire::Slot::kTaskEvent);
  const auto beats = writer(wire::Slot::kHeartbeat);
  auto event = said_by_marvin<wire::TaskEvent>(1);
  event.header.destination = kGround.number.value();
  auto beat = said_by_marvin<wire::Heartbeat>(1);
  beat.events_from = 1;
  beat.events_to = 1;
  beat.ack_incarnation = 1;
  const auto handled = [&] { return reports<Received>().size(); };
  ASSERT_TRUE(run_until([&] {
    ++beat.header.sequence_number;
    beats->write(bytes_of(beat));
    says->write(bytes_of(event));
    return handled() > 0;
  }));

  ++beat.events_from;  // its sender has the acknowledgement
  ++beat.header.sequence_number;
  ASSERT_TRUE(beats->write(bytes_of(beat)));
  ASSERT_TRUE(run_until([&] {
    says->write(bytes_of(event));
    return reports<Dropped>().size() > 5;
  }));

  EXPECT_EQ(handled(), 1U);
  const auto dropped = reports<Dropped>();
  EXPECT_EQ(dropped[0].field, "header.sequence_number");
  EXPECT_TRUE(dropped[0].first);
  EXPECT_FALSE(dropped[1].first);
}

TEST_P(ForeignWriters, ASecondNodeOfTheSameNameIsTheOlderOfTheTwoAndNotHeard) {
  const auto marvin = writer(wire::Slot::kAutonomyDegree);
  ASSERT_TRUE(marvin->write(bytes_of(degree(1, 4, 20))));
  ASSERT_TRUE(run_until([&] { return degrees().size() == 1; }));

  ASSERT_TRUE(marvin->write(bytes_of(degree(7, 1, 19))));
  ASSERT_TRUE(marvin->write(bytes_of(degree(2, 5, 20))));

  ASSERT_TRUE(run_until([&] { return degrees().size() == 2; }));
  EXPECT_THAT(degrees(), ElementsAre(4, 5));
}

TEST_P(ForeignWriters, ASecondNodeOfTheSameNameIsTheLaterOfTheTwoAndRefusedWhileTheFirstIsHeard) {
  const auto marvin = writer(wire::Slot::kHeartbeat);
  const auto other = writer(wire::Slot::kHeartbeat);
  const auto others_degree = writer(wire::Slot::kAutonomyDegree);
  ASSERT_TRUE(run_until([&] {
    beat(*marvin, 20);
    return !reports<Reachability>().empty();
  }));
  ASSERT_TRUE(run_until([&] {
    beat(*other, 50);
    beat(*marvin, 20);
    others_degree->write(bytes_of(degree(++sequence_, 1, 50)));
    return reports<Dropped>().size() > 20;
  }));

  const auto dropped = reports<Dropped>();
  EXPECT_EQ(dropped[0].field, "header.incarnation");
  EXPECT_EQ(dropped[0].why, "is of a second node with this name, while the first is heard");
  std::size_t named = 0;
  for (const Dropped& one : dropped) named += one.first ? 1 : 0;
  EXPECT_EQ(named, 2U) << "and the tenth time";
}

std::string name_of_pair(const ::testing::TestParamInfo<Pair>& info) {
  return "on_" + std::string(name_of(info.param.ours)) + "_from_" +
         std::string(name_of(info.param.theirs));
}

INSTANTIATE_TEST_SUITE_P(OfBothVendors, ForeignWriters,
                         ::testing::Values(Pair{DdsVendor::kFastDds, DdsVendor::kFastDds},
                                           Pair{DdsVendor::kFastDds, DdsVendor::kCycloneDds},
                                           Pair{DdsVendor::kCycloneDds, DdsVendor::kFastDds},
                                           Pair{DdsVendor::kCycloneDds, DdsVendor::kCycloneDds}),
                         name_of_pair);

}  // namespace
}  // namespace skein::blackboard::testing
