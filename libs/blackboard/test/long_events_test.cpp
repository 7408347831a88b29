// SPDX-License-Identifier: Apache-2.0
// Events too long to be said at once: whole, once, whatever is lost; and beside everything else.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "sessions/incoming_parts.hpp"
#include "sessions/outgoing_parts.hpp"
#include "skein/blackboard/blackboard.hpp"
#include "skein/blackboard/cdr.hpp"
#include "testing/memory_boards.hpp"
#include "testing/samples.hpp"

namespace skein::blackboard {
namespace {

using ::testing::ElementsAre;
using testing::hand_over;
using ::testing::IsEmpty;
using testing::task_event;
using testing::telemetry;

const Node kGround{NodeNumber(1), "ground"};
const Node kUav{NodeNumber(2), "uav"};
constexpr Duration kTimeOut = Duration::milliseconds(300);

wire::Sample numbered(std::uint64_t number, std::size_t bytes) {
  wire::HandOver event = hand_over(number, bytes);
  event.header.origin = kUav.number.value();
  event.header.destination = kGround.number.value();
  event.header.incarnation = 1;
  event.header.sequence_number = number;
  event.header.expires = wire::kNever;
  return event;
}

wire::Part with_header(wire::Part part, std::uint64_t incarnation = 1) {
  part.header.incarnation = incarnation;
  return part;
}

// ---- the two halves ----

/// Offsets of all that may be written now.
std::vector<std::uint32_t> write_all(OutgoingParts& parts, Duration now) {
  std::vector<std::uint32_t> offsets;
  while (const auto part = parts.next(now, 1'000, kTimeOut)) {
    offsets.push_back(part->offset);
    parts.written(*part, now);
  }
  return offsets;
}

TEST(OutgoingParts, KeepsSoManyUnderWayAndBeginsAgainWhereThePeerIs) {
  OutgoingParts parts;
  parts.hold(numbered(kFirstLongEvent, 100'000), 0);

  EXPECT_EQ(write_all(parts, {}).size(), OutgoingParts::kPartsUnderWay);
  parts.heard(kFirstLongEvent, 5'000, false);
  EXPECT_THAT(write_all(parts, {}), ElementsAre(16'000, 17'000, 18'000, 19'000, 20'000));
  parts.heard(kFirstLongEvent, 0, false);  // it was restarted
  EXPECT_EQ(write_all(parts, kTimeOut).front(), 0U);
}

// What is missing of what it was told the peer says by itself: the last part asks it.
TEST(OutgoingParts, AfterATimeOutTheLastPartAloneIsWrittenAgain) {
  OutgoingParts parts;
  parts.hold(numbered(kFirstLongEvent, 4'500), 0);
  ASSERT_THAT(write_all(parts, {}), ElementsAre(0, 1'000, 2'000, 3'000, 4'000));

  EXPECT_THAT(write_all(parts, Duration::milliseconds(299)), IsEmpty());
  EXPECT_THAT(write_all(parts, kTimeOut), ElementsAre(4'000));
  EXPECT_THAT(write_all(parts, kTimeOut + kTimeOut), ElementsAre(4'000));
}

// Each part that was under way behind it names the gap.
TEST(OutgoingParts, WhatThePeerLacksIsWrittenAgainAtOnceAndOnce) {
  OutgoingParts parts;
  parts.hold(numbered(kFirstLongEvent, 4'500), 0);
  write_all(parts, {});

  parts.heard(kFirstLongEvent, 1'000, true);
  EXPECT_THAT(write_all(parts, {}), ElementsAre(1'000));
  parts.heard(kFirstLongEvent, 1'000, true);
  EXPECT_THAT(write_all(parts, {}), IsEmpty());
  parts.heard(kFirstLongEvent, 3'000, true);
  EXPECT_THAT(write_all(parts, {}), ElementsAre(3'000)) << "another gap";

  EXPECT_THAT(write_all(parts, kTimeOut), ElementsAre(3'000)) << "it was lost once more";
  parts.heard(kFirstLongEvent, 4'000, false);
  EXPECT_THAT(write_all(parts, kTimeOut + kTimeOut), ElementsAre(4'000));
}

// What is said for the first time goes on behind it.
TEST(OutgoingParts, AGapIsFilledBeforeWhatFollows) {
  OutgoingParts parts;
  parts.hold(numbered(kFirstLongEvent, 4'500), 0);
  for (int i = 0; i < 3; ++i) parts.written(*parts.next({}, 1'000, kTimeOut), {});

  parts.heard(kFirstLongEvent, 0, true);

  EXPECT_THAT(write_all(parts, {}), ElementsAre(0, 3'000, 4'000));
}

// A sender that comes back holds what it had said before too.
TEST(OutgoingParts, WhatThePeerHadBeforeTheOneThatItNamesIsOver) {
  OutgoingParts parts;
  for (const std::uint64_t receipt : {31, 0, 33, 34})
    parts.hold(numbered(parts.next_number(), 50'000), receipt);
  EXPECT_THAT(parts.heard(kFirstLongEvent + 9, 5'000, false), IsEmpty()) << "one that nobody said";
  ASSERT_EQ(parts.size(), 4U);

  EXPECT_THAT(parts.heard(kFirstLongEvent + 3, 5'000, false), ElementsAre(31, 33));

  EXPECT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts.settled(), kFirstLongEvent + 2);
  EXPECT_EQ(parts.next({}, 1'000, kTimeOut)->offset, 5'000U);
}

TEST(OutgoingParts, WhatWasAcknowledgedInAFormerLifeIsNotSaidAgain) {
  OutgoingParts parts;
  for (int i = 0; i < 3; ++i) parts.hold(numbered(parts.next_number(), 50'000), 0);

  parts.recall_acknowledged(kFirstLongEvent + 1);

  EXPECT_EQ(parts.next({}, 1'000, kTimeOut)->number, kFirstLongEvent + 2);
}

// Its receiver compares the incarnation of the event with that of its parts.
TEST(OutgoingParts, WhoTakesAnotherIncarnationSaysItInTheEventToo) {
  OutgoingParts out;
  out.hold(numbered(kFirstLongEvent, 5'000), 0);
  out.become(7);
  IncomingParts in;
  std::optional<std::variant<wire::Sample, Malformed>> whole;
  while (const auto part = out.next({}, 1'000, kTimeOut)) {
    out.written(*part, {});
    whole = in.take(with_header(*part, 7));
  }

  ASSERT_TRUE(whole.has_value());
  EXPECT_EQ(wire::header_of(std::get<wire::Sample>(*whole)).incarnation, 7U);
}

TEST(OutgoingParts, WhatExpiresIsToldAndMakesWayForTheNext) {
  OutgoingParts parts;
  wire::Sample first = numbered(kFirstLongEvent, 50'000);
  wire::header_of(first).expires = 1'000'000'000;
  parts.hold(first, 9);
  parts.hold(numbered(kFirstLongEvent + 1, 50'000), 0);

  const auto expired = parts.expire(MissionTime::seconds(2));

  ASSERT_EQ(expired.size(), 1U);
  EXPECT_EQ(expired[0].slot, wire::Slot::kHandOver);
  EXPECT_EQ(expired[0].receipt, 9U);
  EXPECT_FALSE(expired[0].may_have_arrived);
  EXPECT_EQ(parts.next({}, 1'000, kTimeOut)->number, kFirstLongEvent + 1);
}

TEST(IncomingParts, WhatComesBehindAGapIsKeptAndTheGapIsNamed) {
  OutgoingParts out;
  out.hold(numbered(kFirstLongEvent, 3'500), 0);
  std::vector<wire::Part> all;
  while (const auto part = out.next({}, 1'000, kTimeOut)) {
    out.written(*part, {});
    all.push_back(with_header(*part));
  }
  ASSERT_EQ(all.size(), 4U);
  IncomingParts in;
  const auto lacks_after = [&](std::size_t part) {
    EXPECT_FALSE(in.take(all[part]).has_value());
    return in.ack_lacks();
  };

  EXPECT_TRUE(lacks_after(1)) << "the first was lost";
  EXPECT_FALSE(lacks_after(0));
  EXPECT_EQ(in.ack_bytes(), 2'000U);
  EXPECT_FALSE(lacks_after(0)) << "comes twice";
  EXPECT_TRUE(lacks_after(3));
  EXPECT_EQ(in.ack_bytes(), 2'000U);

  const auto whole = in.take(all[2]);
  ASSERT_TRUE(whole.has_value());
  EXPECT_EQ(std::get<wire::Sample>(*whole), numbered(kFirstLongEvent, 3'500));
  EXPECT_FALSE(in.take(all[2]).has_value()) << "again, before it was handled";
}

TEST(IncomingParts, KeepNoMoreBehindAGapThanMayBeUnderWay) {
  static_assert(IncomingParts::kMostLater == OutgoingParts::kPartsUnderWay);
  OutgoingParts out;
  out.hold(numbered(kFirstLongEvent, 50'000), 0);
  const wire::Part first = with_header(*out.next({}, 1'000, kTimeOut));
  IncomingParts in;
  for (std::uint32_t i = 1; i < 30; ++i) {
    wire::Part later = first;
    later.offset = i * 1'000;
    in.take(later);
  }

  in.take(first);

  EXPECT_EQ(in.ack_bytes(), 1'000 * (1 + IncomingParts::kMostLater));
}

TEST(IncomingParts, RefusesWhatMakesNoSense) {
  IncomingParts parts;
  wire::Part part;
  part.number = kFirstLongEvent;
  part.of_slot = static_cast<std::uint8_t>(wire::Slot::kHandOver);
  part.total = 4;
  part.content = {0, 1, 0, 0};
  const auto refused = [&](auto spoil) {
    wire::Part other = with_header(part);
    spoil(other);
    return !parts.take(other) && !parts.owes();
  };

  EXPECT_TRUE(refused([](wire::Part& it) { it.of_slot = 255; }));
  EXPECT_TRUE(refused(
      [](wire::Part& it) { it.of_slot = static_cast<std::uint8_t>(wire::Slot::kHeartbeat); }));
  EXPECT_TRUE(refused([](wire::Part& it) { it.total = 3; }));
  EXPECT_TRUE(refused([](wire::Part& it) { it.total = IncomingParts::kLongest + 1; }));
  EXPECT_TRUE(refused([](wire::Part& it) { it.offset = 4; }));
  EXPECT_TRUE(refused([](wire::Part& it) { it.content.clear(); }));
  const auto whole = parts.take(with_header(part));
  ASSERT_TRUE(whole.has_value()) << "whole, and cut short";
  EXPECT_TRUE(std::holds_alternative<Malformed>(*whole));
}

// A way between the two on which anything happens: parts and answers are lost and come twice,
// either is restarted. What a restarted receiver had handled it knows; a restarted sender says all
// again.
RC_GTEST_PROP(LongEvents, EachComesWholeAndOnceWhateverHappensOnTheWay, ()) {
  const auto sizes =
      *rc::gen::resize(5, rc::gen::nonEmpty(rc::gen::container<std::vector<std::uint16_t>>(
                              rc::gen::inRange<std::uint16_t>(20, 30'000))));
  const auto fates =
      *rc::gen::container<std::vector<std::uint8_t>>(200, rc::gen::inRange<std::uint8_t>(0, 40));
  OutgoingParts out;
  IncomingParts in;
  std::vector<std::uint64_t> handled;
  std::size_t turn = 0;
  const auto fate = [&] { return turn < fates.size() ? fates[turn++] : 39; };
  const auto hold_all = [&] {
    for (const std::uint16_t size : sizes) out.hold(numbered(out.next_number(), size), 0);
  };
  hold_all();

  for (Duration now; !out.empty(); now = now + Duration::milliseconds(100)) {
    RC_ASSERT(now < Duration::milliseconds(10'000'000));
    while (const auto part = out.next(now, 700, kTimeOut)) {
      out.written(*part, now);
      const int what = fate();
      const int copies = what < 8 ? 0 : what < 12 ? 2 : 1;
      for (int copy = 0; copy < copies; ++copy) {
        const auto event = in.take(with_header(*part));
        if (!event) continue;
        const auto& sample = std::get<wire::Sample>(*event);
        const std::uint64_t number = wire::header_of(sample).sequence_number;
        RC_ASSERT(sample == numbered(number, sizes[number - kFirstLongEvent]));
        handled.push_back(number);
        in.commit();
      }
      if (what == 13) {
        in = IncomingParts();
        if (!handled.empty()) in.recall(1, handled.back());
      }
      if (what == 14) {
        out = OutgoingParts();
        hold_all();
      }
    }
    if (in.owes() && fate() >= 8) {
      out.heard(in.ack_number(), in.ack_bytes(), in.ack_lacks());
      in.told();
    }
  }

  RC_ASSERT(handled.size() == sizes.size());
  for (std::size_t i = 0; i < handled.size(); ++i) RC_ASSERT(handled[i] == kFirstLongEvent + i);
}

// ---- two nodes ----

/// A UAV and its ground station with a channel of some capacity, in virtual time.
class Pair {
 public:
  explicit Pair(double capacity, double loss = 0) : capacity_(capacity), loss_(loss) {
    start(kGround);
    start(kUav);
    run_for(Duration::milliseconds(3'000));
  }

  void start(const Node& node) {
    Config config;
    config.self = node.number;
    config.incarnation = ++incarnations_[node.number];
    config.channels = station_link(kGround, kUav);
    for (ChannelConfig& channel : config.channels) channel.capacity = capacity_;
    config.heartbeat_period = Duration::milliseconds(1'000);
    config.retransmission = Duration::milliseconds(1'500);
    config.seed = incarnations_[node.number];
    boards_.start(config);
    set_up(true);
  }
  void set_up(bool up) {
    boards_.set_condition(kUav.number, kGround.number,
                          {up, Duration::milliseconds(20), loss_, capacity_});
  }
  void send(const Node& from, const Node& to, wire::Sample sample, SendOptions options = {}) {
    if (auto* event = std::get_if<wire::TaskEvent>(&sample)) sent_[event->id] = time();
    ASSERT_TRUE(boards_[from.number].send(std::move(sample), to.number, now(), options));
    boards_.settle();
  }
  void run_for(Duration span) { run_until(time() + span); }
  void run_until(Duration until) { boards_.run_until(until); }
  Duration time() const { return boards_.time(); }
  Now now() const { return boards_.now(); }
  std::size_t waiting() { return boards_[kUav.number].unacknowledged(kGround.number); }

  std::vector<std::uint64_t> whole;  ///< degrees of what was handed over, as they came
  std::vector<double> latencies;     ///< of the other events [s]
  std::vector<std::uint64_t> events;
  std::size_t streams = 0;
  std::vector<EventExpired> expired;
  std::vector<std::uint64_t> receipts;
  int lost_contacts = 0;
  Duration last_whole;

 private:
  void see(const Incoming& incoming) {
    if (const auto* reach = std::get_if<Reachability>(&incoming))
      lost_contacts += reach->reachable ? 0 : 1;
    if (const auto* one = std::get_if<EventExpired>(&incoming)) expired.push_back(*one);
    if (const auto* one = std::get_if<EventDelivered>(&incoming)) receipts.push_back(one->receipt);
    const auto* received = std::get_if<Received>(&incoming);
    if (received == nullptr) return;
    if (const auto* event = std::get_if<wire::TaskEvent>(&received->sample)) {
      latencies.push_back((time() - sent_.at(event->id)).to_seconds());
      events.push_back(event->id);
    } else if (std::holds_alternative<wire::Telemetry>(received->sample)) {
      ++streams;
    } else if (const auto* one = std::get_if<wire::HandOver>(&received->sample)) {
      std::size_t bytes = 0;
      for (const wire::GoalEntry& goal : one->goals) bytes += goal.statement.size();
      EXPECT_EQ(one->goals, hand_over(one->goals.front().id, bytes).goals);
      whole.push_back(one->goals.front().id);
      last_whole = time();
    }
  }

 public:
  static constexpr std::size_t kMegabyte = 1'000'000;

 private:
  double capacity_, loss_;
  testing::MemoryBoards boards_{[this](NodeNumber, const Incoming& incoming) { see(incoming); }};
  std::map<NodeNumber, std::uint64_t> incarnations_;
  std::map<std::uint64_t, Duration> sent_;
};

/// A minute of events and telemetry, five samples a second.
void load(Pair& pair) {
  const Duration begin = pair.time();
  std::uint64_t id = pair.events.empty() ? 0 : pair.events.back();
  for (std::int64_t i = 1; i <= 300; ++i) {
    pair.run_until(begin + Duration::milliseconds(200 * i));
    pair.send(kUav, kGround, telemetry(0.5));
    if (i % 10 == 3) pair.send(kUav, kGround, task_event(++id));
  }
}

double worst(const std::vector<double>& all) { return *std::ranges::max_element(all); }

TEST(LongEvents, AMegabyteGoesBesideTelemetryAndCommandsOverANarrowRadio) {
  Pair quiet(9'600);
  load(quiet);
  Pair busy(9'600);
  busy.send(kUav, kGround, hand_over(1, Pair::kMegabyte), {MissionTime::max(), 77});
  load(busy);

  EXPECT_EQ(busy.events.size(), 30U);
  EXPECT_TRUE(std::ranges::is_sorted(busy.events));
  EXPECT_LE(worst(busy.latencies), worst(quiet.latencies) + 1.0)
      << "an event waits for the part that is under way, and a stream";
  EXPECT_GE(static_cast<double>(busy.streams), 0.5 * static_cast<double>(quiet.streams));
  EXPECT_EQ(busy.lost_contacts, 0);
  EXPECT_THAT(busy.whole, IsEmpty()) << "it takes 1,100 s of this radio";
  busy.run_for(Duration::milliseconds(2'000'000));
  EXPECT_THAT(busy.whole, ElementsAre(1));
  EXPECT_THAT(busy.receipts, ElementsAre(77));
  EXPECT_EQ(busy.waiting(), 0U);
  EXPECT_LT(busy.last_whole.to_seconds(), 1'400) << "what nobody wants it gets";
  RecordProperty("quiet_worst", std::to_string(worst(quiet.latencies)));
  RecordProperty("busy_worst", std::to_string(worst(busy.latencies)));
  RecordProperty("seconds", std::to_string(busy.last_whole.to_seconds()));
}

TEST(LongEvents, ComeInTheirOrderAndOnceAcrossCutsLossAndARestartOfTheReceiver) {
  Pair pair(500'000, 0.1);
  for (std::uint64_t id = 1; id <= 3; ++id)
    pair.send(kUav, kGround, hand_over(id, Pair::kMegabyte));
  pair.run_for(Duration::milliseconds(8'000));
  pair.set_up(false);
  pair.run_for(Duration::milliseconds(10'000));
  pair.set_up(true);
  pair.run_for(Duration::milliseconds(5'000));
  ASSERT_LT(pair.whole.size(), 3U);
  pair.start(kGround);
  pair.run_for(Duration::milliseconds(400'000));

  EXPECT_THAT(pair.whole, ElementsAre(1, 2, 3));
  EXPECT_EQ(pair.waiting(), 0U);
}

TEST(LongEvents, OneThatExpiresUnderWayIsToldToItsSenderAndToNobodyElse) {
  Pair pair(9'600);
  pair.send(kUav, kGround, hand_over(1, Pair::kMegabyte), {MissionTime::seconds(60), 5});
  pair.send(kUav, kGround, hand_over(2, 40'000));
  pair.run_for(Duration::milliseconds(200'000));

  ASSERT_EQ(pair.expired.size(), 1U);
  EXPECT_EQ(pair.expired[0].receipt, 5U);
  EXPECT_EQ(pair.expired[0].from, kUav.number);
  EXPECT_GE(pair.expired[0].sequence, kFirstLongEvent);
  EXPECT_THAT(pair.receipts, IsEmpty());
  EXPECT_EQ(pair.waiting(), 0U);
}

TEST(LongEvents, AreRefusedWhenThereAreTooManyOrTheyAreTooLong) {
  MemoryHub hub;
  MemoryTransport transport(hub);
  Config config;
  config.self = kUav.number;
  config.channels = station_link(kGround, kUav);
  auto board = Blackboard::open(config, transport);
  ASSERT_TRUE(board.has_value());

  const auto too_long = board->send(hand_over(1, 17U << 20U), kGround.number, {});
  ASSERT_FALSE(too_long.has_value());
  EXPECT_EQ(too_long.error(), Refusal::kTooLong);
  for (std::size_t i = 0; i < OutgoingParts::kMostHeld; ++i)
    EXPECT_TRUE(board->send(hand_over(1, 20'000), kGround.number, {}).has_value());
  const auto too_many = board->send(hand_over(1, 20'000), kGround.number, {});
  ASSERT_FALSE(too_many.has_value());
  EXPECT_EQ(too_many.error(), Refusal::kFull);
  EXPECT_TRUE(board->send(task_event(1), kGround.number, {}).has_value());
}

TEST(OutgoingParts, IsFullWithSoManyAndWithSoMuch) {
  OutgoingParts few;
  while (!few.full()) few.hold(numbered(few.next_number(), 5'000'000), 0);
  EXPECT_EQ(few.size(), 4U);
  few.give_up(kFirstLongEvent + 1);
  EXPECT_FALSE(few.full());
  few.heard(kFirstLongEvent + 2, 0, false);
  few.hold(numbered(few.next_number(), 5'000'000), 0);
  EXPECT_FALSE(few.full());

  OutgoingParts many;
  while (!many.full()) many.hold(numbered(many.next_number(), 100), 0);
  EXPECT_EQ(many.size(), OutgoingParts::kMostHeld);
}

}  // namespace
}  // namespace skein::blackboard
