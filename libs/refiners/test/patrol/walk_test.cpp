// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "patrol/walk_search.hpp"
#include "patrol/walk_times.hpp"
#include "skein/foundation/random.hpp"
#include "test_cases.hpp"
#include "testing/builders.hpp"
#include "testing/patrol_oracle.hpp"
#include "testing/turning_bound.hpp"

namespace skein::refiners {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace): builders read as words
using world::Polygon;
using world::Vector2;

/// A level ground of random risk, and what walks over it need.
struct Site {
  Site(std::size_t columns, std::size_t rows, double reach, std::uint64_t seed,
       std::vector<Polygon> closed = {})
      : zone{{0, 0},
             {static_cast<double>(columns), 0},
             {static_cast<double>(columns), static_cast<double>(rows)},
             {0, static_cast<double>(rows)}},
        world(level_world(2000, 200)),
        deadline(Budget{}),
        space(zone, std::move(closed)),
        sight(world.terrain, {.west = 0, .south = 0, .cell = 1, .columns = columns, .rows = rows},
              50, reach, deadline) {
    Random random(seed);
    std::vector<double> risk(columns * rows);
    for (double& one : risk) one = std::pow(random.uniform(), 4);
    field = make_patrol_field(space, sight, zone, risk, 0.05);
  }

  Polygon zone;
  world::World world;
  Deadline deadline;
  PatrolSpace space;
  PatrolSight sight;
  PatrolField field;
};

WalkGraph graph_of(const Site& site) {
  auto graph = make_walk_graph(site.field, site.space, site.sight);
  EXPECT_TRUE(graph.has_value());
  return graph ? *graph : WalkGraph{};
}

/// By points along the way a hundredth of a cell apart.
std::vector<bool> seen_along(const Site& site, const std::vector<Vector2>& way) {
  std::vector<bool> seen(site.sight.grid().size(), false);
  for (std::size_t i = 1; i < way.size(); ++i) {
    const int steps = 1 + static_cast<int>(100 * (way[i] - way[i - 1]).norm());
    for (int k = 0; k <= steps; ++k) {
      const Vector2 at = way[i - 1] + static_cast<double>(k) / steps * (way[i] - way[i - 1]);
      for (std::size_t cell = 0; cell < seen.size(); ++cell)
        if ((site.sight.grid().centre(cell) - at).norm() <= site.sight.footprint())
          seen[cell] = true;
    }
  }
  return seen;
}

/// The measure from its definition: when each place is passed, every gap squared.
double badness_by_hand(const WalkGraph& graph, const Walk& walk, const WalkMeasure& measure) {
  std::map<std::uint32_t, std::vector<double>> times;
  double now = 0;
  const std::size_t n = walk.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double detour = graph.detour(walk[(i + n - 1) % n], walk[i], walk[(i + 1) % n]);
    times[walk[i]].push_back(now + detour / 2);
    now += detour + graph.length(walk[i], walk[(i + 1) % n]);
  }
  double squares = 0, late = 0;
  for (auto& [place, at] : times) {
    at.push_back(at.front() + now);
    for (std::size_t k = 1; k < at.size(); ++k) {
      const double gap = at[k] - at[k - 1];
      squares += graph.places[place].risk * gap * gap;
      const double over = graph.places[place].top * gap / measure.worst_risk_idleness - 1;
      if (over > 0) late += measure.too_long * over * over;
    }
  }
  return squares / (2 * now * graph.total_risk * measure.mean_idleness) + late;
}

bool is_walk(const WalkGraph& graph, const Walk& walk) {
  for (std::size_t i = 0; i < walk.size(); ++i)
    if (!graph.are_linked(walk[i], walk[(i + 1) % walk.size()])) return false;
  return !walk.empty();
}

bool visits_all(const WalkGraph& graph, const Walk& walk) {
  for (std::uint32_t place = 0; place < graph.places.size(); ++place)
    if (std::find(walk.begin(), walk.end(), place) == walk.end()) return false;
  return true;
}

double length_around(const std::vector<Vector2>& track) {
  double length = (track.front() - track.back()).norm();
  for (std::size_t i = 1; i < track.size(); ++i) length += (track[i] - track[i - 1]).norm();
  return length;
}

