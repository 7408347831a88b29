// SPDX-License-Identifier: Apache-2.0
// The transport alone: agents that only record what comes, and write three times for each
// disturbance.
#include "skein/temporal_lab/mastn_simulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "skein/temporal_lab/mastn_generator.hpp"

namespace skein::temporal {
namespace {

struct Record {
  AgentIndex receiver = 0;
  AgentIndex sender = 0;
  std::uint64_t id = 0;  // 0: word of a link
  bool up = false;
  MissionTime at;
};
using Records = std::vector<Record>;

/// Writes three UPDATEs to the next agent and one CONSISTENCY to all for each disturbance.
class Recorder final : public Agent {
 public:
  Recorder(AgentIndex self, AgentIndex agents, Records& records)
      : Agent(self, agents, false), records_(records) {}

  Ticks earliest(NodeIndex node) const override { return node; }
  Ticks latest(NodeIndex node) const override { return node + 100; }
  std::optional<MissionTime> blocked_since() const override { return std::nullopt; }
  std::uint64_t checks() const override { return 10; }

 private:
  Output do_start(MissionTime) override { return {}; }
  Result<Output, AgentRefusal> do_disturbance(std::span<const ArcUpdate> changes,
                                              MissionTime) override {
    if (changes.front().min == 666) {
      return tl::unexpected(AgentRefusal{AgentError::kOverflow, changes.front().arc});
    }
    Output output;
    const AgentIndex next = (index() + 1) % agents();
    for (int copy = 0; copy < 3; ++copy) output.messages.push_back(make_message(next, Update{}));
    output.messages.push_back(make_message(std::nullopt, Consistency{}));
    return output;
  }
  Result<Output, AgentRefusal> do_message(const Message& message, MissionTime now) override {
    records_.push_back({index(), message.sender, message.id, false, now});
    return Output{};
  }
  Output do_link(AgentIndex peer, bool up, MissionTime now) override {
    records_.push_back({index(), peer, 0, up, now});
    return {};
  }
  std::optional<bool> consistent() const override { return index() != 1 || records_.empty(); }
  std::vector<LastWord> words() const override { return {}; }

  Records& records_;
};

/// Three agents of one node each.
class MastnSimulationTest : public ::testing::Test {
 protected:
  MastnSimulation simulation(const TransportOptions& options) {
    const MastnShape shape{.agents = 3, .nodes = 1, .local = 0, .external = 1};
    const AgentMaker maker = [this](
                                 Algorithm, const Mastn& mastn,
                                 AgentIndex index) -> Result<std::unique_ptr<Agent>, AgentRefusal> {
      const auto agents = static_cast<AgentIndex>(mastn.agents.size());
      return std::make_unique<Recorder>(index, agents, records_);
    };
    auto made = MastnSimulation::make(Algorithm::kDipG, generate_mastn(shape, 1), options, maker);
    EXPECT_TRUE(made.has_value());
    return std::move(*made);
  }

  // One perturbation of agent 0.
  static std::optional<AgentRefusal> disturb(MastnSimulation& simulation, Ticks min = 1) {
    const ArcUpdate change{0, min, min};
    return simulation.disturb({&change, 1});
  }

  std::vector<std::uint64_t> ids_at(AgentIndex receiver) const {
    std::vector<std::uint64_t> ids;
    for (const Record& record : records_) {
      if (record.receiver == receiver && record.id > 0) ids.push_back(record.id);
    }
    return ids;
  }

