// SPDX-License-Identifier: Apache-2.0
// The laws of relaying: whoever is connected by a way of links hears everything, once, in order.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <memory>

#include "skein/blackboard/cdr.hpp"
#include "testing/radio_net.hpp"
#include "testing/samples.hpp"

namespace skein::blackboard::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Duration seconds(double value) { return Duration::seconds(value); }

std::int64_t between(Random& random, std::int64_t least, std::int64_t most) {
  return least +
         static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(most - least) + 1));
}

/// A chain 1 - 2 - … - n whose inner nodes are relays.
RadioNet::Setup chain(int nodes) {
  RadioNet::Setup setup;
  setup.nodes = nodes;
  for (int relay = 2; relay < nodes; ++relay) setup.relays.insert(relay);
  return setup;
}

void cut_to_chain(RadioNet& net, int nodes) {
  for (int a = 1; a <= nodes; ++a) {
    for (int b = a + 2; b <= nodes; ++b) net.set_both(a, b, false);
  }
}

TEST(Relaying, AnEventReachesWhomOnlyARelayHears) {
  RadioNet net(chain(3));
  cut_to_chain(net, 3);
  const auto event = net.send_event(1, 3);

  ASSERT_TRUE(net.run_until([&] { return !net.handled(3, 1).empty(); }, seconds(3)));
  net.run_for(seconds(5));

  EXPECT_THAT(net.handled(3, 1), ElementsAre(event));
  EXPECT_THAT(net.handled(2, 1), IsEmpty());
  EXPECT_TRUE(net.reachable(1, 3));
  EXPECT_TRUE(net.reachable(3, 1));
}

TEST(Relaying, NobodyPassesOnAnythingWhoIsNotDeclaredARelay) {
  RadioNet::Setup setup;
  setup.nodes = 4;
  setup.relays = {4};
  RadioNet net(setup);
  net.set_both(1, 3, false);
  net.set_both(1, 4, false);
  net.set_both(3, 4, false);
  net.send_event(1, 3);
  net.run_for(seconds(20));

  EXPECT_THAT(net.handled(3, 1), IsEmpty());
  EXPECT_FALSE(net.reachable(1, 3));
}

TEST(Relaying, StatesAndStreamsGoPastAChainOfThreeRelays) {
  RadioNet net(chain(5));
  cut_to_chain(net, 5);
  net.set_state(1, 5, 7);
  ASSERT_TRUE(net.run_until([&] { return net.state(5, 1) == 7; }, seconds(3)));
  net.send_stream(1, 5, 0.5);
  EXPECT_TRUE(net.run_until([&] { return !net.streams(5, 1).empty(); }, seconds(1)));
  EXPECT_EQ(net.routes(1).back().relays, 3U);
  EXPECT_EQ(net.routes(1).back().via, NodeNumber(2));
}

// Found by a random mission: the ground station got what had been saved up for five minutes first.
TEST(Relaying, OnANarrowChannelWhatOneHasMissedKeepsNoOtherWaiting) {
  RadioNet::Setup setup = chain(4);  // 1 is heard past 2 alone
  setup.relays = {2};
  setup.capacity = 19'200;
  setup.period = seconds(1);
  RadioNet net(setup);
  net.set_both(1, 3, false);
  net.set_both(1, 4, false);
  net.run_for(seconds(20));
  net.set_both(1, 2, false);
  net.run_for(seconds(10));
  for (int i = 0; i < 150; ++i) net.send_event(1, 3);
  const auto event = net.send_event(1, 4);
  net.set_both(1, 2, true);

  ASSERT_TRUE(net.run_until([&] { return net.reachable(1, 4); }, seconds(5)));
  ASSERT_TRUE(net.run_until([&] { return !net.handled(4, 1).empty(); }, seconds(3)));
  EXPECT_THAT(net.handled(4, 1), ElementsAre(event));
  EXPECT_LT(net.handled(3, 1).size(), 75U) << "nothing was saved up";
  EXPECT_TRUE(net.run_until([&] { return net.handled(3, 1).size() == 150; }, seconds(60)));
}

