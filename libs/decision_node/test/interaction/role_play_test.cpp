// SPDX-License-Identifier: Apache-2.0
#include "interaction/role_play.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "interaction/places.hpp"
#include "interaction/role_tasks.hpp"
#include "skein/world/world_builder.hpp"
#include "testing/level_ground.hpp"
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

TEST_F(Watching, WhatALoopMayBeginAnewIsLeft) {
  for (const std::string task : {"w1", "w2", "w3"}) {
    EXPECT_FALSE(play_.has_only_flights_left()) << task;
    ends(task);
  }
  EXPECT_FALSE(play_.has_only_flights_left());
}

TEST(Relaying, HasOnlyAFlightLeftAfterItsLastMeeting) {
  const Joint joint = testing::joint();
  RolePlay play(joint, "relay", {{"heliv", "watch"}, {"marvin", "relay"}}, "marvin");
  const auto tell = [&](const interaction::Input& input) { ASSERT_TRUE(play.tell(input, {})); };
  tell(interaction::Start{});
  for (const std::string task : {"r1", "r2", "r3"}) {
    EXPECT_FALSE(play.has_only_flights_left()) << task;
    tell(Status{task, Status::Word::kRunning});
    tell(Status{task, Status::Word::kEnded});
  }
  EXPECT_TRUE(play.has_only_flights_left());

  tell(interaction::Abort{});
  EXPECT_FALSE(play.has_only_flights_left()) << "it is being left";
}

// Whoever waits for its partner may make room; whoever looks at the fire from near may not.
TEST_F(Watching, KeepsItsPlaceWhereMoreHoldsThanToKeepApart) {
  ends("w1");
  EXPECT_FALSE(play_.is_bound());
  ends("w2");
  EXPECT_TRUE(play_.is_bound());
}

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

  play_.forget("place", "no free air");

  EXPECT_FALSE(play_.scope().contains("place"));
}

TEST_F(Watching, WhoAsksForWhatHasNoValueIsToldWhyItHasNone) {
  config::Value place;
  place.kind = config::Value::Kind::kScalar;
  place.scalar = "place";
  EXPECT_EQ(play_.value(place).error().why, "'place' has no value");
  play_.forget("place", "no free air");
  EXPECT_EQ(play_.value(place).error().why, "'place' has no value: no free air");

  play_.know("place", Position{1, 2, 3});

  EXPECT_EQ(play_.value(place).value(), Argument(Position{1, 2, 3}));
}

// ---- its tasks ----

world::World flat_world() {
  world::WorldFile file = testing::level_ground();
  file.airspace.ceiling = 120;
  file.airspace.voxel = 10;
  return world::build_world(std::move(file)).value();
}

