// SPDX-License-Identifier: Apache-2.0
// Forwarding alone, without boards: no loops, no storms, shortest ways after each change.
#include "routing/forwarding.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>
#include <set>
#include <tuple>

#include "skein/foundation/random.hpp"

namespace skein::blackboard::routing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr Duration kPeriod = Duration::milliseconds(200);

Node node_of(int number) {
  return {NodeNumber(static_cast<std::uint32_t>(number)), "uav" + std::to_string(number)};
}

/// Of node `self` of a team of UAVs that all have channels to each other.
Config config_of(int self, int nodes, const std::set<int>& relays) {
  Config config;
  config.self = node_of(self).number;
  config.heartbeat_period = kPeriod;
  for (const int relay : relays) config.relaying.relays.insert(node_of(relay).number);
  for (int other = 1; other <= nodes; ++other) {
    if (other == self) continue;
    for (ChannelConfig& channel : radio_link(node_of(self), node_of(other)))
      config.channels.push_back(std::move(channel));
  }
  return config;
}

template <class Sample>
Sample from_to(int origin, int destination, std::uint64_t sequence) {
  Sample sample;
  sample.header.origin = static_cast<std::uint32_t>(origin);
  sample.header.destination = static_cast<std::uint32_t>(destination);
  sample.header.incarnation = 1;
  sample.header.sequence_number = sequence;
  return sample;
}

/// Nodes 1 to n and the links between them. What is handed over a link that is down is lost, but
/// for reports, the last of which waits for the link as states do on a blackboard.
class Team {
 public:
  Team(int nodes, const std::set<int>& relays) : nodes_(nodes) {
    for (int node = 1; node <= nodes; ++node) configs_.push_back(config_of(node, nodes, relays));
    for (const Config& config : configs_) forwarding_.emplace_back(config);
  }

  bool is_up(int from, int to) const { return !cut_.contains({from, to}); }
  void set_both(int a, int b, bool up) {
    for (const auto& link : {std::pair(a, b), std::pair(b, a)}) {
      up ? cut_.erase(link) > 0 : cut_.insert(link).second;
      if (up) deliver_waiting(link);
    }
  }

  /// Heartbeats over all links, and all that follows from them.
  void beat(int periods = 1) {
    for (int i = 0; i < periods; ++i) {
      now_ = now_ + kPeriod;
      for (int from = 1; from <= nodes_; ++from)
        for (int to = 1; to <= nodes_; ++to)
          if (from != to && is_up(from, to)) at(to).on_heartbeat(node_of(from).number, now_);
      look();
      deliver_all();
    }
  }

  /// Gives the number of the event. It is on its way until it is delivered.
  std::uint64_t send(int from, int to) {
    const auto event = from_to<wire::SyncMessage>(from, to, ++sequence_);
    if (const auto hop = at(from).hop_to(node_of(to).number, wire::Slot::kSyncMessage))
      hand(from, {{*hop, event}});
    return sequence_;
  }

  /// One thing that is on its way, whichever.
  void deliver(std::size_t which) {
    const Moving moving = on_the_way_.at(which);
    on_the_way_.erase(on_the_way_.begin() + static_cast<std::ptrdiff_t>(which));
    if (!is_up(moving.from, moving.to)) return lose(moving);
    note_crossing(moving);
    if (const auto* report = std::get_if<wire::Neighbours>(&moving.sample)) {
      std::uint64_t& newest = newest_report_[{moving.to, report->header.origin}];
      if (report->header.sequence_number <= newest) return;
      newest = report->header.sequence_number;
      return hand(moving.to, at(moving.to).learn(*report));
    }
    const wire::SampleHeader& header = wire::header_of(moving.sample);
    if (header.destination == static_cast<std::uint32_t>(moving.to)) {
      arrived_[header.sequence_number] = header.via;
    } else if (auto next = at(moving.to).pass_on(channel(moving.from, moving.to), moving.sample)) {
      hand(moving.to, {std::move(*next)});
    }
  }
  void deliver_all() {
    while (!on_the_way_.empty()) deliver(0);
  }
  std::size_t on_the_way() const { return on_the_way_.size(); }
  /// What nodes do from time to time, without heartbeats.
  void look() {
    for (int node = 1; node <= nodes_; ++node) {
      for (const WayChange& change : at(node).update(now_)) {
        news_ += at(node).take(change).news ? 1 : 0;
        hand(node, at(node).states_for(change));
      }
      hand(node, at(node).take_reminders());
      auto report = at(node).take_report();
      if (!report) continue;
      report->header = from_to<wire::Neighbours>(node, 0, ++sequence_).header;
      hand(node, at(node).flood(*report));
    }
  }