TEST(Relaying, AnotherRelayTakesOverWhenOneDies) {
  RadioNet::Setup setup;
  setup.nodes = 4;
  setup.relays = {2, 3};
  RadioNet net(setup);
  net.set_both(1, 4, false);
  std::vector<std::uint64_t> sent;
  for (int i = 0; i < 40; ++i) {
    if (i == 15) net.kill(2);
    sent.push_back(net.send_event(1, 4));
    net.set_state(1, 4, static_cast<std::uint64_t>(i) + 1);
    net.run_for(seconds(0.2));
  }
  ASSERT_TRUE(net.run_until([&] { return net.handled(4, 1).size() == sent.size(); }, seconds(3)));
  EXPECT_EQ(net.handled(4, 1), sent);
  EXPECT_EQ(net.state(4, 1), 40U);
  EXPECT_EQ(net.routes(1).back().via, NodeNumber(3));
  EXPECT_TRUE(net.reachable(1, 4));
}

TEST(Relaying, WhatIsUnderWaySurvivesARestartOfTheOnlyRelay) {
  RadioNet net(chain(3));
  cut_to_chain(net, 3);
  net.run_for(seconds(2));
  std::vector<std::uint64_t> sent;
  for (int i = 0; i < 30; ++i) {
    if (i == 10) net.kill(2);
    if (i == 20) net.start(2);
    sent.push_back(net.send_event(1, 3));
    net.set_state(3, 1, static_cast<std::uint64_t>(i) + 1);
    net.run_for(seconds(0.1));
  }
  ASSERT_TRUE(net.run_until([&] { return net.handled(3, 1).size() == sent.size(); }, seconds(3)));
  EXPECT_EQ(net.handled(3, 1), sent);
  EXPECT_EQ(net.state(1, 3), 30U);
}

TEST(Relaying, InAFullMeshOfTenAnEventCrossesOneChannelOnce) {
  RadioNet::Setup setup;
  setup.nodes = 10;
  for (int node = 1; node <= 10; ++node) setup.relays.insert(node);
  RadioNet net(setup);
  net.run_for(seconds(2));
  for (int from = 1; from <= 10; ++from) {
    for (int to = 1; to <= 10; ++to) {
      if (from != to) net.send_event(from, to);
    }
  }
  net.run_for(seconds(3));
  EXPECT_EQ(net.crossings().size(), 90U);
  for (const auto& [crossing, times] : net.crossings()) EXPECT_EQ(times, 1);
}

TEST(Relaying, ALinkInOneDirectionIsUsedInThatOneOnly) {
  RadioNet::Setup setup;
  setup.nodes = 3;
  setup.relays = {2};
  RadioNet net(setup);
  net.run_for(seconds(1));
  net.set_link(3, 1, false);  // 1 does not hear 3, 3 hears 1
  net.run_for(seconds(3));
  EXPECT_THAT(net.routes(1), IsEmpty());
  ASSERT_FALSE(net.routes(3).empty());
  EXPECT_EQ(net.routes(3).back().via, NodeNumber(2));
  const auto there = net.send_event(1, 3);
  const auto back = net.send_event(3, 1);
  net.run_for(seconds(1));
  EXPECT_THAT(net.handled(3, 1), ElementsAre(there));
  EXPECT_THAT(net.handled(1, 3), ElementsAre(back));
}

TEST(Relaying, ContactIsNotLostWhileARelayTakesOverFromALinkThatIsCut) {
  RadioNet::Setup setup;
  setup.nodes = 3;
  setup.relays = {2};
  RadioNet net(setup);
  net.run_for(seconds(2));
  net.set_both(1, 3, false);
  EXPECT_FALSE(
      net.run_until([&] { return !net.reachable(1, 3) || !net.reachable(3, 1); }, seconds(20)));
  net.set_both(1, 3, true);
  EXPECT_FALSE(
      net.run_until([&] { return !net.reachable(1, 3) || !net.reachable(3, 1); }, seconds(20)));
  EXPECT_EQ(net.routes(1).back().via, std::nullopt);
}

TEST(Relaying, WhoIsOutOfReachOfAllIsLostSoonAfter) {
  RadioNet net(chain(4));
  cut_to_chain(net, 4);
  net.run_for(seconds(3));
  ASSERT_TRUE(net.reachable(1, 4));
  net.set_both(3, 4, false);
  EXPECT_TRUE(net.run_until([&] { return !net.reachable(1, 4); }, seconds(2.5)));  // 10 periods
  EXPECT_TRUE(net.reachable(1, 3));
}

