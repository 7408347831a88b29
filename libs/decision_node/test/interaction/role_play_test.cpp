// SPDX-License-Identifier: Apache-2.0
#include "interaction/role_play.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interaction/places.hpp"
#include "interaction/role_tasks.hpp"
#include "skein/world/world_builder.hpp"
#include "testing/watch_and_relay.hpp"

namespace skein::decision_node {
namespace {

using interaction::Position;
using interaction::ScmReport;
using interaction::Status;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Marvin watches, Heliv relays.
class Watching : public ::testing::Test {
 protected:
  Watching()
      : joint_(testing::joint()),
        play_(joint_, "watch", {{"heliv", "relay"}, {"marvin", "watch"}}, "marvin") {
    tell(interaction::Start{});
  }

  void tell(const interaction::Input& input) { ASSERT_TRUE(play_.tell(input, now_)); }
  void ends(const std::string& task) {
    tell(Status{task, Status::Word::kRunning});
    tell(Status{task, Status::Word::kEnded});
  }
  /// The fire is at (100, 0, 0).
  std::vector<std::string> found_at(const Position& own, const Position& heliv) {
    now_ = now_ + Duration::seconds(1);
    const auto observer = [&](const std::string& name) -> std::optional<interaction::Sighting> {
      if (name == "heliv") return interaction::Sighting{heliv, now_};
      return interaction::Sighting{{100, 0, 0}, now_};
    };
    std::vector<std::string> all;
    for (const interaction::ScmFound& one : play_.watch(own, observer, now_)) {
      all.push_back(interaction::message_of(one.report.scm, one.report.finding));
      tell(one.report);
    }
    return all;
  }