  /// By what nodes the event came; nothing: it did not arrive.
  std::optional<std::vector<std::uint32_t>> way_of(std::uint64_t event) const {
    const auto found = arrived_.find(event);
    return found == arrived_.end() ? std::nullopt : std::optional(found->second);
  }
  /// How often a report or event crossed a channel: slot, sequence, from, to.
  const std::map<std::tuple<wire::Slot, std::uint64_t, int, int>, int>& crossings() const {
    return crossings_;
  }
  /// Events that came to who had passed or sent them.
  int circles() const { return circles_; }
  int news() const { return news_; }

 private:
  struct Moving {
    int from = 0, to = 0;
    wire::Sample sample;
  };
  Forwarding& at(int node) { return forwarding_.at(static_cast<std::size_t>(node) - 1); }
  const ChannelConfig& channel(int from, int to) const {
    const auto& channels = configs_.at(static_cast<std::size_t>(to) - 1).channels;
    return *std::ranges::find_if(channels, [&](const ChannelConfig& one) {
      return one.from == node_of(from).number && one.to == node_of(to).number;
    });
  }
  void hand(int from, const std::vector<Handed>& handed) {
    for (const Handed& one : handed)
      on_the_way_.push_back({from, static_cast<int>(one.hop.value()), one.sample});
  }
  void note_crossing(const Moving& moving) {
    const wire::SampleHeader& header = wire::header_of(moving.sample);
    const wire::Slot slot = wire::slot_of(moving.sample);
    ++crossings_[{slot, header.sequence_number, moving.from, moving.to}];
    const auto here = static_cast<std::uint32_t>(moving.to);
    const bool back = header.origin == here || std::ranges::count(header.via, here) > 0;
    circles_ += slot != wire::Slot::kNeighbours && back ? 1 : 0;
  }
  void lose(const Moving& moving) {
    if (const auto* report = std::get_if<wire::Neighbours>(&moving.sample))
      waiting_[{moving.from, moving.to}][report->header.origin] = *report;
  }
  void deliver_waiting(const std::pair<int, int>& link) {
    for (const auto& [origin, report] : waiting_[link])
      on_the_way_.push_back({link.first, link.second, report});
    waiting_.erase(link);
  }

  int nodes_;
  std::deque<Config> configs_;
  std::deque<Forwarding> forwarding_;
  std::set<std::pair<int, int>> cut_;
  std::deque<Moving> on_the_way_;
  std::map<std::pair<int, int>, std::map<std::uint32_t, wire::Neighbours>> waiting_;
  std::map<std::pair<int, std::uint32_t>, std::uint64_t> newest_report_;
  std::map<std::uint64_t, std::vector<std::uint32_t>> arrived_;
  std::map<std::tuple<wire::Slot, std::uint64_t, int, int>, int> crossings_;
  Duration now_;
  std::uint64_t sequence_ = 0;
  int circles_ = 0, news_ = 0;
};

std::set<int> all_of(int nodes) {
  std::set<int> all;
  for (int node = 1; node <= nodes; ++node) all.insert(node);
  return all;
}

TEST(Forwarding, InAFullMeshOfTenAnEventCrossesOneChannelAndAReportEachOnceAtMost) {
  Team team(10, all_of(10));
  team.beat(5);
  for (int from = 1; from <= 10; ++from)
    for (int to = 1; to <= 10; ++to)
      if (from != to) team.send(from, to);
  team.deliver_all();

  std::size_t events = 0;
  for (const auto& [crossing, times] : team.crossings()) {
    EXPECT_EQ(times, 1);
    events += std::get<wire::Slot>(crossing) == wire::Slot::kSyncMessage ? 1U : 0U;
  }
  EXPECT_EQ(events, 90U);
}

TEST(Forwarding, WhereNothingChangesNothingIsSaid) {
  Team team(10, all_of(10));
  team.beat(5);
  const std::size_t said = team.crossings().size();
  team.beat(50);
  EXPECT_EQ(team.crossings().size(), said);
}

TEST(Forwarding, ALinkThatIsCutIsReportedOnceOverEachChannelAndAllGoOn) {
  Team team(10, all_of(10));
  team.beat(5);
  team.set_both(1, 2, false);
  team.beat(8);
  const auto event = team.send(1, 2);
  team.deliver_all();

  ASSERT_TRUE(team.way_of(event));
  EXPECT_THAT(*team.way_of(event), ElementsAre(3U));
  for (const auto& [crossing, times] : team.crossings()) EXPECT_EQ(times, 1);
}