TEST(WalkGraph, OnEveryPassOfAPlaceEveryOneOfItsCellsIsPerceived) {
  for (const double reach : {1.0, 2.0, 2.6, 3.0}) {
    const Site site(17, 22, reach, 1);
    const WalkGraph graph = graph_of(site);
    std::vector<bool> of_some(site.field.cells.size(), false);
    double risk = 0;
    for (std::uint32_t at = 0; at < graph.places.size(); ++at) {
      const WalkGraph::Place& place = graph.places[at];
      double least = 1e9;
      for (const auto& in : place.links)
        for (const auto& out : place.links) {
          const auto seen = seen_along(
              site, {(graph.places[in.to].at + place.at) / 2, graph.passed_at(in.to, at, out.to),
                     (graph.places[out.to].at + place.at) / 2});
          double sum = 0;
          for (std::uint32_t cell = 0; cell < seen.size(); ++cell)
            if (seen[site.field.cells[cell]]) sum += site.field.risk[cell];
          least = std::min(least, sum);
        }
      EXPECT_GE(least, place.risk - 1e-9) << "reach " << reach << ", place " << at;
      risk += place.risk;
    }
    EXPECT_NEAR(risk, site.field.total_risk, 1e-9);
  }
}

TEST(WalkGraph, ATrackIsAsLongAsItsLinksAndDetoursAndSeesEverything) {
  for (const double reach : {1.0, 2.0, 3.0}) {
    const Site site(20, 13, reach, 2);
    const WalkGraph graph = graph_of(site);
    const Walk walk = walk_in_turn(graph);
    ASSERT_TRUE(is_walk(graph, walk));

    std::vector<Vector2> track = track_of(graph, walk);

    double length = 0;
    for (std::size_t i = 0; i < walk.size(); ++i)
      length += graph.length(walk[i], walk[(i + 1) % walk.size()]) +
                graph.detour(walk[(i + walk.size() - 1) % walk.size()], walk[i],
                             walk[(i + 1) % walk.size()]);
    EXPECT_LE(length_around(track), length + 1e-9);  // turns in succession may save a little
    EXPECT_GE(length_around(track), 0.97 * length);
    track.push_back(track.front());
    const auto seen = seen_along(site, track);
    EXPECT_EQ(std::count(seen.begin(), seen.end(), false), 0) << "reach " << reach;
  }
}

TEST(WalkGraph, ThereIsNoneWhereACellWouldNotBePerceived) {
  const Site slanted(20, 20, 2, 1, {{{4, 4}, {11, 5}, {9, 12}}});
  EXPECT_FALSE(make_walk_graph(slanted.field, slanted.space, slanted.sight).has_value());
}

/// Changes as the search makes them: a corner cut the other way, a way there and back.
std::vector<WalkChange> changes_of(const WalkGraph& graph, const Walk& walk, Random& random) {
  std::vector<WalkChange> changes;
  for (std::size_t i = 0; i < walk.size(); ++i) {
    const std::uint32_t here = walk[i], behind = walk[(i + 2) % walk.size()];
    const auto& links = graph.places[here].links;
    const std::uint32_t aside = links[random.below(links.size())].to;
    changes.push_back({i, 0, {aside, here}, 2});
    if (aside != walk[(i + 1) % walk.size()] && graph.are_linked(aside, behind))
      changes.push_back({i, 1, {aside}, 1});
    if (here == behind) changes.push_back({i, 2, {}, 0});
  }
  return changes;
}

TEST(WalkTimes, WeighsAWalkByItsGaps) {
  const Site site(20, 16, 2, 3);
  const WalkGraph graph = graph_of(site);
  const WalkMeasure measure{.mean_idleness = 40, .worst_risk_idleness = 30, .too_long = 0.7};
  Walk twice = walk_in_turn(graph);
  twice.insert(twice.end(), twice.begin(), twice.end());
  WalkTimes times(graph);
  times.take(twice);
  times.measure_by(measure);

  EXPECT_NEAR(times.badness(), badness_by_hand(graph, twice, measure), 1e-9);
  EXPECT_NEAR(times.badness_of(twice), badness_by_hand(graph, twice, measure), 1e-9);
}

