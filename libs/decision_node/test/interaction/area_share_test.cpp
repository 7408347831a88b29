// SPDX-License-Identifier: Apache-2.0
#include "interaction/area_share.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interaction/area_cutting.hpp"
#include "testing/shared_field.hpp"

namespace skein::decision_node {
namespace {

using interaction::Row;
using interaction::Rows;
using testing::agreed;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::kEast;
using testing::kWest;
using testing::setting_at;
using ::testing::SizeIs;
using world::Polygon;
using world::Vector2;

double area_of(const Rows& left) {
  double sum = 0;
  for (const Row& row : left) {
    if (row.name == "left") sum += world::area(interaction::polygon_of(row));
  }
  return sum;
}

TEST(AreaShare, TellsNothingBeforeItIsAgreed) {
  const AreaShare share("heron");

  EXPECT_FALSE(share.agreed());
  EXPECT_THAT(share.left(), IsEmpty());
}

TEST(AreaShare, AllOfItsPartIsLeftUntilSomeIsFlown) {
  AreaShare share("heron");

  share.agree(agreed(kWest, kEast));

  EXPECT_TRUE(share.agreed());
  EXPECT_NEAR(area_of(share.left()), 40000, 1e-6);
  EXPECT_NEAR(share.area_left(), 40000, 1e-6);
}

TEST(AreaShare, WhatIsFlownIsNotLeftAndWhatIsLeftIsNeverLess) {
  AreaShare share("heron");
  share.agree(agreed(kWest, kEast));
  const auto way = share.set_out(setting_at({-50, -20, 60}));
  ASSERT_TRUE(way) << way.error().why;

  double before = share.area_left(), flown = 0;
  std::vector<double> lefts;
  for (std::size_t i = 0; i + 1 < way->size(); ++i) {
    const world::Vector3 leg = (*way)[i + 1] - (*way)[i];
    for (int step = 0; step <= 20; ++step) share.fly((*way)[i] + step / 20.0 * leg, 5);
    flown += leg.norm();
    EXPECT_LE(share.area_left(), before + 1e-6);
    // A swath of 60 m: no more can be done than that.
    EXPECT_GE(share.area_left(), 40000 - 60 * flown);
    before = share.area_left();
    lefts.push_back(before);
  }

  EXPECT_LT(lefts[lefts.size() / 2], 30000);
  EXPECT_NEAR(lefts.back(), 0, 1e-6);
}

TEST(AreaShare, WhoSetsOutAgainSweepsOnlyWhatIsLeft) {
  AreaShare share("heron");
  share.agree(agreed(kWest, kEast));
  const auto all = share.set_out(setting_at({-50, -20, 60}));
  ASSERT_TRUE(all);
  for (std::size_t i = 0; 2 * i < all->size(); ++i) share.fly((*all)[i], 5);
  const double left = share.area_left();
  ASSERT_GT(left, 5000);
  ASSERT_LT(left, 35000);

  const auto rest = share.set_out(setting_at((*all)[all->size() / 2]));

  ASSERT_TRUE(rest);
  EXPECT_LT(refiners::length_of(*rest), 0.8 * refiners::length_of(*all));
  EXPECT_NEAR(share.area_left(), left, 1e-6);
}

TEST(AreaShare, WhatALostPartnerHadLeftIsNobodys) {
  AreaShare share("heron");
  share.agree(agreed(kWest, kEast));
  share.told("wren",
             {{"round", "", {1}}, interaction::row_of("left", between(kEast, {1, 0}, 300, 400))});

  share.lose("wren");

  ASSERT_THAT(share.nobodys(), SizeIs(1));
  EXPECT_NEAR(world::area(share.nobodys().front()), 20000, 1e-6);
  share.lose("wren");
  EXPECT_THAT(share.nobodys(), SizeIs(1));
}

TEST(AreaShare, WhatAPartnerHasThatGoesOnWithoutItStaysThePartners) {
  AreaShare share("heron");
  share.agree(agreed(kWest, kEast));
  share.leave_to("wren");
  share.lose("wren");
  EXPECT_THAT(share.nobodys(), IsEmpty());

  share.agree({interaction::row_of("wren", kEast)});
  share.lose("wren");
  ASSERT_THAT(share.nobodys(), SizeIs(1)) << "lost, and nothing is heard of it";
  share.leave_to("wren");
  EXPECT_THAT(share.nobodys(), IsEmpty()) << "a third one tells of it";
  EXPECT_NEAR(share.area_left(), 40000, 1e-6);
}

// A partner that was lost is heard again: two others have what it had left.
TEST(AreaShare, WhoWasLostYieldsWhatOthersTookOfItsPart) {
  AreaShare heron("heron"), wren("wren");
  const Polygon north = between(kEast, {0, 1}, 100, 200), south = between(kEast, {0, 1}, 0, 100);
  for (AreaShare* one : {&heron, &wren}) one->agree(agreed(kWest, kEast));
  heron.lose("wren");
  heron.agree({interaction::row_of("heron", north), interaction::row_of("swift", south)});
  wren.lose("heron");

  EXPECT_FALSE(wren.yield_to("heron", heron.left())) << "half of it is still its own";
  AreaShare swift("swift");
  swift.agree(agreed(kWest, kEast));
  swift.lose("wren");
  swift.agree({interaction::row_of("heron", north), interaction::row_of("swift", south)});
  EXPECT_TRUE(wren.yield_to("swift", swift.left()));

  EXPECT_EQ(wren.area_left(), 0);
  EXPECT_NEAR(area_of(heron.left()), 60000, 1e-6) << "what it took is told beside what is left";
}

TEST(AreaShare, WhoTookAllThatOthersStillHaveYieldsThat) {
  AreaShare heron("heron"), wren("wren");
  for (AreaShare* one : {&heron, &wren}) one->agree(agreed(kWest, kEast));
  wren.lose("heron");
  wren.take(wren.nobodys());
  ASSERT_NEAR(wren.area_left(), 80000, 1e-6);

  EXPECT_TRUE(wren.yield_to("heron", heron.left()));

  EXPECT_NEAR(wren.area_left(), 40000, 1e-6);
}

TEST(AreaShare, OfAPartnerThatToldNothingAllItsPartIsNobodys) {
  AreaShare share("heron");
  share.agree(agreed(kWest, kEast));

  share.lose("wren");

  ASSERT_THAT(share.nobodys(), SizeIs(1));
  EXPECT_NEAR(world::area(share.nobodys().front()), 40000, 1e-6);
}

TEST(AreaShare, WhatWasToldBeforeItWasSharedAgainDoesNotCount) {
  AreaShare share("heron");
  share.agree(agreed(kWest, kEast));
  share.agree(agreed({}, {{400, 0}, {500, 0}, {500, 100}, {400, 100}}));

  share.told("wren", {{"round", "", {1}}});
  share.lose("wren");

  EXPECT_THAT(share.nobodys(), SizeIs(2));
}

TEST(AreaShare, WhatIsSharedAgainComesToWhatIsLeft) {
  AreaShare share("heron");
  share.agree(agreed(kWest, kEast));
  share.lose("wren");

  share.agree({interaction::row_of("heron", kEast)});

  EXPECT_THAT(share.nobodys(), IsEmpty());
  EXPECT_NEAR(share.area_left(), 80000, 1e-6);
}

// Its session was opened before swift was lost.
TEST(AreaShare, WhatWasNotSharedAgainStaysNobodys) {
  AreaShare share("heron");
  share.agree({interaction::row_of("wren", kWest), interaction::row_of("swift", kEast)});
  share.lose("wren");
  share.lose("swift");

  share.agree({interaction::row_of("heron", kWest)});

  ASSERT_THAT(share.nobodys(), SizeIs(1));
  EXPECT_NEAR(world::area(between(share.nobodys().front(), {1, 0}, 200, 400)), 40000, 1e-6);
}

TEST(AreaShare, WhoIsLostTwiceLeavesBothOfItsParts) {
  AreaShare share("heron");
  share.agree({interaction::row_of("wren", kWest)});
  share.lose("wren");
  share.agree({interaction::row_of("wren", kEast)});

  share.lose("wren");

  EXPECT_THAT(share.nobodys(), SizeIs(2));
}

/// A session that shares anew what these told.
interaction::Terms asked_by(const AreaShare& newcomer, const std::string& name) {
  interaction::Terms terms;
  terms.opener = name;
  terms.parameters = newcomer.to_share();
  return terms;
}

// Swift comes when wren has mapped a quarter of the whole.
TEST(AreaShare, WhoComesLaterSharesWhatIsLeftToAll) {
  AreaShare heron("heron"), wren("wren"), swift("swift");
  for (AreaShare* one : {&heron, &wren}) one->agree(agreed(kWest, kEast));
  EXPECT_FALSE(swift.comes_later());
  swift.told("heron", heron.left());
  swift.told("wren",
             {{"round", "", {1}}, interaction::row_of("left", between(kEast, {1, 0}, 300, 400))});
  ASSERT_TRUE(swift.comes_later());
  const interaction::Terms terms = asked_by(swift, "swift");
  double asked = 0;
  for (const Row& row : terms.parameters)
    if (row.name == "area") asked += world::area(interaction::polygon_of(row));
  EXPECT_NEAR(asked, 40000 + 20000, 1e-6);

  const Polygon north = between(kWest, {0, 1}, 100, 200), south = between(kWest, {0, 1}, 0, 100);
  const Rows parts{interaction::row_of("heron", north), interaction::row_of("swift", south),
                   interaction::row_of("wren", between(kEast, {1, 0}, 300, 400))};
  for (AreaShare* one : {&heron, &wren, &swift}) one->agree(parts, terms.parameters);

  EXPECT_NEAR(heron.area_left(), 20000, 1e-6) << "in its stead";
  EXPECT_NEAR(wren.area_left(), 20000, 1e-6);
  EXPECT_NEAR(swift.area_left(), 20000, 1e-6);
  heron.told("swift", swift.left());
  heron.lose("swift");
  ASSERT_THAT(heron.nobodys(), SizeIs(1));
  EXPECT_NEAR(world::area(heron.nobodys().front()), 20000, 1e-6);
}

// Whose session had ended before they could take part in it.
TEST(AreaShare, ThoseWhoAreAtItShareAnewLikewiseWhenSomebodyHasCome) {
  AreaShare heron("heron");
  heron.agree({interaction::row_of("heron", kWest), interaction::row_of("wren", kEast)});
  EXPECT_THAT(heron.to_share(), IsEmpty());
  heron.take_in("swift");

  const Rows rows = heron.to_share();

  ASSERT_THAT(rows, SizeIs(4));
  EXPECT_EQ(rows[0], (Row{interaction::kAnew, "heron", {1}}));
  EXPECT_EQ(rows[2], (Row{interaction::kAnew, "wren", {1}}));
  heron.agree({interaction::row_of("swift", kWest)}, rows);
  EXPECT_EQ(heron.area_left(), 0);
  EXPECT_THAT(heron.to_share(), IsEmpty()) << "swift has its part";
}

TEST(AreaShare, WhoComesLaterSharesWhatOneHadLeftWhoIsLostMeanwhile) {
  AreaShare swift("swift");
  for (const char* name : {"heron", "wren"}) {
    AreaShare there(name);
    there.agree(agreed(kWest, kEast));
    swift.told(name, there.left());
  }

  swift.lose("wren");

  const Rows rows = swift.to_share();
  double area = 0;
  for (const Row& row : rows) {
    if (row.name == "area") area += world::area(interaction::polygon_of(row));
    EXPECT_FALSE(row.name == interaction::kAnew && row.text == "wren") << "it offers nothing";
  }
  EXPECT_NEAR(area, 80000, 1e-6);
}

TEST(AreaShare, WhatIsSharedAnewIsOfferedAsIfItHadNone) {
  AreaShare heron("heron"), swift("swift");
  heron.agree(agreed(kWest, kEast));
  heron.take_in("swift");
  swift.told("heron", heron.left());

  const auto offer = heron.offer(asked_by(swift, "swift"), setting_at({-50, -20, 60}));

  ASSERT_TRUE(offer) << offer.error().why;
  const auto sweeper = interaction::sweeper_of(*offer);
  ASSERT_TRUE(sweeper);
  EXPECT_EQ(sweeper->busy, 0);
  EXPECT_EQ(sweeper->start, Vector2(-50, -20));
}

TEST(AreaShare, WhatIsNotAsItIsIsNotSharedAnew) {
  AreaShare heron("heron"), swift("swift");
  heron.agree(agreed(kWest, kEast));
  heron.take_in("swift");
  const SweepSetting setting = setting_at({-50, -20, 60});

  const auto unknown = heron.offer(asked_by(swift, "swift"), setting);
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().why, "'swift' does not know yet what it has left");

