// SPDX-License-Identifier: Apache-2.0
// When a channel over RTPS has which endpoints: without DDS, whose part a double plays.
#include "adapters/rtps/link.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <optional>
#include <set>

namespace skein::blackboard::rtps {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::UnorderedElementsAre;
using wire::Slot;
using Slots = std::set<Slot>;

constexpr NodeNumber kSelf{1}, kPeer{2};

/// What DDS has of a channel, and what its writers keep.
struct FakeDds {
  bool open = false;
  Slots writers, readers;
  std::vector<wire::Sample> written;  ///< by writers that there are
  std::optional<Slot> refused;        ///< no endpoint of it can be made
};

class FakeEndpoints final : public Endpoints {
 public:
  explicit FakeEndpoints(FakeDds& dds) : dds_(dds) {}

  Result<void, Failure> open() override {
    dds_.open = true;
    return {};
  }
  Result<void, Failure> add_writer(Slot slot) override { return add(dds_.writers, slot); }
  Result<void, Failure> add_reader(Slot slot) override { return add(dds_.readers, slot); }
  Result<void, Failure> close() override {
    dds_.open = false;
    dds_.writers.clear();
    dds_.readers.clear();
    dds_.written.clear();
    return {};
  }
  bool write(const wire::Sample& sample) override {
    EXPECT_TRUE(dds_.writers.contains(wire::slot_of(sample)));
    dds_.written.push_back(sample);
    return true;
  }
  void flush(Clock::time_point /*until*/) override {}

