// SPDX-License-Identifier: Apache-2.0
#include "tour/ring.hpp"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <numeric>

#include "skein/foundation/random.hpp"

namespace skein::refiners {
namespace {

TourRing ring_of(City size) {
  std::vector<City> order(size);
  std::iota(order.begin(), order.end(), City{0});
  return TourRing(std::move(order));
}

/// From a place on in the present sense.
std::vector<City> read(const TourRing& ring, City from) {
  std::vector<City> order;
  for (City i = 0; i < ring.size(); ++i, from = ring.next(from)) order.push_back(from);
  return order;
}

TEST(TourRing, GoesRoundInBothSenses) {
  TourRing ring = ring_of(4);

  EXPECT_EQ(read(ring, 2), (std::vector<City>{2, 3, 0, 1}));
  ring.mirror();
  EXPECT_EQ(read(ring, 2), (std::vector<City>{2, 1, 0, 3}));
}

RC_GTEST_PROP(TourRing, TurnsAPartRoundAndLeavesTheRest, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  TourRing ring = ring_of(*rc::gen::inRange<City>(3, 20));
  for (int i = 0; i < 20; ++i) {
    if (random.chance(0.3)) ring.mirror();
    const City first = static_cast<City>(random.below(ring.size()));
    std::vector<City> expected = read(ring, first);
    const auto length = static_cast<std::ptrdiff_t>(1 + random.below(ring.size() - 1));
    const City last = expected[static_cast<std::size_t>(length) - 1];
    std::reverse(expected.begin(), expected.begin() + length);

    ring.turn(first, last);

    RC_ASSERT(read(ring, last) == expected);
    for (const City city : ring.order()) RC_ASSERT(ring.at(ring.position(city)) == city);
    for (const City city : ring.order()) RC_ASSERT(ring.previous(ring.next(city)) == city);
  }
}

RC_GTEST_PROP(TourRing, TakesTurnsBackWhateverTheSense, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  TourRing ring = ring_of(*rc::gen::inRange<City>(3, 20));
  const auto turn = [&] {
    if (random.chance(0.5)) ring.mirror();
    ring.turn(static_cast<City>(random.below(ring.size())),
              static_cast<City>(random.below(ring.size())));
  };
  for (int i = 0; i < 5; ++i) turn();
  if (!ring.reads_forwards()) ring.mirror();
  const std::vector<City> before = read(ring, 0);
  const std::size_t kept = ring.turns();
  for (int i = 0; i < 10; ++i) turn();

  ring.take_back(kept);

  std::vector<City> after = read(ring, 0);
  if (after != before) {
    ring.mirror();
    after = read(ring, 0);
  }
  RC_ASSERT(after == before);
  RC_ASSERT(ring.turns() == kept);
}

}  // namespace
}  // namespace skein::refiners