TEST(Relaying, NoSamplePassesMoreRelaysThanDeclared) {
  RadioNet::Setup setup = chain(6);
  setup.most_relays = 2;
  RadioNet net(setup);
  cut_to_chain(net, 6);
  net.send_event(1, 6);
  const auto near = net.send_event(1, 4);
  net.run_for(seconds(10));
  EXPECT_THAT(net.handled(6, 1), IsEmpty());
  EXPECT_THAT(net.handled(4, 1), ElementsAre(near));
  EXPECT_THAT(net.breaches(), IsEmpty());
}

TEST(Relaying, AFlappingLinkDoesNotPullTheWayToAndFro) {
  RadioNet::Setup setup;
  setup.nodes = 3;
  setup.relays = {2};
  RadioNet net(setup);
  net.run_for(seconds(2));
  for (int i = 0; i < 10; ++i) {  // up for 3 heartbeats, down for 5
    net.set_both(1, 3, false);
    net.run_for(seconds(1.25));
    net.set_both(1, 3, true);
    net.run_for(seconds(0.75));
  }
  EXPECT_EQ(net.routes(1).size(), 1U);
}

// What a node that is a relay, and changed, might try at another one.
class LyingRelay : public ::testing::Test {
 protected:
  static constexpr std::uint32_t kGroundNumber = 1, kRelay = 2, kVictim = 3;
  static const Node& node(std::uint32_t number) {
    static const std::vector<Node> nodes{
        {NodeNumber(1), "ground"}, {NodeNumber(2), "relay"}, {NodeNumber(3), "victim"}};
    return nodes.at(number - 1);
  }
  void SetUp() override {
    Config config;
    config.self = NodeNumber(kVictim);
    config.relaying.relays = {NodeNumber(kRelay)};
    std::vector<ChannelConfig> channels = station_link(node(1), node(3));
    for (const auto& channel : radio_link(node(2), node(3))) channels.push_back(channel);
    for (ChannelConfig& channel : channels) {
      RelayEnds ends;
      ends.from = channel.from == NodeNumber(kRelay);
      ends.to = channel.to == NodeNumber(kRelay);
      ends.from_station = channel.from == NodeNumber(kGroundNumber);
      ends.to_station = channel.to == NodeNumber(kGroundNumber);
      add_relayed(channel, ends);
    }
    config.channels = channels;
    auto opened = Blackboard::open(std::move(config), transport_);
    ASSERT_TRUE(opened);
    victim_ = std::make_unique<Blackboard>(std::move(*opened));
  }
  /// The field that is found wrong; empty if nothing is.
  std::string refused(wire::Sample sample, std::uint32_t origin, std::vector<std::uint32_t> via,
                      const std::string& partition = "radio/relay>victim") {
    wire::SampleHeader& header = wire::header_of(sample);
    header.origin = origin;
    header.destination = kVictim;
    header.incarnation = 1;
    header.sequence_number = ++sequence_;
    header.via = std::move(via);
    hub_.inject(partition, sample);
    for (const Incoming& one : victim_->step({}))
      if (const auto* dropped = std::get_if<Dropped>(&one)) return dropped->field;
    return "";
  }

  MemoryHub hub_;
  MemoryTransport transport_{hub_};
  std::unique_ptr<Blackboard> victim_;
  std::uint64_t sequence_ = 0;
};

TEST_F(LyingRelay, MayPassOnAnOrderButNotGiveOne) {
  EXPECT_EQ(refused(wire::DegreeCommand{}, kGroundNumber, {kRelay}), "");
  EXPECT_EQ(refused(wire::DegreeCommand{}, kRelay, {}), "header.origin");
}

TEST_F(LyingRelay, CannotHideThatItPassedSomethingOn) {
  EXPECT_EQ(refused(wire::DegreeCommand{}, kGroundNumber, {}), "header.origin");
  EXPECT_EQ(refused(wire::Telemetry{}, kGroundNumber, {kRelay, 7}), "header.via");
  EXPECT_EQ(refused(wire::Telemetry{}, kGroundNumber, {7, kRelay}), "");
}

TEST_F(LyingRelay, CannotInventNodesNorPassRoundInCircles) {
  EXPECT_EQ(refused(wire::Telemetry{}, 66, {kRelay}), "header.origin");
  EXPECT_EQ(refused(wire::Telemetry{}, kGroundNumber, {kGroundNumber, kRelay}), "header.origin");
  EXPECT_EQ(refused(wire::Telemetry{}, kGroundNumber, {7, 8, 9, 10, 11, 12, 13, 14, kRelay}),
            "header.via");
}