TEST(WalkTimes, KnowsWhatAChangeMakesOfTheMeanBeforeItIsMade) {
  for (const double reach : {1.0, 2.0, 3.0}) {
    const Site site(18, 18, reach, 4);
    const WalkGraph graph = graph_of(site);
    const WalkMeasure measure{.mean_idleness = 40, .worst_risk_idleness = 30, .too_long = 0};
    WalkTimes times(graph);
    times.measure_by(measure);
    times.take(walk_in_turn(graph));
    Random random(5);
    for (int round = 0; round < 6; ++round) {
      for (const WalkChange& change : changes_of(graph, times.walk(), random)) {
        const Walk changed = times.changed(change);
        ASSERT_TRUE(is_walk(graph, changed));
        if (!visits_all(graph, changed)) continue;
        const double then = badness_by_hand(graph, changed, measure);
        // A turn that becomes another moves its own visit by half of what it adds.
        EXPECT_NEAR(times.badness_after(change), then, reach < 1.5 ? 1e-9 : 5e-3 * then);
        EXPECT_NEAR(times.badness_of(changed), then, 1e-9);
      }
      auto changes = changes_of(graph, times.walk(), random);
      std::erase_if(changes, [&](const WalkChange& change) {
        return !visits_all(graph, times.changed(change));
      });
      times.take(times.changed(changes[random.below(changes.size())]));
    }
  }
}

/// What is too long elsewhere too: all gaps that are open at a change grow by it, or shrink.
TEST(WalkTimes, KnowsWhatAChangeMakesOfAllThatIsTooLong) {
  const Site site(20, 20, 1, 4);
  const WalkGraph graph = graph_of(site);
  WalkTimes times(graph);
  times.take(walk_in_turn(graph));
  const double longest = static_cast<double>(times.walk().size()) * graph.places[0].links[0].length;
  Random random(5);
  std::size_t elsewhere = 0;
  for (const double part : {1.0, 0.7, 0.3}) {
    const WalkMeasure measure{.mean_idleness = 1e6,
                              .worst_risk_idleness = part * longest,
                              .too_long = 0.7,
                              .looks_elsewhere = true};
    times.measure_by(measure);
    for (const WalkChange& change : changes_of(graph, times.walk(), random)) {
      const Walk changed = times.changed(change);
      if (!visits_all(graph, changed)) continue;
      const double then = badness_by_hand(graph, changed, measure);
      EXPECT_NEAR(times.badness_after(change), then, 1e-9);
      elsewhere += then > times.badness() + 1e-6 ? 1 : 0;
    }
  }
  EXPECT_GT(elsewhere, 50U);
}

struct Annealed {
  Walk walk;
  double badness;
};

Annealed annealed(const WalkGraph& graph, const WalkMeasure& measure, const Cooling& cooling,
                  std::uint64_t steps = std::numeric_limits<std::uint64_t>::max()) {
  Budget budget;
  budget.steps = steps;
  Countdown countdown(budget);
  Deadline deadline(budget);
  const Walk walk = annealed_walk(graph, {measure.mean_idleness, measure.worst_risk_idleness}, 1,
                                  cooling, {countdown, deadline});
  return {walk, walk.empty() ? 0 : badness_by_hand(graph, walk, measure)};
}

TEST(AnnealedWalk, VisitsEveryPlaceAndIsBetterThanTheRoundItBeganWith) {
  const Site site(24, 24, 1.5, 6);
  const WalkGraph graph = graph_of(site);
  const WalkMeasure measure{.mean_idleness = 90, .worst_risk_idleness = 400, .too_long = 1};

  const auto [walk, badness] = annealed(graph, measure, Cooling{});

  ASSERT_TRUE(is_walk(graph, walk));
  EXPECT_TRUE(visits_all(graph, walk));
  EXPECT_LT(badness, 0.95 * badness_by_hand(graph, walk_in_turn(graph), measure));
  EXPECT_EQ(annealed(graph, measure, Cooling{}).walk, walk) << "the same seed";
}

