// SPDX-License-Identifier: Apache-2.0
#include "skein/geodesy/geodetic_frame.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

namespace skein::geodesy {
namespace {

using world::GeodeticPoint;
using world::Vector3;

constexpr double kEquator = 6378137;         // semi-major axis of WGS 84 [m]
constexpr double kPole = 6356752.314245179;  // semi-minor axis [m]
constexpr double kDegree = std::numbers::pi / 180;

GeodeticPoint any_point() {
  return {*rc::gen::inRange(-89'000, 89'000) / 1000.0,
          *rc::gen::inRange(-180'000, 180'000) / 1000.0, *rc::gen::inRange(-500, 9000) * 1.0};
}

/// Geocentric coordinates by the textbook.
Vector3 geocentric(const GeodeticPoint& point) {
  const double lat = point.latitude_degrees * kDegree, lon = point.longitude_degrees * kDegree;
  const double e2 = 1 - kPole * kPole / (kEquator * kEquator);
  const double n = kEquator / std::sqrt(1 - e2 * std::sin(lat) * std::sin(lat));
  return {(n + point.altitude) * std::cos(lat) * std::cos(lon),
          (n + point.altitude) * std::cos(lat) * std::sin(lon),
          (n * (1 - e2) + point.altitude) * std::sin(lat)};
}

TEST(GeodeticFrame, TheOriginIsZero) {
  const GeodeticFrame frame({37.3, -6, 150});

  EXPECT_LT(frame.to_local({37.3, -6, 150}).norm(), 1e-8);
  EXPECT_EQ(frame.origin(), (GeodeticPoint{37.3, -6, 150}));
}

TEST(GeodeticFrame, EastNorthAndUpAreWhereTheyShould) {
  const GeodeticFrame frame({0, 0, 0});

  EXPECT_LT((frame.to_local({0, 0, 100}) - Vector3(0, 0, 100)).norm(), 1e-8);
  EXPECT_LT((frame.to_local({0, 90, 0}) - Vector3(kEquator, 0, -kEquator)).norm(), 1e-6);
  EXPECT_LT((frame.to_local({90, 0, 0}) - Vector3(0, kPole, -kEquator)).norm(), 1e-6);
  EXPECT_LT((frame.to_local({0, 180, 0}) - Vector3(0, 0, -2 * kEquator)).norm(), 1e-6);
}

TEST(GeodeticFrame, LevelGroundBendsAwayFromThePlane) {
  const GeodeticFrame frame({0, 20, 0});

  const double angle = 10'000 / kEquator;  // 10 km along the equator
  const Vector3 far = frame.to_local({0, 20 + angle / kDegree, 0});

  EXPECT_NEAR(far.x(), kEquator * std::sin(angle), 1e-6);
  EXPECT_NEAR(far.z(), -kEquator * (1 - std::cos(angle)), 1e-6);
  EXPECT_NEAR(far.z(), -7.839, 0.001);
}

TEST(GeodeticFrame, LongitudesGoOnAcrossTheDateLine) {
  const GeodeticFrame frame({10, 179.999, 0});

  const GeodeticPoint beyond = frame.to_geodetic({1000, 0, 0});

  EXPECT_NEAR(beyond.longitude_degrees, -179.9919, 1e-3);
  EXPECT_NEAR(frame.to_local(beyond).x(), 1000, 1e-6);
}

RC_GTEST_PROP(GeodeticFrame, ThereAndBackIsTheSamePlace, ()) {
  const GeodeticFrame frame(any_point());
  const Vector3 place(*rc::gen::inRange(-100'000, 100'000), *rc::gen::inRange(-100'000, 100'000),
                      *rc::gen::inRange(-500, 9000));

  RC_ASSERT((frame.to_local(frame.to_geodetic(place)) - place).norm() < 1e-6);
}

RC_GTEST_PROP(GeodeticFrame, KeepsDistancesOfTheTextbook, ()) {
  const GeodeticPoint origin = any_point(), a = any_point(), b = any_point();
  const GeodeticFrame frame(origin);

  const double local = (frame.to_local(a) - frame.to_local(b)).norm();
  const double expected = (geocentric(a) - geocentric(b)).norm();
  RC_ASSERT(std::abs(local - expected) < 1e-6);
  RC_ASSERT(std::abs(frame.to_local(a).norm() - (geocentric(a) - geocentric(origin)).norm()) <
            1e-6);
}

}  // namespace
}  // namespace skein::geodesy
