// SPDX-License-Identifier: Apache-2.0
// What a vehicle does whose decision node is silent.
#include <gtest/gtest.h>

#include "testing.hpp"

namespace skein::sim {
namespace {

using testing::a_config;
using testing::device;
using testing::Flight;
using testing::way;

TEST(Contact, ADecisionNodeThatIsSilentForAShortTimeFindsItsTasksAtWork) {
  Flight flight(a_config());
  flight.take_off("marvin", 1, 40);
  flight.dispatch("marvin", 2, "goto", way({{900, 0, 40}}));
  flight.run_for(20);

  flight.give(ContactLost{"marvin", true});
  flight.run_for(15);
  flight.give(ContactLost{"marvin", false});

  EXPECT_TRUE(flight.run_to_end_of(2));
  EXPECT_EQ(flight.history(2), "running ended");
}

TEST(Contact, ADecisionNodeThatForgotItsTasksFindsTheVehicleAtRest) {
  Flight flight(a_config());
  flight.take_off("marvin", 1, 40);
  flight.dispatch("marvin", 2, "goto", way({{900, 0, 40}}));
  flight.run_for(20);

  flight.give(ContactLost{"marvin", false, true});
  flight.run_for(30);

  EXPECT_EQ(flight.reason(2), "the decision node has forgotten it");
  EXPECT_EQ(flight.state("marvin").activity, "hold");
}

TEST(Contact, LosingItsDecisionNodeForGoodItHoldsSafe) {
  SimulatorConfig config = a_config();
  config.patience = Duration::seconds(25);
  Flight flight(config);
  flight.take_off("marvin", 1, 40);
  flight.dispatch("marvin", 2, "goto", way({{900, 0, 40}}));
  flight.dispatch("marvin", 3, "takeshot", device("visible"));
  flight.run_for(20);

  flight.give(ContactLost{"marvin", true});
  flight.run_for(24);
  EXPECT_EQ(flight.history(2), "running");
  flight.run_for(30);

  EXPECT_EQ(flight.reason(2), "contact with the decision node lost");
  EXPECT_EQ(flight.reason(3), "contact with the decision node lost");
  EXPECT_EQ(flight.state("marvin").activity, "hold");
  flight.give(ContactLost{"marvin", false});
  flight.dispatch("marvin", 4, "goto", way({{0, 0, 40}}));
  EXPECT_TRUE(flight.run_to_end_of(4));
  EXPECT_EQ(flight.history(4), "running ended");
}

TEST(Contact, LosingItsDecisionNodeOnTheGroundChangesNothing) {
  Flight flight(a_config());

  flight.give(ContactLost{"marvin", true});
  flight.run_for(10);

  EXPECT_EQ(flight.state("marvin").activity, "on the ground");
}

}  // namespace
}  // namespace skein::sim