 private:
  Result<void, Failure> add(Slots& endpoints, Slot slot) {
    EXPECT_TRUE(dds_.open);
    if (dds_.refused == slot)
      return failure("no endpoint of " + std::string(wire::slot_name(slot)));
    EXPECT_TRUE(endpoints.insert(slot).second) << wire::slot_name(slot);
    return {};
  }
  FakeDds& dds_;
};

/// The radio channel between self and peer, in that direction or against it. Narrow: all endpoints
/// wait that can.
TransportPlan radio_plan(NodeNumber from) {
  ChannelConfig radio{from, from == kSelf ? kPeer : kSelf, ChannelKind::kRadio, "radio/a>b", {}};
  radio.slots = {Slot::kAutonomyDegree, Slot::kTaskEvent, Slot::kTelemetry};
  radio.capacity = 9'600;
  return {kSelf, {radio}, {}};
}

template <class T>
T numbered(std::uint64_t number) {
  T sample;
  sample.header.origin = kSelf.value();
  sample.header.sequence_number = number;
  return sample;
}

wire::Sample sample_of(Slot slot, std::uint64_t number) {
  if (slot == Slot::kAutonomyDegree) return numbered<wire::AutonomyDegree>(number);
  if (slot == Slot::kTaskEvent) return numbered<wire::TaskEvent>(number);
  return numbered<wire::Telemetry>(number);
}

std::vector<std::uint64_t> numbers(const std::vector<wire::Sample>& samples) {
  std::vector<std::uint64_t> all;
  for (const wire::Sample& one : samples) all.push_back(wire::header_of(one).sequence_number);
  return all;
}

class ChannelOverRtps : public ::testing::Test {
 protected:
  Link make(const TransportPlan& plan, const DdsConfig& config = {}) {
    return {plan_link(plan, 0, config), std::make_unique<FakeEndpoints>(dds_),
            [this](const std::string& line) { said_.push_back(line); }};
  }
  FakeDds dds_;
  std::vector<std::string> said_;
};

TEST_F(ChannelOverRtps, BeginsWithTheHeartbeat) {
  Link out = make(radio_plan(kSelf));
  ASSERT_TRUE(out.open().has_value());
  EXPECT_THAT(dds_.writers, UnorderedElementsAre(Slot::kHeartbeat));
  EXPECT_THAT(dds_.readers, IsEmpty());
}

TEST_F(ChannelOverRtps, OfASmallTeamHasTheWritersOfEventsAndStreamsFromTheBeginningAndAfterACut) {
  for (const double capacity : {0.0, 250'000.0}) {
    TransportPlan plan = radio_plan(kSelf);
    plan.channels.front().capacity = capacity;
    Link out = make(plan);
    ASSERT_TRUE(out.open().has_value());
    EXPECT_THAT(dds_.writers,
                UnorderedElementsAre(Slot::kHeartbeat, Slot::kTaskEvent, Slot::kTelemetry));
    ASSERT_TRUE(out.set_up(false).has_value());
    ASSERT_TRUE(out.set_up(true).has_value());
    EXPECT_THAT(dds_.writers,
                UnorderedElementsAre(Slot::kHeartbeat, Slot::kTaskEvent, Slot::kTelemetry));
    ASSERT_TRUE(out.set_up(false).has_value());
  }
}

TEST_F(ChannelOverRtps, OfALargeTeamHasNoWritersThatNobodyNeedsYet) {
  TransportPlan plan = radio_plan(kSelf);
  plan.channels.front().capacity = 0;
  for (std::uint32_t peer = 3; peer < 70; ++peer) {
    plan.channels.push_back(plan.channels.front());
    plan.channels.back().to = NodeNumber(peer);
  }
  Link out = make(plan);
  ASSERT_TRUE(out.open().has_value());
  EXPECT_THAT(dds_.writers, UnorderedElementsAre(Slot::kHeartbeat));
}

TEST_F(ChannelOverRtps, SaysTheFirstWordOfAStreamAgainToWhoeverIsFound) {
  Link out = make(radio_plan(kSelf));
  ASSERT_TRUE(out.open().has_value());
  out.write(numbered<wire::Telemetry>(1));
  out.write(numbered<wire::Telemetry>(2));
  out.write(numbered<wire::TaskEvent>(3));

  out.meet(Slot::kTelemetry);
  out.meet(Slot::kTelemetry);
  out.meet(Slot::kTaskEvent);

  EXPECT_THAT(numbers(dds_.written), ElementsAre(1, 2, 3, 2, 2));
}

// A session says again what is not acknowledged; a reader that is found late would be told all of
// it.
TEST_F(ChannelOverRtps, KeepsAnEventOnceForAReaderThatIsNotThereYet) {
  Link out = make(radio_plan(kSelf));
  ASSERT_TRUE(out.open().has_value());
  for (const std::uint64_t number : {1, 2, 1, 2})
    EXPECT_TRUE(out.write(numbered<wire::TaskEvent>(number)));
  EXPECT_THAT(numbers(dds_.written), ElementsAre(1, 2));

  auto given_up = numbered<wire::TaskEvent>(1);
  given_up.header.expires = 7;
  out.write(given_up);
  EXPECT_THAT(numbers(dds_.written), ElementsAre(1, 2, 1)) << "that it is over is news";

  out.meet(Slot::kTaskEvent);
  out.write(numbered<wire::TaskEvent>(1));
  EXPECT_THAT(numbers(dds_.written), ElementsAre(1, 2, 1, 1));
}

TEST_F(ChannelOverRtps, KeepsItAgainAfterACut) {
  Link out = make(radio_plan(kSelf));
  ASSERT_TRUE(out.open().has_value());
  out.write(numbered<wire::TaskEvent>(1));
  out.meet(Slot::kTaskEvent);
  ASSERT_TRUE(out.set_up(false).has_value());
  ASSERT_TRUE(out.set_up(true).has_value());

  out.write(numbered<wire::TaskEvent>(1));

  EXPECT_THAT(numbers(dds_.written), ElementsAre(1)) << "its own copy";
}

TEST_F(ChannelOverRtps, HasTheWritersOfStreamsThatWereWrittenAgainAtTheEndOfACut) {
  Link out = make(radio_plan(kSelf));
  ASSERT_TRUE(out.open().has_value());
  out.write(numbered<wire::Telemetry>(1));
  ASSERT_TRUE(out.set_up(false).has_value());
  out.meet(Slot::kTelemetry);
  ASSERT_TRUE(out.set_up(true).has_value());

  EXPECT_THAT(dds_.writers, UnorderedElementsAre(Slot::kHeartbeat, Slot::kTelemetry));
  out.meet(Slot::kTelemetry);
  EXPECT_THAT(dds_.written, IsEmpty()) << "what was said before is of the past";
}

TEST_F(ChannelOverRtps, HasAWriterFromItsFirstSampleOn) {
  Link out = make(radio_plan(kSelf));
  ASSERT_TRUE(out.open().has_value());

  EXPECT_TRUE(out.write(numbered<wire::TaskEvent>(1)));
  EXPECT_TRUE(out.write(numbered<wire::TaskEvent>(2)));

  EXPECT_THAT(dds_.writers, UnorderedElementsAre(Slot::kHeartbeat, Slot::kTaskEvent));
  EXPECT_THAT(numbers(dds_.written), ElementsAre(1, 2));
}

TEST_F(ChannelOverRtps, TakesNothingThatItDoesNotCarry) {
  Link out = make(radio_plan(kSelf));
  ASSERT_TRUE(out.open().has_value());
  EXPECT_FALSE(out.write(numbered<wire::SyncMessage>(1)));

  FakeDds other;
  Link in(plan_link(radio_plan(kPeer), 0, {}), std::make_unique<FakeEndpoints>(other), {});
  ASSERT_TRUE(in.open().has_value());
  EXPECT_FALSE(in.write(numbered<wire::TaskEvent>(1))) << "it is the peer's to write";
}

TEST_F(ChannelOverRtps, HasAReaderOnceSomebodyWrites) {
  Link in = make(radio_plan(kPeer));
  ASSERT_TRUE(in.open().has_value());
  EXPECT_THAT(dds_.readers, UnorderedElementsAre(Slot::kHeartbeat));

  in.attend(Slot::kTelemetry);
  in.attend(Slot::kTelemetry);
  in.attend(Slot::kSyncMessage);  // which it does not carry

  EXPECT_THAT(dds_.readers, UnorderedElementsAre(Slot::kHeartbeat, Slot::kTelemetry));
}

TEST_F(ChannelOverRtps, ReadsAfterACutWhatSomebodyBeganToWriteBeforeOrDuringIt) {
  Link in = make(radio_plan(kPeer));
  ASSERT_TRUE(in.open().has_value());
  in.attend(Slot::kTelemetry);

  ASSERT_TRUE(in.set_up(false).has_value());
  in.attend(Slot::kTaskEvent);
  EXPECT_THAT(dds_.readers, IsEmpty());
  ASSERT_TRUE(in.set_up(true).has_value());

  EXPECT_THAT(dds_.readers,
              UnorderedElementsAre(Slot::kHeartbeat, Slot::kTelemetry, Slot::kTaskEvent));
}

TEST_F(ChannelOverRtps, SaysAgainAfterACutWhatItsWritersKeptAndWhatWasSaidMeanwhile) {
  Link out = make(radio_plan(kSelf));
  ASSERT_TRUE(out.open().has_value());
  out.write(numbered<wire::AutonomyDegree>(1));
  out.write(numbered<wire::TaskEvent>(2));

  ASSERT_TRUE(out.set_up(false).has_value());
  EXPECT_TRUE(out.write(numbered<wire::AutonomyDegree>(3)));
  EXPECT_TRUE(out.write(numbered<wire::TaskEvent>(4)));
  EXPECT_TRUE(out.write(numbered<wire::Telemetry>(5)));
  EXPECT_THAT(dds_.written, IsEmpty());
  ASSERT_TRUE(out.set_up(true).has_value());

  EXPECT_THAT(numbers(dds_.written), ElementsAre(3, 2, 4)) << "a stream is not said again";
}

TEST_F(ChannelOverRtps, StaysCutWhereSomethingCannotBeMadeAtItsEndAndMayBeAskedAgain) {
  Link out = make(radio_plan(kSelf));
  ASSERT_TRUE(out.open().has_value());
  out.write(numbered<wire::TaskEvent>(1));
  ASSERT_TRUE(out.set_up(false).has_value());

  dds_.refused = Slot::kTaskEvent;
  const auto refused = out.set_up(true);

  ASSERT_FALSE(refused.has_value());
  EXPECT_THAT(refused.error().why, HasSubstr("1 samples of channel radio/a>b"));
  EXPECT_FALSE(dds_.open);
  EXPECT_THAT(dds_.writers, IsEmpty()) << "whole or not at all";

  dds_.refused.reset();
  EXPECT_TRUE(out.set_up(true).has_value());
  EXPECT_THAT(numbers(dds_.written), ElementsAre(1));
}

TEST_F(ChannelOverRtps, SaysOnceWhatIsRefusedWhenItIsNeeded) {
  Link out = make(radio_plan(kSelf));
  ASSERT_TRUE(out.open().has_value());
  dds_.refused = Slot::kTaskEvent;

  EXPECT_FALSE(out.write(numbered<wire::TaskEvent>(1)));
  EXPECT_FALSE(out.write(numbered<wire::TaskEvent>(2)));
  EXPECT_THAT(said_, ElementsAre("no endpoint of TaskEvent"));

  dds_.refused.reset();
  EXPECT_TRUE(out.write(numbered<wire::TaskEvent>(3)));
}

TEST_F(ChannelOverRtps, FailsToOpenWhereAnEndpointThatDoesNotWaitIsRefused) {
  dds_.refused = Slot::kHeartbeat;
  Link out = make(radio_plan(kSelf));
  EXPECT_FALSE(out.open().has_value());
  EXPECT_FALSE(dds_.open);
}

TEST_F(ChannelOverRtps, DoesNotWaitWhereOneWantsAllAtOnce) {
  DdsConfig config;
  config.endpoints_at_once = true;
  Link out = make(radio_plan(kSelf), config);
  ASSERT_TRUE(out.open().has_value());
  EXPECT_EQ(dds_.writers.size(), 4U);
}

TEST_F(ChannelOverRtps, DoesNotWaitWithKeys) {
  DdsConfig config;
  config.network.keys = "keys/marvin";
  Link out = make(radio_plan(kSelf), config);
  ASSERT_TRUE(out.open().has_value());
  EXPECT_EQ(dds_.writers.size(), 4U);
}

TEST_F(ChannelOverRtps, WaitsBehindADiscoveryServerAsElsewhere) {
  DdsConfig config;
  config.network.discovery_servers = {"10.0.0.1:11811"};
  Link in = make(radio_plan(kPeer), config);
  ASSERT_TRUE(in.open().has_value());
  EXPECT_THAT(dds_.readers, UnorderedElementsAre(Slot::kHeartbeat));

  ASSERT_TRUE(in.set_up(false).has_value());
  Link out = make(radio_plan(kSelf), config);
  ASSERT_TRUE(out.open().has_value());
  EXPECT_THAT(dds_.readers, IsEmpty());
}

TEST_F(ChannelOverRtps, ReadsAtOnceWhatIsInManyPartitions) {
  TransportPlan plan = radio_plan(kPeer);
  plan.channels.front().partition = "radio/*";
  Link in = make(plan);
  ASSERT_TRUE(in.open().has_value());
  EXPECT_EQ(dds_.readers.size(), 4U);
}

TEST_F(ChannelOverRtps, OfTheWorldIsWholeFromTheBeginning) {
  const TransportPlan plan{kSelf, {world_channel()}, {Slot::kClock}};
  Link world = make(plan);
  ASSERT_TRUE(world.open().has_value());
  const auto& carried = plan.channels.front().slots;
  EXPECT_THAT(dds_.writers, IsSupersetOf(carried));
  EXPECT_THAT(dds_.readers, UnorderedElementsAre(Slot::kClock));
}

/// Anything that happens to a channel of both directions, with what must then be there.
class Story {
 public:
  Story() {
    TransportPlan plan = radio_plan(kSelf);
    LinkPlan both = plan_link(plan, 0, {});
    both.reads = both.writes;
    both.readers_wait = true;
    link_.emplace(both, std::make_unique<FakeEndpoints>(dds_), Link::Log());
    RC_ASSERT(link_->open().has_value());
  }
  void go_on() {
    const Slot slot = *rc::gen::element(Slot::kAutonomyDegree, Slot::kTaskEvent, Slot::kTelemetry);
    switch (*rc::gen::inRange(0, 4)) {
      case 0:
        return write(slot);
      case 1:
        link_->attend(slot);
        written_by_others_.insert(slot);
        return;
      case 2:
        RC_ASSERT(link_->set_up(false).has_value());
        up_ = false;
        written_.clear();
        return;
      default:
        RC_ASSERT(link_->set_up(true).has_value());
        if (!up_) written_ = said_again();
        up_ = true;
    }
  }
  void check() const {
    Slots writers = streamed_, readers = written_by_others_;
    writers.insert(Slot::kHeartbeat);
    readers.insert(Slot::kHeartbeat);
    for (const auto& [slot, number] : written_) writers.insert(slot);
    RC_ASSERT(dds_.open == up_);
    RC_ASSERT(dds_.writers == (up_ ? writers : Slots{}));
    RC_ASSERT(dds_.readers == (up_ ? readers : Slots{}));
    std::vector<std::uint64_t> expected;
    for (const auto& [slot, number] : written_) expected.push_back(number);
    RC_ASSERT(numbers(dds_.written) == expected);
  }

 private:
  using Said = std::vector<std::pair<Slot, std::uint64_t>>;

  void write(Slot slot) {
    RC_ASSERT(link_->write(sample_of(slot, ++last_)));
    if (slot == Slot::kAutonomyDegree) state_ = last_;
    if (slot == Slot::kTaskEvent) events_.push_back(last_);
    if (up_) written_.emplace_back(slot, last_);
    if (up_ && slot == Slot::kTelemetry) streamed_.insert(slot);
  }
  Said said_again() const {
    Said said;
    if (state_) said.emplace_back(Slot::kAutonomyDegree, *state_);
    for (const std::uint64_t event : events_) said.emplace_back(Slot::kTaskEvent, event);
    return said;
  }

  FakeDds dds_;
  std::optional<Link> link_;
  bool up_ = true;
  std::uint64_t last_ = 0;
  std::optional<std::uint64_t> state_;
  std::vector<std::uint64_t> events_;
  Said written_;  ///< by the writers that there are
  Slots written_by_others_, streamed_;
};

RC_GTEST_PROP(ChannelOverRtpsLaw, HasWhatIsNeededAfterAnythingThatHappens, ()) {
  Story story;
  story.check();
  for (int steps = *rc::gen::inRange(1, 40); steps > 0; --steps) {
    story.go_on();
    story.check();
  }
}

}  // namespace
}  // namespace skein::blackboard::rtps
