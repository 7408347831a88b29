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

RC_GTEST_PROP(Sensing, AVehicleStateComesBackAsItWas, ()) {
  const world::VehicleState state = testing::any_vehicle_state();

  const wire::Telemetry telemetry = to_wire("marvin", state);

  RC_ASSERT(telemetry.uav == "marvin");
  RC_ASSERT(from_wire(telemetry) == state);
}

RC_GTEST_PROP(Sensing, APerceptionComesBackWithTheInstantOfItsHeader, ()) {
  const world::Perception perception = testing::any_perception();

  wire::PerceptionReport report = to_wire(perception);
  report.header.mission_time = perception.at.count();  // the blackboard's stamp

  RC_ASSERT(from_wire(report) == perception);
}

RC_GTEST_PROP(Sensing, ParametersComeBackInOrderRepeatedNamesIncluded, ()) {
  const world::Parameters parameters = testing::any_world_parameters();

  RC_ASSERT(from_wire(to_wire(parameters)) == parameters);
}

// The executive and the functional layer each have parameters of their own: the wire is between.
RC_GTEST_PROP(Sensing, ParametersOfTheExecutiveReachTheFunctionalLayerUnchanged, ()) {
  const executive::Parameters given = testing::any_parameters();

  const world::Parameters taken = from_wire(to_wire(given));

  RC_ASSERT(taken.all().size() == given.all().size());
  for (std::size_t i = 0; i < given.all().size(); ++i) {
    RC_ASSERT(taken.all()[i].name == given.all()[i].name);
    RC_ASSERT(taken.all()[i].text == given.all()[i].text);
    RC_ASSERT(taken.all()[i].numbers == given.all()[i].numbers);
  }
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
  look.aperture = 0.35;

  const wire::PerceptionReport report = to_wire(look);

  EXPECT_EQ(report.viewpoint, (wire::Vector3{1, 2, 3}));
  EXPECT_EQ(report.view_direction, (wire::Vector3{0, 0, -1}));
  EXPECT_TRUE(report.detections.empty());
  EXPECT_EQ(from_wire(report), look);
}

}  // namespace
}  // namespace skein::translation