  MissionTime now_;
  Joint joint_;
  RolePlay play_;
};

TEST_F(Watching, OnlyConstraintsOfActiveBlocksAreWatched) {
  EXPECT_THAT(play_.active_blocks(), ElementsAre("w10"));
  EXPECT_THAT(found_at({300, 0, 30}, {0, 0, 30}), IsEmpty());
  EXPECT_THAT(found_at({300, 0, 30}, {290, 0, 30}), ElementsAre("apart violated"));
  EXPECT_THAT(play_.violated(), ElementsAre("apart"));

  ends("w1");
  ends("w2");

  EXPECT_THAT(play_.active_blocks(), ElementsAre("w10", "w12"));
  EXPECT_THAT(found_at({300, 0, 30}, {0, 0, 30}),
              ElementsAre("apart satisfied", "in-view violated"));
}

TEST_F(Watching, ALoopThatBeginsAnewHearsOfWhatStillIs) {
  ends("w1");
  ends("w2");
  EXPECT_THAT(found_at({300, 0, 30}, {0, 0, 30}), ElementsAre("in-view violated"));
  EXPECT_THAT(found_at({300, 0, 30}, {0, 0, 30}), IsEmpty());

  tell(Status{"w3", Status::Word::kAborted});

  EXPECT_THAT(found_at({300, 0, 30}, {0, 0, 30}), ElementsAre("in-view violated"));
}

TEST_F(Watching, APlaceIsLookedForUnderWhatHoldsThereAndWhatIsToCome) {
  const auto names = [](const std::vector<interaction::ActiveScm>& scms) {
    std::vector<std::string> all;
    for (const auto& one : scms) all.push_back(one.id);
    return all;
  };

  EXPECT_EQ(play_.local("place").initialiser, "valid-position()");
  EXPECT_THAT(names(play_.scms_at(play_.local("place").block, false)), ElementsAre("apart"));
  EXPECT_THAT(names(play_.scms_at(play_.local("place").block, true)),
              ElementsAre("apart", "in-view"));
}

TEST_F(Watching, WhatIsKnownOfAPlaceCanBeForgotten) {
  play_.know("place", Position{1, 2, 3});
  EXPECT_TRUE(play_.scope().contains("place"));

  play_.forget("place");

  EXPECT_FALSE(play_.scope().contains("place"));
}

// ---- its tasks ----

world::World flat_world() {
  world::WorldFile file;
  file.origin = world::GeodeticOrigin{};
  world::TerrainSpec terrain;
  terrain.west = terrain.south = -500;
  terrain.east = terrain.north = 500;
  file.terrain = terrain;
  file.radio.range = 1000;
  return world::build_world(std::move(file)).value();
}

/// Over level ground, with a visible camera.
struct Flat {
  Flat() {
    knowledge.uav = "marvin";
    knowledge.vehicle.sensors.push_back({});
    knowledge.vehicle.sensors.back().device = "visible";
    knowledge.altitude = 40;
  }
  Outlook outlook(interaction::Observer observer = {}) const {
    return {knowledge, world, std::move(observer), MissionTime()};
  }
  supervisor::Knowledge knowledge;
  world::World world = flat_world();
};

TEST_F(Watching, MeetingsOfTwoRolesBelongTogetherByTheirRank) {
  const Joint theirs = testing::joint("heliv");
  const RolePlay relay(theirs, "relay", {{"heliv", "relay"}, {"marvin", "watch"}}, "heliv");
  const Flat flat;
  const Outlook outlook = flat.outlook();
  const auto sync_of = [&](const RolePlay& play, const std::string& id, const char* allocation) {
    const auto& componel = play.automaton()[*play.automaton().find(id)];
    const auto task =
        make_task(componel, joint_.subject, {play, outlook, {}, Duration(), allocation});
    return task.value().synchronisation.value();
  };

  EXPECT_EQ(sync_of(play_, "w2", "a").id, sync_of(relay, "r2", "a").id);
  EXPECT_EQ(sync_of(play_, "w4", "a").id, sync_of(relay, "r3", "a").id);
  EXPECT_NE(sync_of(play_, "w2", "a").id, sync_of(play_, "w4", "a").id);
  EXPECT_NE(sync_of(play_, "w2", "a").id, sync_of(play_, "w2", "b").id);
  EXPECT_THAT(sync_of(play_, "w2", "a").senders, ElementsAre("marvin", "heliv"));
}

TEST_F(Watching, APerceptionIsShorterByWhatWasDone) {
  const Flat flat;
  const Outlook outlook = flat.outlook([](const std::string&) {
    return interaction::Sighting{{100, 0, 0}, MissionTime()};
  });
  const auto& componel = play_.automaton()[*play_.automaton().find("w3")];

  const auto task =
      make_task(componel, joint_.subject, {play_, outlook, {}, Duration::seconds(45), ""});

  ASSERT_TRUE(task) << task.error().why;
  EXPECT_EQ(task->type, "perceive");
  EXPECT_EQ(task->parameters.find("device")->text, "visible");
  EXPECT_NEAR(task->parameters.find("duration")->numbers.at(0), 15, 1e-6);
  EXPECT_EQ(task->parameters.find("target")->numbers, (std::vector<double>{100, 0, 0}));
}

TEST_F(Watching, ATaskWhoseValueIsNotKnownIsRefused) {
  const Flat flat;
  const Outlook outlook = flat.outlook();
  const auto& componel = play_.automaton()[*play_.automaton().find("w1")];

  const auto task = make_task(componel, joint_.subject, {play_, outlook, {}, Duration(), ""});

  ASSERT_FALSE(task);
  EXPECT_EQ(task.error().why, "'place' has no value");
}

TEST(CallOf, TakesAnInitialiserApart) {
  EXPECT_EQ(call_of("best-view(front, center)").function, "best-view");
  EXPECT_THAT(call_of("best-view(front, center)").arguments, ElementsAre("front", "center"));
  EXPECT_THAT(call_of("valid-position()").arguments, IsEmpty());
}

}  // namespace
}  // namespace skein::decision_node
