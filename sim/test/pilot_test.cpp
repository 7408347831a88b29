// SPDX-License-Identifier: Apache-2.0
#include "pilot.hpp"

#include "testing.hpp"

namespace skein::sim {
namespace {

using testing::at;
using testing::model_of;

TEST(Pilot, AnAutopilotReactsAtOnce) {
  Pilot pilot(model_of("marvin"), Random(1));
  EXPECT_EQ(pilot.reaction(), Duration());
}

TEST(Pilot, APersonReactsAsTheModelSays) {
  const world::VehicleModel model = model_of("heliv");
  Pilot pilot(model, Random(1));
  const int n = 5000;

  double sum = 0, least = 1e9;
  for (int i = 0; i < n; ++i) {
    const double reaction = pilot.reaction().to_seconds();
    sum += reaction;
    least = std::min(least, reaction);
  }

  EXPECT_NEAR(sum / n, model.pilot->reaction.to_seconds(), 0.03);
  EXPECT_GE(least, model.pilot->reaction.to_seconds() / 5 - 1e-9);
}

TEST(Pilot, ErrorsAreRedrawnAtCorrectionsOnly) {
  Pilot pilot(model_of("heliv"), Random(1));
  pilot.attend(at(0));
  const world::Vector3 first = pilot.position_error();

  pilot.attend(at(2.9));
  EXPECT_EQ(pilot.position_error(), first);
  pilot.attend(at(3.0));
  EXPECT_NE(pilot.position_error(), first);
}

TEST(Pilot, ErrorsAreSpreadAsTheModelSaysAndBounded) {
  for (const std::string name : {"marvin", "heliv"}) {
    const world::VehicleModel model = model_of(name);
    const double spread = world::tracking_spread(model);
    Pilot pilot(model, Random(3));
    const int n = 20000;

    double squares = 0, most = 0;
    for (int i = 0; i < n; ++i) {
      pilot.attend(at(10.0 * i));
      squares += pilot.position_error().x() * pilot.position_error().x();
      most = std::max(most, std::abs(pilot.position_error().x()));
    }

    EXPECT_NEAR(std::sqrt(squares / n), spread, 0.1 * spread);
    EXPECT_LE(most, 2 * spread + 1e-12);
  }
}

TEST(Pilot, OnlyAPersonMissesTheHeading) {
  Pilot autopilot(model_of("marvin"), Random(1)), person(model_of("heliv"), Random(1));

  autopilot.attend(at(0));
  person.attend(at(0));

  EXPECT_EQ(autopilot.heading_error(), 0);
  EXPECT_NE(person.heading_error(), 0);
}

}  // namespace
}  // namespace skein::sim