TEST_F(LyingRelay, WhoIsNoRelayPassesNothingOn) {
  EXPECT_EQ(refused(wire::Telemetry{}, kRelay, {kGroundNumber}, "radio/ground>victim"),
            "header.via");
}

// While the ways change a relay may take the way that it came by for the shorter one.
TEST_F(LyingRelay, MaySendALongStateBackToWhereItBegan) {
  wire::AutonomyDegree state = degree(4);
  state.header.origin = kVictim;
  state.header.destination = kGroundNumber;
  state.header.incarnation = state.header.sequence_number = 1;
  state.header.via = {kRelay};
  wire::Part part;
  part.number = 1;
  part.of_slot = static_cast<std::uint8_t>(wire::Slot::kAutonomyDegree);
  part.content = in_cdr(state);
  part.total = static_cast<std::uint32_t>(part.content.size());

  EXPECT_EQ(refused(part, kRelay, {}), "");
}

// Random systems.

/// To whom there is a way from a node, past relays that live, over links that are up both ways.
std::set<int> in_reach(const RadioNet& net, const RadioNet::Setup& setup, int from) {
  std::set<int> met{from};
  for (std::deque<int> ends{from}; !ends.empty(); ends.pop_front()) {
    const int end = ends.front();
    if (end != from && !setup.relays.contains(end)) continue;
    for (int to = 1; to <= setup.nodes; ++to) {
      const bool linked = net.lives(to) && net.is_up(end, to) && net.is_up(to, end);
      if (linked && met.insert(to).second) ends.push_back(to);
    }
  }
  return met;
}

class RandomRelaying : public ::testing::TestWithParam<int> {
 protected:
  static RadioNet::Setup random_setup(Random& random, int seed) {
    RadioNet::Setup setup;
    setup.nodes = static_cast<int>(between(random, 3, 8));
    setup.seed = static_cast<std::uint64_t>(seed);
    setup.loss = random.chance(0.5) ? random.uniform(0, 0.3) : 0;
    setup.latency = Duration::milliseconds(between(random, 0, 60));
    for (int node = 1; node <= setup.nodes; ++node) {
      if (random.chance(0.6)) setup.relays.insert(node);
    }
    if (setup.relays.empty()) setup.relays.insert(2);
    return setup;
  }
};

TEST_P(RandomRelaying, WhoIsConnectedHearsEverythingOnceAndInOrder) {
  Random random(static_cast<std::uint64_t>(GetParam()), "relaying/events");
  const RadioNet::Setup setup = random_setup(random, GetParam());
  RadioNet net(setup);
  const auto someone = [&] { return static_cast<int>(between(random, 1, setup.nodes)); };
  std::map<std::pair<int, int>, std::vector<std::uint64_t>> sent;  // by receiver and sender
  std::map<std::pair<int, int>, std::uint64_t> states;
  for (int a = 1; a <= setup.nodes; ++a) {
    for (int b = a + 1; b <= setup.nodes; ++b) net.set_both(a, b, random.chance(0.5));
  }
  for (int i = 0; i < 300; ++i) {
    const int from = someone(), to = someone();
    if (from == to) continue;
    if (random.chance(0.1)) net.set_both(from, to, random.chance(0.5));
    if (random.chance(0.02)) net.set_link(from, to, random.chance(0.5));
    if (random.chance(0.4)) sent[{to, from}].push_back(net.send_event(from, to));
    if (random.chance(0.3)) net.set_state(from, to, states[{to, from}] = net.send_event(from, to));
    if (states.contains({to, from}) &&
        (sent[{to, from}].empty() || sent[{to, from}].back() < states[{to, from}])) {
      sent[{to, from}].push_back(states[{to, from}]);
    }
    net.run_for(Duration::milliseconds(between(random, 1, 400)));
  }
  // It heals as far as it does: one topology for long.
  net.run_for(seconds(12));
  for (int from = 1; from <= setup.nodes; ++from) {
    const std::set<int> reach = in_reach(net, setup, from);
    for (int to = 1; to <= setup.nodes; ++to) {
      if (from == to) continue;
      const auto& handled = net.handled(to, from);
      const auto& all = sent[{to, from}];
      ASSERT_LE(handled.size(), all.size());
      EXPECT_TRUE(std::equal(handled.begin(), handled.end(), all.begin()));
      if (!reach.contains(to)) continue;
      EXPECT_EQ(handled, all) << from << " to " << to;
      EXPECT_TRUE(net.reachable(from, to) || setup.loss > 0) << from << " to " << to;
      const auto state = states.find({to, from});
      EXPECT_TRUE(state == states.end() || net.state(to, from) == state->second);
    }
  }
  EXPECT_THAT(net.breaches(), IsEmpty());
}

