// SPDX-License-Identifier: Apache-2.0
// What partners refused is not kept for ever.
#include <gtest/gtest.h>

#include "interaction/interaction.hpp"
#include "testing/joint_host.hpp"

namespace skein::decision_node {
namespace {

using interaction::JointPhase;

class Refusals : public ::testing::Test {
 protected:
  Refusals() {
    at(0);
    host.partners().start(host.bus().now());
    interaction.start();
    host.partners().contact({"heliv", false, true}, host.bus().now());
  }
  void at(double seconds) { host.bus().begin(MissionTime::seconds(seconds)); }
  void load(std::uint64_t id) {
    supervisor::LoadJointTask asked{testing::watching(), {{Duration(), Duration::max()}}};
    asked.task.id = executive::TaskId(id);
    interaction.load(asked);
  }
  void heliv_refuses(const std::string& joint) {
    JointTaskTold told;
    told.status.uav = "heliv";
    told.status.subject = joint;
    told.status.phase = JointPhase::kNotLoaded;
    told.at = host.bus().now();
    interaction.hear(told);
  }
  bool is_known(const std::string& joint) {
    return interaction.refusals().of(joint, "heliv") != nullptr;
  }

  testing::LoneJointHost host;
  Interaction interaction{host};
  const std::string subject = testing::joint().subject;
};

TEST_F(Refusals, OfAJointTaskAreKnownUntilAnHourAfterItIsOver) {
  load(7);
  heliv_refuses(subject);
  for (double now = 1; now < 700; ++now) {
    at(now);
    interaction.time_passes();
  }
  ASSERT_EQ(host.not_loaded.size(), 1U);
  load(8);
  EXPECT_TRUE(is_known(subject));
  for (double now = 700; now < 1400; ++now) {
    at(now);
    interaction.time_passes();
  }
  at(5400);
  load(9);
  EXPECT_FALSE(is_known(subject));
}

TEST_F(Refusals, OfWhatIsAskedForAreKnownHoweverLongItIsLoaded) {
  at(10);
  heliv_refuses(subject);
  at(20);
  load(7);
  at(5000);
  load(7);
  EXPECT_TRUE(is_known(subject));
}

TEST_F(Refusals, OfWhatWasNeverAskedForHereAreKnownForAnHour) {
  heliv_refuses("another");
  at(3000);
  load(7);
  EXPECT_TRUE(is_known("another"));
  at(3700);
  load(7);
  EXPECT_FALSE(is_known("another"));
}

}  // namespace
}  // namespace skein::decision_node
