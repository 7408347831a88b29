// SPDX-License-Identifier: Apache-2.0
#include "skein/translation/sensing.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "testing/generators.hpp"

namespace skein::translation {
namespace {

RC_GTEST_PROP(Sensing, AVectorComesBackAsItWas, ()) {
  const world::Vector3 v = testing::any_vector();

  RC_ASSERT(from_wire(to_wire(v)) == v);
}

RC_GTEST_PROP(Sensing, TelemetryComesBackWithTheInstantOfItsHeader, ()) {
  const world::Telemetry telemetry = testing::any_telemetry();

  wire::Telemetry sample = to_wire(telemetry);
  sample.header.mission_time = telemetry.at.count();  // the blackboard's stamp

  RC_ASSERT(from_wire(sample) == telemetry);
}

RC_GTEST_PROP(Sensing, APerceptionComesBackWithTheInstantOfItsHeader, ()) {
  const world::Perception perception = testing::any_perception();

  wire::PerceptionReport report = to_wire(perception);
  report.header.mission_time = perception.at.count();  // the blackboard's stamp

  RC_ASSERT(from_wire(report) == perception);
}

RC_GTEST_PROP(Sensing, ASightingSaysWhatALookOfTheStreamWould, ()) {
  const world::Perception perception = testing::any_perception();

  wire::Sighting sighting = sighting_of(perception);
  sighting.header.mission_time = perception.at.count();  // the blackboard's stamp

  RC_ASSERT(from_wire(sighting) == perception);
}

TEST(Sensing, ASampleIsRoundedToSinglePrecision) {
  const world::Vector3 place{1234.56789012345, -0.1, 1e-9};

  const world::Vector3 told = from_wire(to_float_wire(place));

  EXPECT_NEAR(told.x(), place.x(), 1e-4);
  EXPECT_NEAR(told.y(), place.y(), 1e-8);
}

TEST(Sensing, ThePositionsOfTheEventLogAreRoundedToTheMillimetre) {
  const std::vector<double> position = for_journal({1.00049, -2.00051, 3});

  EXPECT_EQ(position, (std::vector<double>{1, -2.001, 3}));
}

TEST(Sensing, APerceptionWithoutDetectionsKeepsWhereItLooked) {
  world::Perception look;
  look.uav = "heliv";
  look.device = "visible";
  look.viewpoint = {1, 2, 3};
  look.direction = {0, 0, -1};
  look.range = 250;
  look.aperture = 0.35F;

  const wire::PerceptionReport report = to_wire(look);

  EXPECT_EQ(report.viewpoint, (wire::FloatVector3{1, 2, 3}));
  EXPECT_EQ(report.view_direction, (wire::FloatVector3{0, 0, -1}));
  EXPECT_TRUE(report.detections.empty());
  EXPECT_EQ(from_wire(report), look);
}

}  // namespace
}  // namespace skein::translation
