// SPDX-License-Identifier: Apache-2.0
// A channel that cannot carry everything: who goes first, what is shed, what is kept.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <vector>

#include "channel_schedule.hpp"
#include "limited_channel.hpp"
#include "skein/blackboard/blackboard.hpp"
#include "testing/memory_boards.hpp"
#include "testing/samples.hpp"
#include "waiting_values.hpp"

namespace skein::blackboard {
namespace {

using ::testing::ElementsAre;
using ::testing::Le;
using testing::task_event;

// ---- the schedule ----

/// Plays a schedule whose flows always have something to send.
std::vector<std::size_t> bytes_of_flows(ChannelSchedule& schedule,
                                        const std::vector<std::size_t>& sizes, Duration until) {
  std::vector<std::size_t> sent(sizes.size(), 0);
  for (Duration now; now < until; now = schedule.free_at()) {
    const auto flow = schedule.pick(sizes, now);
    RC_ASSERT(flow.has_value());
    schedule.write(*flow, sizes[*flow], now);
    sent[*flow] += sizes[*flow];
  }
  return sent;
}

RC_GTEST_PROP(ChannelSchedule, NoFlowGetsLessThanItsFractionAndNothingIsLeftIdle, ()) {
  const auto parts = *rc::gen::resize(
      6, rc::gen::nonEmpty<std::vector<std::tuple<std::uint8_t, std::uint8_t, std::uint16_t>>>(
             rc::gen::container<std::vector<std::tuple<std::uint8_t, std::uint8_t, std::uint16_t>>>(
                 rc::gen::tuple(rc::gen::inRange<std::uint8_t>(0, 100),
                                rc::gen::inRange<std::uint8_t>(0, 4),
                                rc::gen::inRange<std::uint16_t>(50, 1500)))));
  const double capacity = *rc::gen::inRange(5'000, 1'000'000);
  double whole = 1;
  for (const auto& part : parts) whole += std::get<0>(part);
  std::vector<SlotShare> shares;
  std::vector<std::size_t> sizes;
  for (const auto& [fraction, priority, size] : parts) {
    shares.push_back({fraction / whole, priority});
    sizes.push_back(size);
  }
  ChannelSchedule schedule(shares);
  schedule.set_capacity(capacity, {});
  const Duration time = Duration::milliseconds(200'000);

  const auto sent = bytes_of_flows(schedule, sizes, time);

  const double could = capacity / 8 * time.to_seconds();
  const double all = static_cast<double>(std::accumulate(sent.begin(), sent.end(), 0UL));
  double samples = 0;
  for (std::size_t i = 0; i < sent.size(); ++i)
    samples += static_cast<double>(sent[i]) / static_cast<double>(sizes[i]);
  const double rounded = samples * capacity / 8 * 1e-9;  // an airtime is of whole nanoseconds
  RC_ASSERT(all >= could - 1 - rounded);
  const auto longest = static_cast<double>(*std::max_element(sizes.begin(), sizes.end()));
  for (std::size_t i = 0; i < shares.size(); ++i) {
    // Whoever waits is behind by the longest of each of the others, and by what they had saved.
    const double behind = static_cast<double>(shares.size()) * (longest + 512) + could / 100;
    RC_ASSERT(static_cast<double>(sent[i]) >= shares[i].fraction * could - behind);
  }
}

TEST(ChannelSchedule, WhatNobodyReservedGoesByPriority) {
  ChannelSchedule schedule({{0, 1}, {0, 3}, {0, 2}});
  schedule.set_capacity(8'000, {});
  std::vector<std::size_t> waiting{100, 100, 100};
  std::vector<std::size_t> order;

  for (Duration now; order.size() < 3; now = schedule.free_at()) {
    const auto flow = schedule.pick(waiting, now);
    order.push_back(*flow);
    waiting[*flow] = 0;
    schedule.write(*flow, 100, now);
  }

  EXPECT_THAT(order, ElementsAre(1, 2, 0));
  EXPECT_EQ(schedule.free_at(), Duration::milliseconds(300));
}

TEST(ChannelSchedule, NothingWaitsOnAnUnlimitedChannel) {
  const ChannelSchedule schedule({{0.5, 1}});

  EXPECT_FALSE(schedule.limited());
  EXPECT_EQ(schedule.airtime(1'000'000), Duration{});
}

TEST(SlotShares, WhatShipsFitsAChannelAndReservesMostOfIt) {
  EXPECT_LE(reserved(default_shares()), 1);
  EXPECT_GT(reserved(default_shares()), 0.5);
}

// ---- what waits ----

// As long as that of a UAV that flies.
wire::Sample telemetry(std::uint32_t instance, double energy) {
  wire::Telemetry telemetry;
  telemetry.uav = "marvin";
  telemetry.activity = "goto";
  telemetry.header.instance = instance;
  telemetry.energy = static_cast<float>(energy);
  return telemetry;
}

TEST(WaitingValues, ANewerValueTakesThePlaceOfTheOlder) {
  WaitingValues values;
  EXPECT_FALSE(values.put(telemetry(1, 0.1)));
  EXPECT_FALSE(values.put(telemetry(2, 0.2)));

  EXPECT_TRUE(values.put(telemetry(1, 0.3)));

  const auto left = values.take(wire::SlotClass::kStream);
  ASSERT_EQ(left.size(), 2U);
  EXPECT_EQ(std::get<wire::Telemetry>(left[0]).energy, 0.3F);
  EXPECT_EQ(std::get<wire::Telemetry>(left[1]).energy, 0.2F);
  EXPECT_TRUE(values.empty());
}

// ---- two nodes ----

const Node kUav{NodeNumber(1), "uav"};
const Node kGround{NodeNumber(2), "ground"};

/// A node that sends over a channel of some capacity to one that notes when what came was sent.
class SlowRadio {
 public:
  explicit SlowRadio(double capacity) : capacity_(capacity) {
    for (const Node& node : {kUav, kGround}) {
      Config config;
      config.self = node.number;
      config.channels = radio_link(kUav, kGround);
      config.heartbeat_period = Duration::milliseconds(1000);
      config.retransmission = Duration::milliseconds(1500);
      boards_.start(config);
    }
    set_up(true);
    run_until(Duration::milliseconds(3'000));
  }

  void send(wire::Sample sample, MissionTime expires = MissionTime::max()) {
    if (auto* event = std::get_if<wire::TaskEvent>(&sample)) sent_[event->id] = time();
    EXPECT_TRUE(
        boards_[kUav.number].send(std::move(sample), kGround.number, boards_.now(), {expires}));
    boards_.settle();
  }
  void run_until(Duration until) { boards_.run_until(until); }
  void set_up(bool up) {
    boards_.set_condition(kUav.number, kGround.number,
                          {up, Duration::milliseconds(20), 0, capacity_});
  }
  Duration time() const { return boards_.time(); }
  MissionTime mission_time() const { return boards_.now().mission; }
  std::uint64_t shed() { return boards_[kUav.number].shed(kGround.number); }
  bool both_reach() {
    return boards_[kUav.number].reachable(kGround.number) &&
           boards_[kGround.number].reachable(kUav.number);
  }

  std::vector<double> latencies;                         ///< of events [s]
  std::vector<std::uint64_t> events;                     ///< ids, in the order handled
  std::map<std::uint32_t, std::vector<double>> streams;  ///< energies by instance, as they came
  std::vector<int> degrees;                              ///< states
  bool lost_contact = false;

 private:
  void see(const Incoming& incoming) {
    if (const auto* reach = std::get_if<Reachability>(&incoming))
      lost_contact = lost_contact || !reach->reachable;
    const auto* received = std::get_if<Received>(&incoming);
    if (received == nullptr) return;
    if (const auto* event = std::get_if<wire::TaskEvent>(&received->sample)) {
      latencies.push_back((time() - sent_.at(event->id)).to_seconds());
      events.push_back(event->id);
    } else if (const auto* one = std::get_if<wire::Telemetry>(&received->sample)) {
      streams[one->header.instance].push_back(one->energy);
    } else if (const auto* degree = std::get_if<wire::AutonomyDegree>(&received->sample)) {
      degrees.push_back(degree->degree);
    }
  }

  double capacity_;
  testing::MemoryBoards boards_{[this](NodeNumber, const Incoming& incoming) { see(incoming); }};
  std::map<std::uint64_t, Duration> sent_;
};

/// Events at odd instants, beside `streams` samples of telemetry a second from each of three
/// origins.
void load(SlowRadio& radio, std::uint64_t events, std::uint32_t streams) {
  const Duration begin = radio.time();
  const std::int64_t step = streams == 0 ? 100'000'000 : 1'000'000'000 / streams;
  Duration next_event = begin + Duration::milliseconds(777);
  std::uint64_t id = 0;
  for (std::int64_t i = 1; id < events; ++i) {
    const Duration tick = begin + Duration::nanoseconds(i * step);
    while (id < events && next_event <= tick) {
      radio.run_until(next_event);
      radio.send(task_event(++id));
      next_event = next_event + Duration::milliseconds(2'111);
    }
    radio.run_until(tick);
    for (std::uint32_t instance = 0; streams > 0 && instance < 3; ++instance)
      radio.send(telemetry(instance, static_cast<double>(i) / 1e6));
  }
  radio.run_until(radio.time() + Duration::milliseconds(20'000));
}

/// By nearest rank.
double quantile(std::vector<double> all, double part) {
  std::sort(all.begin(), all.end());
  const auto rank = static_cast<std::size_t>(std::ceil(part * static_cast<double>(all.size())));
  return all.at(std::max<std::size_t>(rank, 1) - 1);
}

TEST(SlowRadio, EventsKeepTheirLatencyOnASaturatedChannelAndStreamsAreShed) {
  SlowRadio quiet(9'600);
  load(quiet, 100, 0);
  SlowRadio saturated(9'600);
  load(saturated, 100, 10);

  ASSERT_EQ(quiet.latencies.size(), 100U);
  ASSERT_EQ(saturated.latencies.size(), 100U);
  for (std::uint64_t i = 0; i < 100; ++i) EXPECT_EQ(saturated.events[i], i + 1);
  // What is under way is not broken off: an event waits for one sample of telemetry at most, and
  // that is short.
  const Duration longest = airtime(channel_bytes(telemetry(2, 1e-6)), 9'600);
  EXPECT_LE(quantile(saturated.latencies, 1), quantile(quiet.latencies, 1) + longest.to_seconds());
  for (const double part : {0.5, 0.95, 0.99, 1.0})
    EXPECT_LE(quantile(saturated.latencies, part), 2 * quantile(quiet.latencies, part)) << part;
  EXPECT_GT(saturated.shed(), 1000U);
  EXPECT_FALSE(saturated.lost_contact);
  RecordProperty("quiet_median", std::to_string(quantile(quiet.latencies, 0.5)));
  RecordProperty("saturated_median", std::to_string(quantile(saturated.latencies, 0.5)));
  RecordProperty("quiet_p99", std::to_string(quantile(quiet.latencies, 0.99)));
  RecordProperty("saturated_p99", std::to_string(quantile(saturated.latencies, 0.99)));
}

TEST(SlowRadio, WhatComesOfAStreamIsNewAndComesFromEveryOrigin) {
  SlowRadio radio(9'600);
  load(radio, 30, 10);

  ASSERT_EQ(radio.streams.size(), 3U);
  for (const auto& [instance, energies] : radio.streams) {
    EXPECT_GT(energies.size(), 20U) << instance;
    EXPECT_TRUE(std::is_sorted(energies.begin(), energies.end())) << "none overtakes";
    double widest = 0;
    for (std::size_t i = 1; i < energies.size(); ++i)
      widest = std::max(widest, energies[i] - energies[i - 1]);
    EXPECT_LT(widest, 40 / 1e6) << "four seconds without a word of this origin";
  }
}

TEST(SlowRadio, AStateComesThroughWithItsLastValue) {
  SlowRadio radio(9'600);
  load(radio, 3, 10);
  for (int i = 0; i < 50; ++i) {
    wire::AutonomyDegree degree;
    degree.degree = static_cast<std::uint8_t>(1 + i % 5);
    radio.send(degree);
  }
  radio.run_until(radio.time() + Duration::milliseconds(3'000));

  ASSERT_FALSE(radio.degrees.empty());
  EXPECT_EQ(radio.degrees.back(), 5);
  EXPECT_LT(radio.degrees.size(), 5U) << "what was out of date stayed behind";
}

TEST(SlowRadio, WhatIsBeingTransmittedWhenTheLinkGoesDownIsLostAndAnEventComesOnceItIsUp) {
  SlowRadio radio(9'600);
  const auto after = [&](int milliseconds) {
    radio.run_until(radio.time() + Duration::milliseconds(milliseconds));
  };
  radio.send(task_event(1));
  after(50);
  radio.set_up(false);
  after(2'000);
  EXPECT_THAT(radio.events, ::testing::IsEmpty());

  radio.set_up(true);
  after(3'000);
  EXPECT_THAT(radio.events, ElementsAre(1));
}

TEST(SlowRadio, WhatStillCountsAfterACutDoesNotWaitForEachThatExpired) {
  SlowRadio radio(9'600);
  const auto after = [&](int milliseconds) {
    radio.run_until(radio.time() + Duration::milliseconds(milliseconds));
  };
  radio.set_up(false);
  for (std::uint64_t id = 1; id <= 41; ++id) {
    const MissionTime soon = radio.mission_time() + Duration::milliseconds(2'000);
    radio.send(task_event(id), id % 8 == 1 ? MissionTime::max() : soon);
    after(250);
  }
  after(2'500);

  radio.set_up(true);
  const Duration healed = radio.time();
  while (radio.events.size() < 6 && radio.time() < healed + Duration::milliseconds(60'000))
    after(10);

  EXPECT_THAT(radio.events, ElementsAre(1, 9, 17, 25, 33, 41));
  EXPECT_LE((radio.time() - healed).to_seconds(), 3.5);
}

TEST(SlowRadio, WhatIsTransmittedWhenTheLinkGoesDownArrives) {
  SlowRadio radio(9'600);
  radio.send(task_event(1));
  radio.run_until(radio.time() + airtime(channel_bytes(task_event(1)), 9'600) +
                  Duration::milliseconds(1));
  radio.set_up(false);
  radio.run_until(radio.time() + Duration::milliseconds(100));

  EXPECT_THAT(radio.events, ElementsAre(1));
}

TEST(SlowRadio, AFloodOfEventsLeavesRoomForHeartbeatsAndStreams) {
  SlowRadio radio(9'600);
  for (std::uint64_t id = 1; id <= 200; ++id) radio.send(task_event(id));
  for (std::uint32_t i = 0; i < 1'000; ++i) {
    radio.run_until(radio.time() + Duration::milliseconds(100));
    radio.send(telemetry(0, i / 1e6));
  }

  EXPECT_FALSE(radio.lost_contact);
  EXPECT_TRUE(radio.both_reach());
  EXPECT_EQ(radio.events.size(), 200U);
  EXPECT_GT(radio.streams.at(0).size(), 30U);
}

RC_GTEST_PROP(SlowRadio, NoEventIsLostAndContactIsKeptWhateverIsSent, ()) {
  SlowRadio radio(*rc::gen::inRange(4'800, 200'000));
  const auto script = *rc::gen::container<std::vector<std::pair<std::uint8_t, std::uint8_t>>>(
      rc::gen::pair(rc::gen::inRange<std::uint8_t>(0, 4), rc::gen::arbitrary<std::uint8_t>()));
  std::uint64_t id = 0;
  for (const auto& [what, argument] : script) {
    if (what == 0) {
      for (int i = 0; i < argument % 8; ++i) radio.send(task_event(++id));
    } else if (what == 1) {
      for (std::uint32_t i = 0; i < argument; ++i) radio.send(telemetry(i % 5, 0.5));
    } else {
      radio.run_until(radio.time() + Duration::milliseconds(argument * 4));
    }
  }
  radio.run_until(radio.time() +
                  Duration::milliseconds(1'000 + 700 * static_cast<std::int64_t>(id)));

  RC_ASSERT(radio.events.size() == id);
  RC_ASSERT(std::is_sorted(radio.events.begin(), radio.events.end()));
  RC_ASSERT(!radio.lost_contact);
}

}  // namespace
}  // namespace skein::blackboard