/// Risk as of real fires, in whose peaks a few places lie each.
TEST(AnnealedWalk, OfPeaksOfAFewPlacesIsBetterIfItIsHotLonger) {
  Site site(33, 33, 3, 1);
  const world::GroundState ground = scattered_ground(33, 1, 3);
  site.field = make_patrol_field(site.space, site.sight, site.zone, ground.risk, 0.05);
  const WalkGraph graph = graph_of(site);
  const WalkMeasure round{.mean_idleness = 1, .worst_risk_idleness = 1e9, .too_long = 0};
  const double in_turn = badness_by_hand(graph, walk_in_turn(graph), round);
  const WalkMeasure measure{
      .mean_idleness = 0.92 * in_turn, .worst_risk_idleness = 1e9, .too_long = 1};

  const double mild = annealed(graph, measure, {.from = 6e-4, .to = 8e-6}).badness;
  const double hot =
      annealed(graph, measure, {.from = 4e-3, .to = 2e-5, .changes_a_place = 48000}).badness;

  EXPECT_LT(hot, mild);
  EXPECT_GE(hot, least_mean_of_walks(graph) / measure.mean_idleness);
}

TEST(AnnealedWalk, HasNoMoreVisitsAPlaceThanItMay) {
  Site site(36, 36, 1.5, 1);
  const world::GroundState ground = scattered_ground(36, 1, 3);
  site.field = make_patrol_field(site.space, site.sight, site.zone, ground.risk, 0.05);
  const WalkGraph graph = graph_of(site);
  const WalkMeasure measure{.mean_idleness = 150, .worst_risk_idleness = 1e9, .too_long = 1};
  const auto visits = [&](std::size_t a_place) {
    const Cooling cooling{
        .from = 4e-3, .to = 2e-5, .changes_a_place = 2000, .visits_a_place = a_place};
    return annealed(graph, measure, cooling).walk.size();
  };

  EXPECT_LE(visits(1), walk_in_turn(graph).size());
  EXPECT_GT(visits(4), walk_in_turn(graph).size());
}

TEST(LeastMeanOfWalks, IsThatOfARoundWhereEveryPlaceIsAlike) {
  Site site(24, 24, 1, 1);
  std::fill(site.field.risk.begin(), site.field.risk.end(), 0.5);
  site.field.total_risk = 0.5 * static_cast<double>(site.field.cells.size());
  const WalkGraph graph = graph_of(site);

  // 144 places two cells apart, each passed once a round of 288 cells: waits half a round.
  EXPECT_NEAR(least_mean_of_walks(graph), 144, 1e-6);
}

TEST(AnnealedWalk, EndsWhenItsStepsAreUsedUp) {
  const Site site(24, 24, 1.5, 6);
  const WalkGraph graph = graph_of(site);

  const auto [walk, badness] =
      annealed(graph, {.mean_idleness = 90, .worst_risk_idleness = 150}, Cooling{}, 3);

  EXPECT_TRUE(is_walk(graph, walk));
}

/// All closed walks up to a length that visit every place, the best of them: what no search can
/// beat.
class BestOfAll {
 public:
  BestOfAll(const WalkGraph& graph, const WalkMeasure& measure, std::size_t longest)
      : graph_(graph), measure_(measure), longest_(longest) {
    walk_ = {0};
    extend();
  }
  double badness() const { return least_; }

 private:
  void extend() {
    if (walk_.size() > 1 && graph_.are_linked(walk_.back(), 0)) judge();
    if (walk_.size() == longest_) return;
    for (const auto& link : graph_.places[walk_.back()].links) {
      walk_.push_back(link.to);
      extend();
      walk_.pop_back();
    }
  }
  void judge() {
    if (!visits_all(graph_, walk_)) return;
    least_ = std::min(least_, badness_by_hand(graph_, walk_, measure_));
  }

  const WalkGraph& graph_;
  WalkMeasure measure_;
  std::size_t longest_;
  Walk walk_;
  double least_ = 1e18;
};

TEST(LeastMeanOfWalks, IsNotAboveTheBestOfAllClosedWalksNorFarBelowItWhereRiskIsEven) {
  const int sites = skein::testing::long_tests() ? 12 : 3;
  for (int seed = 1; seed <= sites; ++seed) {
    const Site site(6, 4, seed % 2 == 0 ? 1 : 0.9, static_cast<std::uint64_t>(seed));
    const WalkGraph graph = graph_of(site);
    const WalkMeasure mean{.mean_idleness = 1, .worst_risk_idleness = 1e9, .too_long = 0};

    const double best = BestOfAll(graph, mean, 12).badness(), bound = least_mean_of_walks(graph);

    EXPECT_LE(bound, best + 1e-9) << "seed " << seed;
    EXPECT_GE(bound, 0.6 * best) << "seed " << seed;
  }
}

