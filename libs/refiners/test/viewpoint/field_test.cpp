// SPDX-License-Identifier: Apache-2.0
#include "viewpoint/field.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "viewpoint/cases.hpp"

namespace skein::refiners {
namespace {

ViewpointCase any_case() {
  const auto seed = *rc::gen::inRange<std::uint64_t>(1, 1000);
  Random random(seed, "ground");
  return random_case(seed, random_hills(random), 1);
}

TEST(Bearing, CountsAFullTurn) {
  EXPECT_EQ(Bearing::radians(0), 0);
  EXPECT_DOUBLE_EQ(Bearing::radians(Bearing::kTurn / 4), std::numbers::pi / 2);
}

TEST(BearingCell, ItsAngularRadiusReachesItsCorners) {
  const BearingCell cell{0, Bearing::kTurn / 8, 0.2, 0.6, 10, 20};
  const Bearing middle = cell.middle();
  const auto direction = [](const Bearing& b) {
    return world::direction_of(Bearing::radians(b.azimuth), b.elevation);
  };

  for (const std::int32_t azimuth : {cell.azimuth, cell.azimuth_end})
    for (const double elevation : {0.2, 0.6}) {
      const double angle = std::acos(direction(middle).dot(direction({azimuth, elevation, 10})));
      EXPECT_LE(angle, cell.angular_radius());
      EXPECT_GT(angle, 0.5 * cell.angular_radius());
    }
}

RC_GTEST_PROP(ViewpointField, NoPlaceOfACellIsWorthMoreThanItsBound, ()) {
  const ViewpointCase c = any_case();
  const Setting setting{c.world, {}, 1, nullptr};
  const ViewpointField field(c.query, setting, c.query.vehicle.sensors[0]);
  const BearingCell& whole = field.whole();
  const auto part = [](double from, double to) {
    return from + (to - from) * *rc::gen::inRange(0, 1001) * 0.001;
  };
  BearingCell cell;
  cell.azimuth = *rc::gen::inRange(0, Bearing::kTurn);
  cell.azimuth_end = std::min(Bearing::kTurn, cell.azimuth + *rc::gen::inRange(0, 3000));
  cell.elevation = part(whole.elevation, whole.elevation_end);
  cell.elevation_end = part(cell.elevation, std::min(whole.elevation_end, cell.elevation + 0.5));
  cell.range = part(whole.range, whole.range_end);
  cell.range_end = part(cell.range, whole.range_end);

  const Bearing bearing{*rc::gen::inRange(cell.azimuth, cell.azimuth_end + 1),
                        part(cell.elevation, cell.elevation_end), part(cell.range, cell.range_end)};

  RC_ASSERT(field.place(bearing).utility <= field.utility_bound(cell) + 1e-9);
}

RC_GTEST_PROP(ViewpointField, JudgesAsTheQuerySays, ()) {
  const ViewpointCase c = any_case();
  const Setting setting{c.world, {}, 1, nullptr};
  ViewpointField field(c.query, setting, c.query.vehicle.sensors[0]);
  const BearingCell& whole = field.whole();
  for (int i = 0; i < 200; ++i) {
    const Bearing bearing{
        *rc::gen::inRange(0, Bearing::kTurn),
        std::lerp(whole.elevation, whole.elevation_end, *rc::gen::inRange(0, 1001) * 0.001),
        std::lerp(whole.range, whole.range_end, *rc::gen::inRange(0, 1001) * 0.001)};
    const Place place = field.place(bearing);

    const Verdict verdict = field.judge(bearing, place);

    // What grazes the ground may be called hidden, never the other way round.
    if (verdict.fate == Fate::kGood) RC_ASSERT(will_do(c, place.position));
    if (verdict.fate == Fate::kHidden) RC_ASSERT(will_do(c, place.position, false));
    if (will_do(c, place.position))
      RC_ASSERT(verdict.fate == Fate::kGood || verdict.fate == Fate::kHidden ||
                verdict.fate == Fate::kImperceptible);
  }
}

TEST(ViewpointField, TracesTheGroundOncePerAzimuth) {
  const ViewpointCase c = [] {
    Random random(3, "ground");
    return random_case(3, random_hills(random), 1);
  }();
  ViewpointCase open = c;
  open.world.volumes.clear();
  open.query.constraints.clear();
  open.query.clearance = 0;
  open.query.vehicle.ceiling = 1e5;
  open.query.vehicle.sensors[0] = a_camera();
  open.query.vehicle.sensors[0].quality.incidence_power = 0;
  const Setting setting{open.world, {}, 1, nullptr};
  ViewpointField field(open.query, setting, open.query.vehicle.sensors[0]);

  for (const std::int32_t azimuth : {0, 960, 0, 960, 960})
    for (const double elevation : {0.9, 1.0, 1.2}) {
      const Bearing bearing{azimuth, elevation, 100};
      field.judge(bearing, field.place(bearing));
    }

  EXPECT_EQ(field.sight_checks(), 2u);
}

}  // namespace
}  // namespace skein::refiners
