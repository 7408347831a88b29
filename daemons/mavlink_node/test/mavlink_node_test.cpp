// SPDX-License-Identifier: Apache-2.0
#include "skein/mavlink_node/mavlink_node.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/translation/tasks.hpp"

namespace skein::mavlink_node {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Nothing comes over it; what is sent is counted.
class NoLink final : public Link {
 public:
  explicit NoLink(int& sent) : Link(-1), sent_(sent) {}
  std::vector<std::uint8_t> receive() override { return {}; }
  void send(std::span<const std::uint8_t>) override { ++sent_; }

 private:
  int& sent_;
};

world::TerrainSpec flat() {
  world::TerrainSpec spec;
  spec.west = spec.south = -100;
  spec.east = spec.north = 100;
  return spec;
}

world::VehicleModel a_copter() {
  world::VehicleModel model;
  model.hovers = true;
  model.ceiling = 100;
  model.climb_rate = model.energy.capacity = 1;
  return model;
}

class MavlinkNodeTest : public ::testing::Test {
 protected:
  MavlinkNodeTest()
      : cockpit_(std::make_shared<Cockpit>(autopilot::Bridge({.uav = "heliv",
                                                              .model = a_copter(),
                                                              .terrain = world::Terrain(flat()),
                                                              .origin = {}}),
                                           std::make_unique<NoLink>(sent_), 1)),
        node_("autopilot", "heliv", roster_, cockpit_),
        companion_("autopilot", "heliv", cockpit_) {}

  node::NodeNumber number_of(const std::string& name) const { return roster_.find(name)->number; }
  node::Effects give(const std::string& from, wire::Sample sample) {
    return node_.handle(node::Received{number_of(from), std::move(sample)},
                        MissionTime::seconds(5));
  }
  wire::FunctionalRequest a_takeoff() const {
    return translation::to_wire(
        "heliv", functional::Request{functional::Verb::kDispatch, functional::TaskId(3), "takeoff",
                                     functional::Parameters().add("altitude", 10)});
  }

  int sent_ = 0;
  node::Roster roster_{{"marvin", "heliv"}, {{"heliv", "autopilot"}}};
  std::shared_ptr<Cockpit> cockpit_;
  MavlinkNode node_;
  LinkCompanion companion_;
};

TEST_F(MavlinkNodeTest, WhatItsUavAsksForIsAnsweredThroughTheCompanion) {
  EXPECT_THAT(give("heliv", a_takeoff()), IsEmpty());

  const auto said = companion_.take();
  ASSERT_THAT(said, SizeIs(1));
  const auto effects = give("autopilot", said[0]);

  ASSERT_THAT(effects, SizeIs(2));
  const auto& line = std::get<node::Log>(effects[0]).record;
  EXPECT_EQ(line.kind(), "functional");
  EXPECT_EQ(line.text("type"), "takeoff");
  EXPECT_EQ(line.text("reason"), "no autopilot is heard");
  const auto& answer = std::get<node::Send>(effects[1]);
  EXPECT_EQ(answer.to, number_of("heliv"));
  EXPECT_EQ(std::get<wire::FunctionalStatus>(answer.sample).id, 3U);
}

TEST_F(MavlinkNodeTest, WhatOthersAskForIsNot) {
  EXPECT_THAT(give("marvin", a_takeoff()), IsEmpty());
  EXPECT_THAT(companion_.take(), IsEmpty());
}

TEST_F(MavlinkNodeTest, TelemetryGoesToItsUavToTheWorldAndToTheEventLog) {
  wire::Telemetry telemetry;
  telemetry.uav = "heliv";
  telemetry.position = {1, 2, 30};
  telemetry.airborne = true;

  const auto effects = give("autopilot", telemetry);

  ASSERT_THAT(effects, SizeIs(3));
  EXPECT_EQ(std::get<wire::Truth>(std::get<node::Publish>(effects[0]).sample).position.z, 30);
  EXPECT_EQ(std::get<node::Log>(effects[1]).record.kind(), "telemetry");
  EXPECT_EQ(std::get<node::Send>(effects[2]).to, number_of("heliv"));
}

TEST_F(MavlinkNodeTest, NoticesOfTheBridgeAreLinesOfTheEventLog) {
  wire::JournalEntry entry;
  entry.record = journal::to_json(journal::Record({}, "autopilot", "notice").with("text", "taken"));

  const auto effects = give("autopilot", entry);

  ASSERT_THAT(effects, SizeIs(1));
  EXPECT_EQ(std::get<node::Log>(effects[0]).record.text("text"), "taken");
}

TEST_F(MavlinkNodeTest, ItsThreadEndsWhenTheDaemonDoes) {
  companion_.attach([] {});
  companion_.detach();
  companion_.detach();
  cockpit_->turn();
  EXPECT_GT(sent_, 0) << "heartbeats go out";
}

}  // namespace
}  // namespace skein::mavlink_node