TEST_P(RandomRelaying, AfterAHealStatesConvergeWithinThreeSeconds) {
  Random random(static_cast<std::uint64_t>(GetParam()), "relaying/states");
  RadioNet::Setup setup = random_setup(random, GetParam());
  setup.loss = 0;
  RadioNet net(setup);
  for (int a = 1; a <= setup.nodes; ++a) {
    for (int b = a + 1; b <= setup.nodes; ++b) net.set_both(a, b, random.chance(0.3));
  }
  net.run_for(seconds(4));
  std::map<std::pair<int, int>, std::uint64_t> states;
  for (int i = 0; i < 50; ++i) {
    const int from = static_cast<int>(between(random, 1, setup.nodes));
    const int to = static_cast<int>(between(random, 1, setup.nodes));
    if (from == to) continue;
    states[{to, from}] = static_cast<std::uint64_t>(i) + 1;
    net.set_state(from, to, states[{to, from}]);
    net.run_for(Duration::milliseconds(100));
  }
  for (int a = 1; a <= setup.nodes; ++a) {
    for (int b = a + 1; b <= setup.nodes; ++b) {
      if (!net.is_up(a, b) && random.chance(0.6)) net.set_both(a, b, true);
    }
  }
  net.run_for(seconds(3));
  for (const auto& [pair, value] : states) {
    if (!in_reach(net, setup, pair.second).contains(pair.first)) continue;
    EXPECT_EQ(net.state(pair.first, pair.second), value) << pair.second << " to " << pair.first;
  }
}

TEST_P(RandomRelaying, WithoutCutsAnEventCrossesAChannelAtMostOnce) {
  Random random(static_cast<std::uint64_t>(GetParam()), "relaying/crossings");
  RadioNet::Setup setup = random_setup(random, GetParam());
  setup.loss = 0;
  setup.latency = {};
  RadioNet net(setup);
  for (int a = 1; a <= setup.nodes; ++a) {
    for (int b = a + 1; b <= setup.nodes; ++b) net.set_both(a, b, random.chance(0.4));
  }
  net.run_for(seconds(5));
  for (int i = 0; i < 60; ++i) {
    const int from = static_cast<int>(between(random, 1, setup.nodes));
    const std::set<int> reach = in_reach(net, setup, from);
    const int to = static_cast<int>(between(random, 1, setup.nodes));
    if (from == to || !reach.contains(to)) continue;
    net.send_event(from, to);
    net.run_for(Duration::milliseconds(between(random, 1, 100)));
  }
  net.run_for(seconds(3));
  for (const auto& [crossing, times] : net.crossings()) EXPECT_EQ(times, 1);
}

TEST_P(RandomRelaying, DeathsOfRelaysCostNothing) {
  Random random(static_cast<std::uint64_t>(GetParam()), "relaying/deaths");
  RadioNet::Setup setup = random_setup(random, GetParam());
  setup.nodes += 2;  // two ends that do not die
  const int one = setup.nodes - 1, other = setup.nodes;
  RadioNet net(setup);
  for (int a = 1; a <= setup.nodes; ++a) {
    for (int b = a + 1; b <= setup.nodes; ++b) net.set_both(a, b, random.chance(0.5));
  }
  net.set_both(one, other, false);
  std::vector<std::uint64_t> sent;
  for (int i = 0; i < 200; ++i) {
    const int node = static_cast<int>(between(random, 1, setup.nodes - 2));
    if (random.chance(0.15)) {
      if (net.lives(node)) {
        net.kill(node);
      } else {
        net.start(node);
      }
    }
    if (random.chance(0.5)) sent.push_back(net.send_event(one, other));
    net.run_for(Duration::milliseconds(between(random, 1, 300)));
  }
  net.run_for(seconds(12));
  const auto& handled = net.handled(other, one);
  ASSERT_LE(handled.size(), sent.size());
  EXPECT_TRUE(std::equal(handled.begin(), handled.end(), sent.begin()));
  EXPECT_TRUE(handled == sent || !in_reach(net, setup, one).contains(other));
  EXPECT_THAT(net.breaches(), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomRelaying, ::testing::Range(1, 21));

}  // namespace
}  // namespace skein::blackboard::testing
