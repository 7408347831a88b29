// SPDX-License-Identifier: Apache-2.0
// Networks said not to be controllable: nature can break their executions, with the links that are
// named.
//
// Two things are shown. (1) By exhaustion, for tiny networks with whole bounds: with only the named
// links in the game, nature beats every controller that acts in whole units. (2) For larger ones:
// nature, fixing the durations of the named links alone, breaks two given controllers.
#include <gtest/gtest.h>

#include <set>

#include "execution/hopeful_executor.hpp"
#include "random_stnu.hpp"
#include "skein/temporal/stnu_controllability.hpp"
#include "stnu_game.hpp"

namespace skein::temporal {
namespace {

using testing::HopefulExecutor;
using testing::named_part;
using testing::random_stnu;
using testing::StnuGame;

TEST(Adversary, WithTheNamedLinksAloneNatureBeatsEveryController) {
  Random random(90);
  int beaten = 0;
  for (int i = 0; i < 6'000; ++i) {
    const auto nodes = static_cast<std::uint32_t>(3 + random.below(3));
    const Stnu network = random_stnu({nodes, 2, 4, 3, true, 7}, random);
    const auto result = check_dynamic_controllability(network);
    if (result->controllable || !result->consistent) continue;
    Stnu part = named_part(network, result->conflict);
    // The game needs an end; these arcs are in the network too.
    for (NodeIndex node = 1; node < nodes; ++node) part.arcs.push_back({0, node, 0, 7});

    ASSERT_FALSE(StnuGame(part).controller_wins()) << "network " << i;
    ++beaten;
  }
  EXPECT_GT(beaten, 300);
}

TEST(Adversary, WithoutTheNamedContingentLinksTheNamedArcsCanBeKept) {
  Random random(91);
  int seen = 0;
  for (int i = 0; i < 4'000; ++i) {
    const Stnu network = random_stnu({8, 3, 14, 9, false, 0}, random);
    const auto result = check_dynamic_controllability(network);
    if (result->controllable || !result->consistent) continue;
    Stnu part = named_part(network, result->conflict);
    EXPECT_FALSE(part.contingent.empty());
    for (const ContingentLink& link : part.contingent) {
      part.arcs.push_back({link.activation, link.contingent, link.min, link.max});
    }
    part.contingent.clear();

    ASSERT_TRUE(check_dynamic_controllability(part)->controllable) << "network " << i;
    ++seen;
  }
  EXPECT_GT(seen, 300);
}

/// All durations made of min, max and one between for the named links; the others take their least.
class NamedDurations {
 public:
  NamedDurations(const Stnu& network, const std::vector<ConflictTerm>& conflict)
      : network_(network) {
    for (const ContingentLink& link : network.contingent) durations_.push_back(link.min);
    std::set<std::uint32_t> named;
    for (const ConflictTerm& term : conflict) {
      if (term.link.kind == LinkKind::kContingent) named.insert(term.link.index);
    }
    named_.assign(named.begin(), named.end());
  }

  template <class Try>
  bool any(Try&& attempt) {
    return any_from(0, attempt);
  }

 private:
  template <class Try>
  bool any_from(std::size_t place, Try&& attempt) {
    if (place == named_.size()) return attempt(durations_);
    const ContingentLink& link = network_.contingent[named_[place]];
    for (const Ticks duration : {link.max, link.min, (link.min + link.max) / 2}) {
      durations_[named_[place]] = duration;
      if (any_from(place + 1, attempt)) return true;
    }
    return false;
  }

  const Stnu& network_;
  std::vector<std::uint32_t> named_;
  std::vector<Ticks> durations_;
};

TEST(Adversary, SomeDurationsOfTheNamedLinksBreakHopefulControllers) {
  Random random(92);
  int seen = 0;
  for (int i = 0; i < 3'000; ++i) {
    const auto nodes = static_cast<std::uint32_t>(5 + random.below(6));
    const Stnu network = random_stnu({nodes, 3, nodes, 15, true, 90}, random);
    const auto result = check_dynamic_controllability(network);
    if (result->controllable || !result->consistent) continue;
    ++seen;
    for (const auto style : {HopefulExecutor::Style::kEarliest, HopefulExecutor::Style::kLatest}) {
      HopefulExecutor controller(network, style);
      const bool broken =
          NamedDurations(network, result->conflict).any([&](const std::vector<Ticks>& durations) {
            return !controller.survives(durations);
          });
      ASSERT_TRUE(broken) << "network " << i
                          << (style == HopefulExecutor::Style::kEarliest ? " earliest" : " latest");
    }
  }
  EXPECT_GT(seen, 300);
}

}  // namespace
}  // namespace skein::temporal