/// How many relays there are at least on the way, over links that are up; none: no way.
std::optional<std::size_t> fewest_relays(const Team& team, const std::set<int>& relays, int nodes,
                                         std::pair<int, int> ends) {
  std::map<int, std::size_t> met{{ends.first, 0}};
  for (std::deque<int> next{ends.first}; !next.empty(); next.pop_front()) {
    const int here = next.front();
    if (here == ends.second) return met[here] - 1;
    if (here != ends.first && !relays.contains(here)) continue;
    for (int there = 1; there <= nodes; ++there)
      if (there != here && team.is_up(here, there) && met.emplace(there, met[here] + 1).second)
        next.push_back(there);
  }
  return std::nullopt;
}

class RandomForwarding : public ::testing::TestWithParam<std::uint64_t> {
 protected:
  int draw(int least, int most) {
    return least + static_cast<int>(random_.below(static_cast<std::uint64_t>(most - least + 1)));
  }
  void SetUp() override {
    nodes_ = draw(3, 9);
    for (int node = 1; node <= nodes_; ++node)
      if (random_.chance(0.6)) relays_.insert(node);
    relays_.insert(draw(1, nodes_));
  }
  void draw_links(Team& team, double share) {
    for (int a = 1; a <= nodes_; ++a)
      for (int b = a + 1; b <= nodes_; ++b) team.set_both(a, b, random_.chance(share));
  }

  Random random_{GetParam()};
  int nodes_ = 0;
  std::set<int> relays_;
};

TEST_P(RandomForwarding, AfterEachChangeEventsGoOnAShortestWayOrThereIsNone) {
  Team team(nodes_, relays_);
  for (int round = 0; round < 6; ++round) {
    draw_links(team, random_.uniform(0.2, 0.9));
    team.beat(12);  // of a link that came back the first five heartbeats weigh less
    for (int from = 1; from <= nodes_; ++from) {
      for (int to = 1; to <= nodes_; ++to) {
        if (from == to) continue;
        const auto event = team.send(from, to);
        team.deliver_all();
        const auto fewest = fewest_relays(team, relays_, nodes_, {from, to});
        ASSERT_EQ(team.way_of(event).has_value(), fewest.has_value()) << from << " to " << to;
        if (!fewest) continue;
        EXPECT_THAT(*team.way_of(event), SizeIs(*fewest)) << from << " to " << to;
      }
    }
  }
  EXPECT_EQ(team.circles(), 0);
}

// Links change and reports are under way in any order: what nodes believe contradicts each other.
TEST_P(RandomForwarding, WhateverNodesBelieveNoEventCirclesOrCrossesAChannelTwice) {
  Team team(nodes_, relays_);
  team.beat(3);
  for (int i = 0; i < 400; ++i) {
    if (random_.chance(0.1)) team.set_both(1, draw(2, nodes_), random_.chance(0.6));
    if (random_.chance(0.1)) draw_links(team, 0.6);
    if (random_.chance(0.2)) team.beat();
    if (random_.chance(0.5)) team.look();
    const int from = draw(1, nodes_), to = draw(1, nodes_);
    if (from != to) team.send(from, to);
    for (int n = draw(0, 4); n > 0 && team.on_the_way() > 0; --n)
      team.deliver(random_.below(team.on_the_way()));
  }
  team.deliver_all();

  EXPECT_EQ(team.circles(), 0);
  for (const auto& [crossing, times] : team.crossings())
    EXPECT_TRUE(times == 1 || std::get<wire::Slot>(crossing) == wire::Slot::kNeighbours);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomForwarding, ::testing::Range<std::uint64_t>(1, 41));

/// Node 2 of four, and what comes to it from node 1.
class OneRelay : public ::testing::Test {
 protected:
  explicit OneRelay(const std::set<int>& relays = {2, 3}) : config_(config_of(2, 4, relays)) {}

  const ChannelConfig& from(int number) const {
    return *std::ranges::find_if(config_.channels, [&](const ChannelConfig& one) {
      return one.from == node_of(number).number;
    });
  }
  void hear(int number) { relay_.on_heartbeat(node_of(number).number, now_); }
  void report(int author, const std::vector<int>& hears, std::vector<std::uint32_t> via = {}) {
    auto said = from_to<wire::Neighbours>(author, 0, ++sequence_);
    said.header.via = std::move(via);
    for (const int node : hears) said.hears.push_back({static_cast<std::uint32_t>(node), true});
    (void)relay_.learn(said);
  }
  std::optional<TakenWay> way_to(int number) {
    std::optional<TakenWay> taken;
    for (const WayChange& change : relay_.update(now_))
      if (change.peer == node_of(number).number) taken = relay_.take(change);
    return taken;
  }