  swift.told("heron", heron.left());
  heron.lose("wren");
  heron.take(heron.nobodys());
  const auto old = heron.offer(asked_by(swift, "swift"), setting);
  ASSERT_FALSE(old);
  EXPECT_EQ(old.error().why, "what it has left was shared since");
}

// A session without it was under way.
TEST(AreaShare, ADivisionHasTheSameNumberForWhoHasSeenNoneBefore) {
  AreaShare heron("heron"), swift("swift");
  heron.agree(agreed(kWest, kEast));
  heron.lose("wren");
  const Rows parameters{{interaction::kDivisions, "", {1}}};
  for (AreaShare* one : {&heron, &swift})
    one->agree({interaction::row_of("swift", kEast)}, parameters);

  EXPECT_EQ(heron.divisions(), 2);
  EXPECT_EQ(swift.divisions(), 2);
}

// Found by random missions (--sharing 83): two that never heard each other map all of it.
TEST(AreaShare, OfTwoThatEachTookAllBeforeItWasSharedOneYieldsAll) {
  AreaShare heron("heron"), wren("wren");
  heron.lose("wren");
  heron.take({kWest, kEast});
  wren.lose("heron");
  wren.take({kWest, kEast});
  const auto way = heron.set_out(setting_at({-50, -20, 60}));
  ASSERT_TRUE(way);
  for (std::size_t i = 0; 2 * i < way->size(); ++i) heron.fly((*way)[i], 5);
  ASSERT_LT(heron.area_left(), 70000);

  EXPECT_TRUE(wren.yield_to("heron", heron.left()));

  EXPECT_EQ(wren.area_left(), 0) << "what heron has mapped is mapped";
}

TEST(AreaShare, TheLastWhoIsThereTakesAll) {
  AreaShare share("heron");
  share.agree(agreed(kWest, kEast));
  share.lose("wren");

  share.take(share.nobodys());

  EXPECT_THAT(share.nobodys(), IsEmpty());
  EXPECT_NEAR(share.area_left(), 80000, 1e-6);
}

TEST(AreaShare, AnOfferSaysWhatItCanDoAndHowLongItIsBusy) {
  AreaShare share("heron");
  const auto free = share.offer({}, setting_at({-50, -20, 60}));
  share.agree(agreed(kWest, kEast));
  const auto busy = share.offer({}, setting_at({-50, -20, 60}));

  ASSERT_TRUE(free && busy);
  const auto first = interaction::sweeper_of(*free), then = interaction::sweeper_of(*busy);
  ASSERT_TRUE(first && then) << first.error();
  EXPECT_EQ(first->busy, 0);
  EXPECT_EQ(first->start, Vector2(-50, -20));
  EXPECT_NEAR(first->swath, 60, 3);
  // 40,000 m² at 60 m and 8 m/s take 83 s without turns.
  EXPECT_GT(then->busy, 83);
  EXPECT_LT(then->busy, 250);
  EXPECT_LT(then->vehicle.energy.capacity, first->vehicle.energy.capacity);
}

TEST(AreaShare, WhoHasNoEnergyOrNoDeviceOffersNothing) {
  const AreaShare share("heron");
  SweepSetting blind = setting_at({-50, -20, 60});
  blind.device = "radar";

  const auto spent = share.offer({}, setting_at({-50, -20, 60}, 0.05)),
             unseeing = share.offer({}, blind);

  ASSERT_FALSE(spent);
  EXPECT_EQ(spent.error().why, "it has no energy for more");
  ASSERT_FALSE(unseeing);
  EXPECT_EQ(unseeing.error().why, "heron has no device 'radar'");
}

TEST(AreaShare, NothingLeftIsNoWay) {
  AreaShare share("heron");
  share.agree(agreed(kWest, kEast));
  ASSERT_TRUE(share.set_out(setting_at({0, 0, 60})));
  share.flown();

  const auto way = share.set_out(setting_at({0, 0, 60}));

  ASSERT_TRUE(way);
  EXPECT_THAT(*way, IsEmpty());
  EXPECT_THAT(share.left(), SizeIs(1));
}

}  // namespace
}  // namespace skein::decision_node