/// Over level ground, with a visible camera.
struct Flat {
  Flat() {
    knowledge.uav = "marvin";
    knowledge.vehicle.sensors.push_back({});
    knowledge.vehicle.sensors.back().device = "visible";
    knowledge.altitude = 40;
    knowledge.vehicle.ceiling = 300;
    knowledge.vehicle.cruise_speed = 5;
    knowledge.vehicle.max_speed = 8;
    knowledge.vehicle.climb_rate = knowledge.vehicle.descent_rate = 2;
    knowledge.vehicle.acceleration = 1;
    knowledge.vehicle.yaw_rate = 0.8;
    knowledge.vehicle.energy = {6.5e6, 100, 1700, 1500, 400, 0.1};
    knowledge.vehicle.hovers = true;
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

// ---- a place that several come to ----

/// The watching library with several who relay over the same place.
std::shared_ptr<const interaction::Library> relays(std::size_t count) {
  std::string text = testing::kLibrary;
  const std::string one = "arity: {watch: 1, relay: 1}";
  text.replace(text.find(one), one.size(),
               "arity: {watch: 1, relay: " + std::to_string(count) + "}");
  const auto value = config::parse_yaml(text, "watching.yaml");
  return std::make_shared<const interaction::Library>(
      interaction::read_library({{"watching.yaml", value.value()}}).value());
}

/// Where its first task, a goto, ends for a relay.
world::Vector3 comes_to(const Joint& joint, const Holders& holders, const std::string& uav,
                        const Outlook& outlook) {
  const RolePlay play(joint, "relay", holders, uav);
  const auto& componel = play.automaton()[*play.automaton().find("r1")];
  world::VehicleState state;
  state.position = {200, 0, 40};
  const auto task = make_task(componel, joint.subject, {play, outlook, state, Duration(), ""});
  if (!task) ADD_FAILURE() << task.error().why;
  if (!task) return {};
  const std::vector<double>& way = task->parameters.find("waypoints")->numbers;
  return {way[way.size() - 3], way[way.size() - 2], way[way.size() - 1]};
}

TEST(RoleGoto, WhoComeToOnePlaceHaveEachAPlaceOfTheirOwn) {
  Joint joint = testing::joint();
  joint.library = relays(2);
  joint.variant = &joint.library->models.at("watching").variants.front();
  joint.arguments["ground"] = Position{0, 0, 40};
  const Holders holders{{"heliv", "relay"}, {"marvin", "watch"}, {"swift", "relay"}};
  const Flat flat;

  const world::Vector3 one = comes_to(joint, holders, "heliv", flat.outlook());
  const world::Vector3 other = comes_to(joint, holders, "swift", flat.outlook());

  EXPECT_NEAR((one - other).norm(), 30, 1e-6);
  EXPECT_NEAR((one + other).head<2>().norm(), 0, 1e-6);
}

TEST(RoleGoto, APlaceThatOneAloneComesToIsComeTo) {
  Joint joint = testing::joint("heliv");
  joint.arguments["ground"] = Position{0, 0, 40};
  const Flat flat;

  const world::Vector3 at =
      comes_to(joint, {{"heliv", "relay"}, {"marvin", "watch"}}, "heliv", flat.outlook());

  EXPECT_EQ(at, world::Vector3(0, 0, 40));
}

/// A joint task in which so many relay over a place 40 m above the ground.
struct Relays {
  explicit Relays(std::size_t count) {
    joint.library = relays(count);
    joint.variant = &joint.library->models.at("watching").variants.front();
    joint.arguments["ground"] = Position{0, 0, 40};
    holders["marvin"] = "watch";
    for (std::size_t relay = 0; relay < count; ++relay)
      holders["uav" + std::to_string(relay)] = "relay";
  }
  std::vector<world::Vector3> places(const Outlook& outlook) const {
    std::vector<world::Vector3> all;
    for (const auto& [uav, role] : holders)
      if (role == "relay") all.push_back(comes_to(joint, holders, uav, outlook));
    return all;
  }
  Joint joint = testing::joint();
  Holders holders;
};

TEST(RoleGoto, SeveralComeToACircleOnWhichNeighboursAreThirtyMetresApart) {
  const Flat flat;
  for (std::size_t count = 2; count <= 6; ++count) {
    const std::vector<world::Vector3> places = Relays(count).places(flat.outlook());
    ASSERT_EQ(places.size(), count);
    world::Vector3 sum = world::Vector3::Zero();
    for (std::size_t one = 0; one < count; ++one) {
      sum += places[one];
      for (std::size_t other = 0; other < one; ++other)
        EXPECT_GE((places[one] - places[other]).norm(), 30 - 1e-6) << count;
      EXPECT_NEAR((places[one] - places[(one + 1) % count]).norm(), 30, 1e-6) << count;
      EXPECT_NEAR(places[one].z(), 40, 1e-6);
    }
    EXPECT_NEAR(sum.head<2>().norm(), 0, 1e-6) << "around the place itself";
  }
}

TEST(RoleGoto, OnASlopeEachComesAsHighOverTheGroundAsThePlaceIs) {
  Flat flat;
  world::TerrainSpec spec = flat.world.terrain.spec();
  spec.hills = {{{150, 0}, 30, 400}};  // gentle: it can be landed on
  flat.world.terrain = world::Terrain(spec);
  Relays three(3);
  const double ground = flat.world.terrain.elevation(0, 0);
  three.joint.arguments["ground"] = Position{0, 0, ground + 40};

  double lowest = 1e9, highest = -1e9;
  for (const world::Vector3& place : three.places(flat.outlook())) {
    EXPECT_NEAR(place.z() - flat.world.terrain.elevation(place.x(), place.y()), 40, 1e-6);
    lowest = std::min(lowest, place.z());
    highest = std::max(highest, place.z());
  }
  EXPECT_GT(highest - lowest, 0.5) << "else nothing was asked of it";
}

TEST(RoleGoto, WhereNobodyCouldLandBesideItAllComeToThePlaceItself) {
  Flat flat;
  world::TerrainSpec spec = flat.world.terrain.spec();
  spec.hills = {{{40, 0}, 60, 40}, {{-40, 0}, 60, 40}, {{0, 40}, 60, 40}, {{0, -40}, 60, 40}};
  flat.world.terrain = world::Terrain(spec);
  Relays four(4);
  const Position middle{0, 0, flat.world.terrain.elevation(0, 0) + 60};
  four.joint.arguments["ground"] = middle;

  for (const world::Vector3& place : four.places(flat.outlook()))
    EXPECT_EQ(place, world::Vector3(middle[0], middle[1], middle[2]));
}

// ---- as long as the joint task says ----

/// Marvin follows the fire for so many seconds.
Joint following(double seconds) {
  auto library = std::make_shared<interaction::Library>(*testing::watching_library());
  interaction::Automaton& role = library->roles.at("watch").automaton;
  interaction::Componel& task = role[*role.find("w3")];
  auto& parameters = std::get<interaction::Task>(task.what).parameters.entries;
  std::erase_if(parameters, [](const auto& one) { return one.key == "duration"; });
  std::get<interaction::Task>(task.what).type = kFollow;
  role[*role.find("w12")].block()->exit = {{interaction::Literal{interaction::TimeIs{
      {},
      interaction::TimeIs::Event{*role.find("w3"), interaction::AskedState::kRunning},
      true,
      "duration"}}}};
  return joint_of(testing::watching("marvin heliv", seconds), library, "marvin", {"heliv"}).value();
}

TEST(WhoFollows, DoesSoUntilTheSecondsArePastThatAParameterSays) {
  const Joint joint = following(90);
  RolePlay play(joint, "watch", {{"heliv", "relay"}, {"marvin", "watch"}}, "marvin");

  ASSERT_TRUE(play.tell(interaction::Start{}, MissionTime::seconds(10)));
  for (const std::string task : {"w1", "w2"}) {
    for (const auto word : {Status::Word::kRunning, Status::Word::kEnded})
      ASSERT_TRUE(play.tell(Status{task, word}, MissionTime::seconds(15)));
  }
  ASSERT_TRUE(play.tell(Status{"w3", Status::Word::kRunning}, MissionTime::seconds(20)));

  EXPECT_EQ(play.next_wakeup(), MissionTime::seconds(110));
}

TEST(WhoFollows, CountsTheTimeAndEnergyOfIt) {
  const Flat flat;
  const Outlook outlook = flat.outlook([](const std::string&) {
    return interaction::Sighting{{100, 0, 0}, MissionTime()};
  });
  const auto cost_for = [&](double seconds) {
    return cost_of(following(seconds), "watch", {}, outlook).value();
  };

  const RoleCost less = cost_for(100), more = cost_for(400);

  EXPECT_NEAR(more.seconds - less.seconds, 300, 1e-6);
  EXPECT_NEAR(more.energy - less.energy, 300 * 1700 / 6.5e6, 1e-9);
  EXPECT_GT(less.seconds, 100) << "and flies there";
}

// ---- where others stay ----

TEST(PlaceOf, IsWhereOthersLeaveItAirToStayIn) {
  const Flat flat;
  Outlook outlook = flat.outlook();
  outlook.free_to_stay = [](const world::Vector3& at) { return at.head<2>().norm() > 60; };

  const auto place = place_of({call_of("valid-position()"), {}, {0, 0, 40}, "", {}}, outlook);

  ASSERT_TRUE(place) << place.error().why;
  EXPECT_GT(std::hypot((*place)[0], (*place)[1]), 60);
  EXPECT_LT(std::hypot((*place)[0], (*place)[1]), 70) << "not further than it has to";
}

TEST(PlaceOf, IsWhereOthersStayBeforeThereIsNone) {
  const Flat flat;
  Outlook outlook = flat.outlook();
  outlook.free_to_stay = [](const world::Vector3&) { return false; };

  EXPECT_TRUE(place_of({call_of("valid-position()"), {}, {0, 0, 40}, "", {}}, outlook));
}

// Found by storms (agreed-places/pursuit 401): in reach of the vehicle, while the partner in reach
// of whom it was to be as well was silent.
TEST(PlaceOf, KeepsWhatAnScmSaysOfPlacesThatAreKnownBesideOneThatIsNot) {
  const Flat flat;
  Outlook outlook = flat.outlook();
  outlook.observer = [&](const std::string& name) -> std::optional<interaction::Sighting> {
    if (name != "vehicle") return std::nullopt;
    return interaction::Sighting{{100, 0, 0}, outlook.now};
  };
  interaction::Scm between{"between", {{"one"}, {"other"}}, {}};
  for (const auto& [place, far] : {std::pair("one", 60.0), std::pair("other", 30.0)}) {
    interaction::SpatialConstraint near;
    near.of = {place};
    near.than = interaction::Term(far);
    between.constraints.push_back(near);
  }
  interaction::ScmBinding binding;
  binding.places = {{"one", {"vehicle"}}, {"other", {"heliv"}}};

  const auto place = place_of(
      {call_of("valid-position()"), {}, {0, 0, 40}, "", {{"in-view", between, binding}}}, outlook);

  ASSERT_TRUE(place) << place.error().why;
  EXPECT_LT(std::hypot((*place)[0] - 100, (*place)[1], (*place)[2]), 60);
}

// Found when a joint task was agreed on a second sooner (mref/nominal): what the partner said of
// where it is had been lost, and it was sent to where that hovered.
TEST(PlaceOf, KeepsAwayFromWhereAUavWasHeardToBeLast) {
  const Flat flat;
  const auto beside_heliv_heard = [&](double seconds_ago) {
    Outlook outlook = flat.outlook();
    outlook.now = MissionTime::seconds(60);
    outlook.observer = [&](const std::string&) -> std::optional<interaction::Sighting> {
      return interaction::Sighting{{0, 0, 40}, outlook.now - Duration::seconds(seconds_ago)};
    };
    interaction::SpatialConstraint far;
    far.of = {"other"};
    far.relation = interaction::Relation::kGreater;
    far.than = interaction::Term(20.0);
    const interaction::Scm apart{"apart", {{"other"}}, {far}};
    interaction::ScmBinding binding;
    binding.places = {{"other", {"heliv"}}};
    const auto place = place_of(
        {call_of("valid-position()"), {}, {0, 0, 40}, "", {{"mcs1", apart, binding}}}, outlook);
    return std::hypot((*place)[0], (*place)[1], (*place)[2] - 40);
  };

  EXPECT_GT(beside_heliv_heard(1), 20);
  EXPECT_GT(beside_heliv_heard(10), 20);
  EXPECT_LT(beside_heliv_heard(60), 20) << "it may be anywhere";
}

TEST(CallOf, TakesAnInitialiserApart) {
  EXPECT_EQ(call_of("best-view(front, center)").function, "best-view");
  EXPECT_THAT(call_of("best-view(front, center)").arguments, ElementsAre("front", "center"));
  EXPECT_THAT(call_of("valid-position()").arguments, IsEmpty());
}

}  // namespace
}  // namespace skein::decision_node
