// SPDX-License-Identifier: Apache-2.0
#include "radio_network.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <optional>

#include "testing.hpp"

namespace skein::sim {
namespace {

using testing::at;
using testing::flat;
using world::Vector3;

SimulatorConfig radio_config(double range = 100) {
  SimulatorConfig config{flat()};
  config.radio = {range, true, Duration::milliseconds(20), 0.1, 0.1};
  return config;
}

std::vector<LinkChange> links_of(const std::vector<Effect>& effects) {
  std::vector<LinkChange> links;
  for (const Effect& effect : effects) links.push_back(std::get<LinkChange>(effect));
  return links;
}

/// A network of "a" and "b" on a line, and the changes that moving b gives.
struct Line {
  explicit Line(const SimulatorConfig& config)
      : terrain(config.terrain), network(config, {"a", "b"}) {}
  std::vector<LinkChange> put_b_at(double x, double seconds) {
    std::vector<Effect> effects;
    if (network.due(at(seconds)))
      network.update({{0, 0, 50}, {x, 0, 50}}, terrain, at(seconds), effects);
    return links_of(effects);
  }
  world::Terrain terrain;
  RadioNetwork network;
};

TEST(RadioNetwork, TellsEveryLinkBothWaysAtTheStart) {
  std::vector<Effect> effects;
  RadioNetwork network(radio_config(), {"a", "b", "c"});

  network.update({{0, 0, 50}, {50, 0, 50}, {140, 0, 50}}, flat(), at(0), effects);

  const auto links = links_of(effects);
  ASSERT_EQ(links.size(), 6u);
  EXPECT_EQ(links[0], (LinkChange{"a", "b", true, Duration::milliseconds(20), 0.1, at(0)}));
  EXPECT_EQ(links[1], (LinkChange{"b", "a", true, Duration::milliseconds(20), 0.1, at(0)}));
  EXPECT_EQ(links[2], (LinkChange{"a", "c", false, Duration(), 1, at(0)}));
}

TEST(RadioNetwork, WhereMostLinksAreDownAtTheStartTellsThatOnceAndWhichAreUp) {
  std::vector<Effect> effects;
  RadioNetwork network(radio_config(), {"a", "b", "c"});

  network.update({{0, 0, 50}, {50, 0, 50}, {300, 0, 50}}, flat(), at(0), effects);

  const auto links = links_of(effects);
  ASSERT_EQ(links.size(), 3u);
  EXPECT_EQ(links[0], (LinkChange{kEveryLink, kEveryLink, false, Duration(), 1, at(0)}));
  EXPECT_EQ(links[1], (LinkChange{"a", "b", true, Duration::milliseconds(20), 0.1, at(0)}));
  EXPECT_EQ(links[2], (LinkChange{"b", "a", true, Duration::milliseconds(20), 0.1, at(0)}));
}

TEST(RadioNetwork, TellsOnlyChangesAfterwards) {
  Line line(radio_config());
  line.put_b_at(50, 0);

  EXPECT_TRUE(line.put_b_at(60, 1).empty());
  EXPECT_EQ(line.put_b_at(200, 2).size(), 2u);
  EXPECT_TRUE(line.put_b_at(201, 3).empty());
}

TEST(RadioNetwork, ALinkOnTheLimitDoesNotFlutter) {
  Line line(radio_config());
  line.put_b_at(50, 0);

  EXPECT_TRUE(line.put_b_at(105, 1).empty()) << "holds within its hysteresis";
  EXPECT_EQ(line.put_b_at(111, 2).size(), 2u);
  EXPECT_TRUE(line.put_b_at(105, 3).empty()) << "comes back within the range only";
  EXPECT_EQ(line.put_b_at(99, 4).size(), 2u);
}

TEST(RadioNetwork, TheRangeFollowsFromALinkBudget) {
  SimulatorConfig config = radio_config(1);  // does not count
  config.radio.budget = world::LinkBudget{20, -60, 40, 2};
  Line line(config);
  ASSERT_NEAR(config.radio.reach(), 100, 1e-9);

  EXPECT_TRUE(line.put_b_at(99, 0)[0].up);
  EXPECT_TRUE(line.put_b_at(109, 1).empty()) << "holds within its hysteresis";
  EXPECT_FALSE(line.put_b_at(111, 2)[0].up);
}

TEST(RadioNetwork, AScriptedCutHoldsFromItsBeginningToItsEnd) {
  SimulatorConfig config = radio_config();
  config.cuts = {{"b", "a", at(10.3), at(12.7)}};
  Line line(config);

  std::vector<std::pair<double, bool>> changes;
  for (int tenth = 0; tenth < 200; ++tenth)
    for (const LinkChange& link : line.put_b_at(50, tenth * 0.1))
      if (link.from == "a") changes.emplace_back(link.at.to_seconds(), link.up);

  ASSERT_EQ(changes.size(), 3u);
  EXPECT_NEAR(changes[1].first, 10.3, 1e-6);
  EXPECT_FALSE(changes[1].second);
  EXPECT_NEAR(changes[2].first, 12.7, 1e-6);
  EXPECT_TRUE(changes[2].second);
}

TEST(RadioNetwork, ACutDoesNotTouchOtherPairs) {
  SimulatorConfig config = radio_config();
  config.cuts = {{"a", "b", at(0), at(100)}};
  RadioNetwork network(config, {"a", "b", "c"});
  std::vector<Effect> effects;

  network.update({{0, 0, 50}, {10, 0, 50}, {20, 0, 50}}, flat(), at(1), effects);

  for (const LinkChange& link : links_of(effects))
    EXPECT_EQ(link.up, link.from == "c" || link.to == "c") << link.from << ">" << link.to;
}

TEST(RadioNetwork, TheEndOfACutDoesNotBringBackWhatIsOutOfRange) {
  SimulatorConfig config = radio_config();
  config.cuts = {{"a", "b", at(1), at(2)}};
  Line line(config);
  line.put_b_at(50, 0);
  EXPECT_EQ(line.put_b_at(50, 1).size(), 2u);

  EXPECT_TRUE(line.put_b_at(500, 2).empty());
}

TEST(RadioNetwork, AHillBetweenTwoNodesCutsThem) {
  SimulatorConfig config = radio_config(1000);
  config.terrain = testing::with_hill(100, 0, 80, 60);
  RadioNetwork network(config, {"a", "b"});
  std::vector<Effect> effects;

  network.update({{0, 0, 30}, {200, 0, 30}}, config.terrain, at(0), effects);
  network.update({{0, 0, 30}, {200, 0, 200}}, config.terrain, at(5), effects);

  const auto links = links_of(effects);
  ASSERT_EQ(links.size(), 3u);
  EXPECT_EQ(links[0].from, kEveryLink);
  EXPECT_FALSE(links[0].up);
  EXPECT_TRUE(links[1].up);
  EXPECT_TRUE(links[2].up);
}

TEST(RadioNetwork, ACutOfOneDirectionLeavesTheOther) {
  SimulatorConfig config = radio_config();
  config.cuts = {{"b", "a", at(10), at(12), true}};
  Line line(config);
  line.put_b_at(50, 0);

  const auto cut = line.put_b_at(50, 10);
  const auto back = line.put_b_at(50, 12);

  ASSERT_EQ(cut.size(), 1U);
  EXPECT_EQ(cut[0], (LinkChange{"b", "a", false, Duration(), 1, at(10)}));
  ASSERT_EQ(back.size(), 1U);
  EXPECT_EQ(back[0], (LinkChange{"b", "a", true, Duration::milliseconds(20), 0.1, at(12)}));
}

TEST(RadioNetwork, AScriptedLinkIsUnlikeTheOthersWhileItIsUp) {
  SimulatorConfig config = radio_config();
  config.radio.capacity = 64'000;
  config.links = {{"a", "b", true, at(0), MissionTime::max(), {}, {}, 9'600},
                  {"a", "b", false, at(5), at(8), Duration::milliseconds(500), 0.5, {}}};
  Line line(config);

  const auto first = line.put_b_at(50, 0);
  const auto bad = line.put_b_at(50, 5);
  const auto gone = line.put_b_at(500, 6);
  const auto again = line.put_b_at(50, 9);

  ASSERT_EQ(first.size(), 2U);
  EXPECT_EQ(first[0], (LinkChange{"a", "b", true, Duration::milliseconds(20), 0.1, at(0), 9'600}));
  EXPECT_EQ(first[1], (LinkChange{"b", "a", true, Duration::milliseconds(20), 0.1, at(0), 64'000}));
  ASSERT_EQ(bad.size(), 2U);
  EXPECT_EQ(bad[0], (LinkChange{"a", "b", true, Duration::milliseconds(500), 0.5, at(5), 9'600}));
  ASSERT_EQ(gone.size(), 2U);
  EXPECT_FALSE(gone[0].up);
  EXPECT_EQ(gone[0].capacity, 0);
  ASSERT_EQ(again.size(), 2U);
  EXPECT_EQ(again[1].latency, Duration::milliseconds(20)) << "the second script is over";
}

/// What was told last of each link.
class Told {
 public:
  void take(const std::vector<LinkChange>& changes) {
    for (const LinkChange& change : changes) {
      const bool is_of_all = change.from == kEveryLink;
      RC_ASSERT(!is_of_all || links_.empty());
      if (!is_of_all) RC_ASSERT(of(change.from, change.to) != change.up || !known(change));
      (is_of_all ? others_ : links_[{change.from, change.to}]) = change.up;
    }
  }
  std::optional<bool> of(const std::string& from, const std::string& to) const {
    const auto found = links_.find({from, to});
    return found == links_.end() ? others_ : found->second;
  }

 private:
  bool known(const LinkChange& change) const { return links_.contains({change.from, change.to}); }
  std::map<std::pair<std::string, std::string>, std::optional<bool>> links_;
  std::optional<bool> others_;
};

// The oracle asks the model of each pair.
RC_GTEST_PROP(RadioNetwork, TellsWhatTheModelSaysOfEachPairHoweverTheyMove, ()) {
  constexpr std::size_t kNodes = 8;
  const SimulatorConfig config = radio_config(150);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < kNodes; ++i) names.push_back("n" + std::to_string(i));
  RadioNetwork network(config, names);
  const world::Terrain terrain(config.terrain);
  std::map<std::pair<std::size_t, std::size_t>, bool> is_up;
  Told told;
  std::vector<Vector3> places(kNodes);
  for (Vector3& place : places)
    place = {*rc::gen::inRange(-400, 400) * 1.0, *rc::gen::inRange(-400, 400) * 1.0, 60};

  for (int second = 0; second < 20; ++second) {
    for (Vector3& place : places)
      place += Vector3(*rc::gen::inRange(-30, 31), *rc::gen::inRange(-30, 31), 0);
    std::vector<Effect> effects;
    network.update(places, terrain, at(second), effects);
    told.take(links_of(effects));
    for (std::size_t a = 0; a < kNodes; ++a) {
      for (std::size_t b = 0; b < kNodes; ++b) {
        if (a == b) continue;
        bool& up = is_up[{a, b}];
        up = config.radio.link(places[a], places[b], terrain, up).up;
        RC_ASSERT(told.of(names[a], names[b]) == up);
      }
    }
  }
}

RC_GTEST_PROP(RadioNetwork, BothDirectionsAreAlwaysAlike, ()) {
  SimulatorConfig config = radio_config(300);
  config.terrain = testing::with_hill(0, 0, 60, 150);
  config.cuts = {{"a", "b", at(3), at(6)}};
  RadioNetwork network(config, {"a", "b", "c"});
  std::map<std::pair<std::string, std::string>, bool> up;
  const auto coordinate = rc::gen::inRange(-300, 300);

  for (int second = 0; second < 20; ++second) {
    std::vector<Vector3> positions;
    for (int i = 0; i < 3; ++i) positions.emplace_back(*coordinate, *coordinate, 70);
    std::vector<Effect> effects;
    network.update(positions, config.terrain, at(second), effects);
    for (const LinkChange& link : links_of(effects))
      if (link.from != kEveryLink) up[{link.from, link.to}] = link.up;

    for (const auto& [pair, is_up] : up) RC_ASSERT((up[{pair.second, pair.first}] == is_up));
  }
}

}  // namespace
}  // namespace skein::sim