TEST(LeastMeanOfWalks, WithTheirTurnsIsBetweenThatWithoutAndTheBestOfAllClosedWalks) {
  for (std::uint64_t seed = 1; seed <= (skein::testing::long_tests() ? 12U : 3U); ++seed) {
    const Site site(6, 4, 1.5, seed);
    const WalkGraph graph = graph_of(site);
    const WalkMeasure mean{.mean_idleness = 1, .worst_risk_idleness = 1e9, .too_long = 0};

    const testing::TurningBound bound = testing::least_mean_with_turns(graph, 300);

    EXPECT_LE(bound.proved, BestOfAll(graph, mean, 12).badness() + 1e-9) << "seed " << seed;
    EXPECT_GE(bound.most, least_mean_of_walks(graph) - 1e-9) << "seed " << seed;
    EXPECT_GE(bound.proved, 0.99 * bound.most) << "seed " << seed;
  }
}

TEST(LeastMeanOfWalks, WithTheirTurnsIsHigherWherePeaksOfAFewPlacesAreTurnedAt) {
  Site site(36, 36, 3, 1);
  const world::GroundState ground = scattered_ground(36, 1, 3);
  site.field = make_patrol_field(site.space, site.sight, site.zone, ground.risk, 0.05);
  const WalkGraph graph = graph_of(site);

  EXPECT_GT(testing::least_mean_with_turns(graph, 300).proved, 1.005 * least_mean_of_walks(graph));
}

TEST(LeastWorstOfWalks, IsThatOfARoundWhereEveryPlaceIsAlike) {
  Site site(24, 24, 1, 1);
  std::fill(site.field.risk.begin(), site.field.risk.end(), 0.5);
  site.field.total_risk = 0.5 * static_cast<double>(site.field.cells.size());
  const WalkGraph graph = graph_of(site);

  EXPECT_NEAR(least_worst_of_walks(graph), 0.5 * 288, 1e-6);
  EXPECT_NEAR(least_mean_of_walks(graph, 0.5 * 288 + 1e-6), 144, 1e-3);
  EXPECT_EQ(least_mean_of_walks(graph, 0.5 * 287), std::numeric_limits<double>::infinity());
}

/// A walk that keeps the worst is counted by its mean, others are dearer than any.
TEST(LeastMeanOfWalks, ThatKeepTheWorstIsNotAboveTheBestOfAllClosedWalksThatDo) {
  for (std::uint64_t seed = 1; seed <= (skein::testing::long_tests() ? 8U : 2U); ++seed) {
    const Site site(6, 4, 1, seed);
    const WalkGraph graph = graph_of(site);
    const double least = least_worst_of_walks(graph);
    for (const double part : {0.999, 1.3, 1.8, 3.0}) {
      const double worst = part * least;
      const WalkMeasure kept{.mean_idleness = 1, .worst_risk_idleness = worst, .too_long = 1e12};

      const double best = BestOfAll(graph, kept, 12).badness();

      if (part < 1) {
        EXPECT_GT(best, 1e3) << "seed " << seed;
      } else {
        EXPECT_LE(least_mean_of_walks(graph, worst), best + 1e-9) << "seed " << seed << ' ' << part;
      }
      EXPECT_GE(least_mean_of_walks(graph, worst), least_mean_of_walks(graph) - 1e-6);
    }
  }
}

TEST(AnnealedWalk, OfAFewPlacesIsAsGoodAsTheBestOfAllClosedWalksOfTwiceTheirNumber) {
  const int sites = skein::testing::long_tests() ? 6 : 2;
  for (int seed = 1; seed <= sites; ++seed) {
    const Site site(6, 4, 1, static_cast<std::uint64_t>(seed));
    const WalkGraph graph = graph_of(site);
    ASSERT_EQ(graph.places.size(), 6U);
    const WalkMeasure measure{.mean_idleness = 6, .worst_risk_idleness = 1000, .too_long = 1};

    const auto [walk, badness] = annealed(graph, measure, Cooling{});

    ASSERT_FALSE(walk.empty());
    EXPECT_LE(badness, 1.02 * BestOfAll(graph, measure, 12).badness()) << "seed " << seed;
  }
}

}  // namespace
}  // namespace skein::refiners