  Records records_;
};

constexpr TransportOptions kSlow{
    .longest_delay = 100 * kTicksPerSecond, .in_order = true, .seed = 3};

TEST_F(MastnSimulationTest, WithoutDelaysEverythingArrivesAtOnce) {
  MastnSimulation agents = simulation({});

  disturb(agents);
  EXPECT_FALSE(agents.is_quiet());
  EXPECT_TRUE(agents.run_until(MissionTime(), 100));

  EXPECT_TRUE(agents.is_quiet());
  EXPECT_EQ(ids_at(1), (std::vector<std::uint64_t>{1, 2, 3, 4}));
  EXPECT_EQ(ids_at(2), (std::vector<std::uint64_t>{4})) << "what is sent to all";
  EXPECT_TRUE(ids_at(0).empty()) << "not to the sender";
}

TEST_F(MastnSimulationTest, DelaysNeverChangeTheOrderBetweenTwoAgents) {
  MastnSimulation agents = simulation(kSlow);

  for (int count = 0; count < 20; ++count) disturb(agents);
  EXPECT_TRUE(agents.settle(1000));

  const std::vector<std::uint64_t> ids = ids_at(1);
  EXPECT_EQ(ids.size(), 80U);
  EXPECT_TRUE(std::is_sorted(ids.begin(), ids.end()));
  EXPECT_GT(agents.now(), MissionTime::seconds(50)) << "time goes with the messages";
}

TEST_F(MastnSimulationTest, OutOfOrderMessagesOvertakeEachOther) {
  TransportOptions options = kSlow;
  options.in_order = false;
  MastnSimulation agents = simulation(options);

  for (int count = 0; count < 20; ++count) disturb(agents);
  agents.settle(1000);

  const std::vector<std::uint64_t> ids = ids_at(1);
  EXPECT_EQ(ids.size(), 80U) << "but none is lost";
  EXPECT_FALSE(std::is_sorted(ids.begin(), ids.end()));
}

TEST_F(MastnSimulationTest, RunsOnlyAsFarAsItIsTold) {
  MastnSimulation agents = simulation(kSlow);

  for (int count = 0; count < 20; ++count) disturb(agents);
  agents.run_until(MissionTime::seconds(10), 1000);

  EXPECT_EQ(agents.now(), MissionTime::seconds(10));
  EXPECT_FALSE(agents.is_quiet());
  for (const Record& record : records_) EXPECT_LE(record.at, MissionTime::seconds(10));
}

TEST_F(MastnSimulationTest, StopsAtTheGreatestNumberOfMessages) {
  MastnSimulation agents = simulation({});

  disturb(agents);

  EXPECT_FALSE(agents.settle(3));
  EXPECT_EQ(records_.size(), 3U);
  EXPECT_TRUE(agents.settle(3)) << "and can go on";
}

TEST_F(MastnSimulationTest, ACutLosesWhatIsUnderWayAndTellsBothEnds) {
  MastnSimulation agents = simulation(kSlow);
  disturb(agents);

  agents.cut(1, 0);
  disturb(agents);
  agents.settle(1000);

  EXPECT_TRUE(ids_at(1).empty());
  EXPECT_EQ(ids_at(2).size(), 2U) << "other links are as before";
  EXPECT_EQ(agents.traffic().lost, 8U);
  ASSERT_GE(records_.size(), 2U);
  EXPECT_EQ(records_[0].receiver, 1U);
  EXPECT_EQ(records_[1].receiver, 0U);
  EXPECT_EQ(records_[1].sender, 1U);
  EXPECT_FALSE(records_[0].up || records_[1].up);
}

TEST_F(MastnSimulationTest, AHealedLinkCarriesAgainAndTellsBothEnds) {
  MastnSimulation agents = simulation({});
  agents.cut(0, 1);
  agents.cut(0, 1);

  agents.heal_all();
  disturb(agents);
  agents.settle(1000);

  EXPECT_EQ(ids_at(1).size(), 4U);
  EXPECT_EQ(std::count_if(records_.begin(), records_.end(),
                          [](const Record& record) { return record.id == 0 && record.up; }),
            2);
}

TEST_F(MastnSimulationTest, CountsSendsByKindWhateverTheNumberOfReceivers) {
  MastnSimulation agents = simulation({});

  disturb(agents);
  disturb(agents);
  agents.settle(1000);

  EXPECT_EQ(agents.traffic().updates, 6U);
  EXPECT_EQ(agents.traffic().consistency, 2U);
  EXPECT_EQ(agents.traffic().data(), 6U);
  EXPECT_EQ((agents.traffic() - agents.traffic()), Traffic{});
  EXPECT_EQ(agents.checks(), 30U);
}

TEST_F(MastnSimulationTest, GivesDatesOfTheOwnersAndAVerdictOnlyIfAllAgree) {
  MastnSimulation agents = simulation({});

  EXPECT_EQ(agents.earliest(2), 2);
  EXPECT_EQ(agents.latest(2), 102);
  EXPECT_EQ(agents.earliest(0), 0) << "nobody's";
  EXPECT_EQ(agents.consistent(), true);
  disturb(agents);
  agents.settle(1000);
  EXPECT_EQ(agents.consistent(), std::nullopt);
}

TEST_F(MastnSimulationTest, HandsBackWhatAnAgentRefuses) {
  MastnSimulation agents = simulation({});

  EXPECT_EQ(disturb(agents, 666), (AgentRefusal{AgentError::kOverflow, 0}));
  const ArcUpdate unknown{99, 0, 0};
  EXPECT_EQ(agents.disturb({&unknown, 1}), (AgentRefusal{AgentError::kUnknownArc, 99}));
}

TEST_F(MastnSimulationTest, OneSeedOneRun) {
  const auto play = [this] {
    records_.clear();
    MastnSimulation agents = simulation(kSlow);
    for (int count = 0; count < 5; ++count) disturb(agents);
    agents.settle(1000);
    std::vector<MissionTime> times;
    for (const Record& record : records_) times.push_back(record.at);
    return times;
  };

  EXPECT_EQ(play(), play());
}

TEST(MastnSimulation, LinksOfCipAreThoseWithTheSupervisor) {
  const MastnShape shape{.agents = 3, .nodes = 2, .local = 0, .external = 1};
  auto cip = MastnSimulation::make(Algorithm::kCip, generate_mastn(shape, 1));
  auto dip_g = MastnSimulation::make(Algorithm::kDipG, generate_mastn(shape, 1));

  ASSERT_TRUE(cip && dip_g);
  EXPECT_EQ(cip->links(), (std::vector<std::pair<AgentIndex, AgentIndex>>{{0, 3}, {1, 3}, {2, 3}}));
  EXPECT_EQ(dip_g->links(),
            (std::vector<std::pair<AgentIndex, AgentIndex>>{{0, 1}, {0, 2}, {1, 2}}));
}

TEST(MastnSimulation, RefusesANetworkThatIsNone) {
  Mastn mastn = generate_mastn({.agents = 2, .nodes = 2, .local = 0, .external = 1}, 1);
  mastn.arcs[0].to = 77;

  EXPECT_FALSE(MastnSimulation::make(Algorithm::kDipG, mastn).has_value());
}

}  // namespace
}  // namespace skein::temporal