  Config config_;
  Forwarding relay_{config_};
  Duration now_ = kPeriod;
  std::uint64_t sequence_ = 0;
};

TEST_F(OneRelay, KeepsAStateForWhomItDoesNotHearUntilItDoes) {
  const auto state = from_to<wire::AutonomyDegree>(1, 4, 7);
  EXPECT_FALSE(relay_.pass_on(from(1), state));
  hear(4);
  report(4, {2});
  std::vector<Handed> sent;
  for (const WayChange& change : relay_.update(now_))
    for (Handed& one : relay_.states_for(change)) sent.push_back(std::move(one));

  ASSERT_THAT(sent, SizeIs(1));
  EXPECT_EQ(sent[0].hop, node_of(4).number);
  EXPECT_THAT(wire::header_of(sent[0].sample).via, ElementsAre(2U));
}

TEST_F(OneRelay, PassesOnlyTheNewestOfStatesAndStreamsAndThatOnce) {
  hear(4);
  report(4, {2});
  (void)way_to(4);
  EXPECT_TRUE(relay_.pass_on(from(1), from_to<wire::Telemetry>(1, 4, 7)));
  EXPECT_FALSE(relay_.pass_on(from(1), from_to<wire::Telemetry>(1, 4, 7)));
  EXPECT_FALSE(relay_.pass_on(from(1), from_to<wire::Telemetry>(1, 4, 6)));
  EXPECT_TRUE(relay_.pass_on(from(1), from_to<wire::Telemetry>(1, 4, 8)));
}

TEST_F(OneRelay, PassesNothingBackNorToStrangersNorPastTooMany) {
  hear(4);
  report(4, {2});
  (void)way_to(4);
  EXPECT_FALSE(relay_.pass_on(from(4), from_to<wire::SyncMessage>(1, 4, 1)));
  EXPECT_FALSE(relay_.pass_on(from(1), from_to<wire::SyncMessage>(1, 9, 1)));
  auto far = from_to<wire::SyncMessage>(1, 4, 1);
  far.header.via = {3, 3, 3, 3, 3, 3, 3, 3};
  EXPECT_FALSE(relay_.pass_on(from(1), far));
  EXPECT_TRUE(relay_.pass_on(from(1), from_to<wire::SyncMessage>(1, 4, 1)));
}

TEST_F(OneRelay, RemindsWhoIsHeardAnewOfWhatItPassedOnItself) {
  report(1, {3}, {3});
  report(4, {3});
  hear(3);
  const std::vector<Handed> reminders = relay_.take_reminders();
  ASSERT_THAT(reminders, SizeIs(1));
  EXPECT_EQ(reminders[0].hop, node_of(3).number);
  EXPECT_EQ(wire::header_of(reminders[0].sample).origin, 1U);
  EXPECT_THAT(relay_.take_reminders(), IsEmpty());
}

TEST_F(OneRelay, TellsOfAWayPastARelayOnceAndWhenItIsDirectAgain) {
  hear(3);
  report(3, {2, 4});
  report(4, {3});
  const auto past = way_to(4);
  ASSERT_TRUE(past);
  EXPECT_EQ(past->relays, 1U);
  EXPECT_TRUE(past->is_other);
  ASSERT_TRUE(past->news);
  EXPECT_EQ(past->news->via, node_of(3).number);
  EXPECT_TRUE(relay_.is_relayed(node_of(4).number));

  hear(4);
  report(4, {2, 3});
  const auto direct = way_to(4);
  ASSERT_TRUE(direct);
  EXPECT_EQ(direct->relays, 0U);
  ASSERT_TRUE(direct->news);
  EXPECT_EQ(direct->news->via, std::nullopt);
}

class NoRelay : public OneRelay {
 protected:
  NoRelay() : OneRelay({3}) {}
};

TEST_F(NoRelay, PassesNothingOn) {
  hear(4);
  report(4, {2});
  (void)way_to(4);
  EXPECT_FALSE(relay_.pass_on(from(1), from_to<wire::SyncMessage>(1, 4, 1)));
  EXPECT_THAT(relay_.learn(from_to<wire::Neighbours>(1, 0, 99)), IsEmpty());
}

}  // namespace
}  // namespace skein::blackboard::routing
