// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "checks.hpp"
#include "skein/journal/hand_on.hpp"
#include "skein/journal/lines/joint.hpp"
#include "skein/journal/lines/radio.hpp"

namespace skein::laws {
namespace {

namespace lines = journal::lines;

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr const char* kJoint = "watching(P1 60) of heliv, marvin";

/// A log of Marvin and Heliv, of whom one is to watch and one to relay.
class Told {
 public:
  Told() {
    interaction::Variant variant;
    variant.name = "pair";
    variant.parameters = {{"front", interaction::ParameterType::kObj},
                          {"time", interaction::ParameterType::kTime}};
    variant.roles = {"watch", "relay"};
    variant.table.arities = {{"watch", {1, 1}}, {"relay", {1, std::nullopt}}};
    variant.table.scms = {{"far", "separation", {{"from", "front"}, {"least", 20.0}}},
                          {"apart", "separation", {{"from", "R*"}, {"least", 20.0}}}};
    variant.table.places = {{"far", "watch", {"w0"}}};
    variant.table.parameters["watch"] = {{"seconds", "time"}};
    interaction::Library library;
    library.models["watching"] = {"watching", {variant}};
    library.roles["watch"] = {"watch", {}, {}, watching()};
    library.roles["relay"] = {"relay", {}, {}, {}};
    interaction::SpatialConstraint constraint;
    constraint.of = {"from"};
    constraint.relation = interaction::Relation::kGreater;
    constraint.than = interaction::Term("least");
    library.scms["separation"] = {"separation", {{"from", true}, {"least", false}}, {constraint}};
    scenario_.interaction = std::make_shared<const interaction::Library>(library);
    scenario_.world.places["P1"] = {100, 0, 0};
    for (const char* name : {"heliv", "marvin"}) {
      scenario_.uavs.push_back({});
      scenario_.uavs.back().name = name;
      scenario_.uavs.back().model.hovers = true;
    }
  }

  Told& phase(double at, const std::string& uav, const std::string& phase, const std::string& role,
              const std::string& why = "", std::uint64_t task = 7) {
    return see(at, uav,
               lines::Joint{.uav = uav,
                            .joint = kJoint,
                            .task = task,
                            .variant = "pair",
                            .phase = phase,
                            .role = role,
                            .why = why});
  }
  Told& link(double at, bool up) {
    return see(at, "sim", lines::Link{.from = "heliv", .to = "marvin", .up = up});
  }
  Told& componel(double at, const std::string& uav, const std::string& name,
                 const std::string& state) {
    return see(at, uav,
               lines::Role{
                   .uav = uav, .joint = kJoint, .role = "watch", .componel = name, .state = state});
  }
  Told& session(double at, const std::string& uav, const std::string& state,
                const std::string& rows = "") {
    return see(at, uav,
               lines::Negotiation{.uav = uav,
                                  .joint = kJoint,
                                  .opener = "heliv",
                                  .opened = 3,
                                  .state = state,
                                  .rows = rows});
  }
  /// By heliv: agreed upon at both.
  Told& asked_for_roles(double opened, double agreed, const std::string& rows) {
    for (const std::string uav : {"heliv", "marvin"})
      see(agreed, uav,
          lines::Negotiation{.uav = uav,
                             .joint = std::string(kJoint) + "/role-allocation",
                             .opener = "heliv",
                             .opened = opened,
                             .state = "agreed",
                             .rows = rows});
    return *this;
  }
  Told& place(double at, const std::string& uav, const std::string& scm,
              const std::vector<double>& position) {
    return see(
        at, uav,
        lines::Place{
            .uav = uav, .joint = kJoint, .role = "watch", .position = position, .scms = scm});
  }
  Told& is_at(const std::string& uav, const world::Vector3& position) {
    at_[uav] = position;
    return *this;
  }
  /// Where sensors say that a thing is.
  Told& seen(double at, const std::string& name, const world::Vector3& where) {
    seen_.push_back({at, at, name, where, 2});
    return *this;
  }
  Told& told_of(double at, const std::string& name, const world::Vector3& position) {
    joint_.points.push_back({at, name, position});
    return *this;
  }

  /// By a task of the role to watch.
  Told& perceives(const std::string& uav, std::int64_t task, double from, double until) {
    activities_[uav].push_back(
        {task, "perceive", "visible", std::nullopt, from, until, "ended", ""});
    return see(from, uav,
               lines::RoleTask{.uav = uav,
                               .joint = kJoint,
                               .role = "watch",
                               .componel = "w1",
                               .task = static_cast<std::uint64_t>(task)});
  }
  /// Who watches shares P1, an area, with the others; all look down.
  Told& shares(const world::Polygon& field) {
    interaction::Library library = *scenario_.interaction;
    interaction::CoordinationAction sharing{"area-sharing", {}, {}};
    sharing.in.kind = config::Value::Kind::kMap;
    config::Value area;
    area.kind = config::Value::Kind::kScalar;
    area.scalar = "field";
    sharing.in.entries.push_back({"area", area});
    library.roles["watch"].automaton.add({"a1", 0, sharing, "", 0});
    library.models["watching"].variants.front().table.parameters["watch"]["field"] = "front";
    scenario_.interaction = std::make_shared<const interaction::Library>(library);
    scenario_.world.zones.push_back({"P1", field});
    for (scenario::UavSpec& spec : scenario_.uavs) {
      world::SensorModel sensor;
      sensor.device = "visible";
      sensor.boresight_pitch = -1.5708;
      sensor.aperture = 0.9;
      sensor.range = 200;
      spec.model.sensors = {sensor};
    }
    airborne_ = true;
    return *this;
  }
  Told& goal(double at, const std::string& uav, const std::string& state) {
    Goal& one = goals_[uav];
    one.id = 70;
    one.task.name = "watching";
    one.changes.push_back({at, state, ""});
    return *this;
  }

  template <class Law>
  std::vector<std::string> broken(Law law) const {
    world::TerrainSpec ground;
    ground.west = ground.south = -500;
    ground.east = ground.north = 500;
    History history{&scenario_, world::Terrain(ground), {}, {}, {}, {}, {}, {}, 1000, false,
                    joint_};
    history.objects_told = seen_;
    for (const scenario::UavSpec& spec : scenario_.uavs) {
      Uav& uav = history.uavs[spec.name];
      uav.spec = &spec;
      uav.goal_of[7] = 70;
      if (activities_.contains(spec.name)) uav.activities = activities_.at(spec.name);
      if (goals_.contains(spec.name)) uav.goals[70] = goals_.at(spec.name);
      const auto at = at_.find(spec.name);
      if (at == at_.end()) continue;
      for (const double instant : {0.0, 1000.0}) {
        uav.samples.push_back({instant, at->second});
        uav.samples.back().airborne = airborne_;
      }
    }
    std::vector<std::string> sentences;
    for (const Violation& one : law(history)) sentences.push_back(one.sentence);
    return sentences;
  }

 private:
  template <class Line>
  Told& see(double at, const std::string& node, Line line) {
    EXPECT_TRUE(joint_.see(journal::record_of(MissionTime::seconds(at), node, std::move(line))));
    return *this;
  }

  static interaction::Automaton watching() {
    interaction::Automaton automaton;
    automaton.add({"w0", 0, interaction::Block(), "", 0});
    interaction::Task task{"takeshot-while-waiting", {}};
    task.parameters.kind = config::Value::Kind::kMap;
    config::Value seconds;
    seconds.kind = config::Value::Kind::kScalar;
    seconds.scalar = "seconds";
    task.parameters.entries.push_back({"duration", seconds});
    automaton.add({"w1", 0, task, "", 0});
    return automaton;
  }

  scenario::Scenario scenario_;
  std::map<std::string, std::vector<Activity>> activities_;
  std::map<std::string, Goal> goals_;
  std::map<std::string, world::Vector3> at_;
  bool airborne_ = false;
  std::vector<ObjectTold> seen_;
  JointHistory joint_;
};

TEST(JointLaws, ARoleForOneIsHeldByOneAtATime) {
  Told swapped;
  swapped.phase(10, "marvin", "running", "watch").phase(10, "heliv", "running", "relay");
  swapped.phase(100, "marvin", "running", "relay").phase(105, "heliv", "running", "watch");
  EXPECT_THAT(swapped.broken(roles_held_twice), IsEmpty());

  Told twice;
  twice.phase(10, "marvin", "running", "watch").phase(50, "heliv", "running", "watch");
  twice.phase(90, "marvin", "ended", "watch");
  EXPECT_THAT(twice.broken(roles_held_twice), ElementsAre(HasSubstr("both hold role watch")));
}

TEST(JointLaws, ARoleForAnyNumberMayBeHeldByAll) {
  Told told;
  told.phase(10, "marvin", "running", "relay").phase(10, "heliv", "running", "relay");

  EXPECT_THAT(told.broken(roles_held_twice), IsEmpty());
}

TEST(JointLaws, ASessionComesOutAlikeAtAll) {
  Told told;
  told.session(5, "marvin", "agreed", "marvin watch").session(6, "heliv", "undecided", "other");
  told.session(7, "heliv", "settled agreed", "marvin watch");
  EXPECT_THAT(told.broken(agreements_apart), IsEmpty());

  EXPECT_THAT(Told(told).session(9, "heliv", "settled failed").broken(agreements_apart),
              ElementsAre(HasSubstr("agreed at marvin, failed at heliv")));
  EXPECT_THAT(Told(told).session(9, "heliv", "agreed", "heliv watch").broken(agreements_apart),
              ElementsAre(HasSubstr("agreed on 'heliv watch'")));
}

TEST(JointLaws, RolesThatAllHaveJustAgreedToKeepAreNotNegotiatedAgainAtOnce) {
  const std::string kept = "heliv perceive 374.7, marvin relay 10.1";
  Told told;
  told.asked_for_roles(100, 100.1, kept)
      .asked_for_roles(120, 120.1, "heliv perceive 9, marvin relay 8");
  EXPECT_THAT(told.broken(restless_negotiations), IsEmpty()) << "a while later";

  told.asked_for_roles(125, 125.1, kept);
  EXPECT_THAT(told.broken(restless_negotiations), ElementsAre(HasSubstr("again 4.9 s after")));
}

TEST(JointLaws, WhoseRolesChangedMayAskAgain) {
  Told told;
  told.asked_for_roles(100, 100.1, "heliv perceive 7, marvin relay 8")
      .asked_for_roles(103, 103.1, "heliv relay 7, marvin perceive 8");
  EXPECT_THAT(told.broken(restless_negotiations), IsEmpty());
}

TEST(JointLaws, WhatWasActivatedIsOverWhenTheJointTaskHasEnded) {
  Told told;
  told.phase(10, "marvin", "running", "watch").componel(11, "marvin", "w1", "running");
  EXPECT_THAT(told.broken(activations_without_end), IsEmpty());

  told.phase(50, "marvin", "ended", "watch");
  EXPECT_THAT(told.broken(activations_without_end), ElementsAre(HasSubstr("w1")));

  EXPECT_THAT(Told(told).componel(49, "marvin", "w1", "aborted").broken(activations_without_end),
              IsEmpty());
}

TEST(JointLaws, WhoCannotGoOnWithItsRoleLeavesIt) {
  const auto given_up = [] {
    Told told;
    told.phase(10, "marvin", "running", "watch");
    told.componel(20, "marvin", "w1", "running").perceives("marvin", 9, 20, 100);
    return told.componel(100, "marvin", "w1", "aborted");
  };

  EXPECT_THAT(given_up().broken(roles_at_a_standstill), ElementsAre(HasSubstr("w1")));
  EXPECT_THAT(given_up().componel(150, "marvin", "w1", "running").broken(roles_at_a_standstill),
              IsEmpty())
      << "it tries again";
  EXPECT_THAT(given_up().phase(120, "marvin", "leaving", "watch").broken(roles_at_a_standstill),
              IsEmpty());
  EXPECT_THAT(given_up().phase(170, "marvin", "leaving", "watch").broken(roles_at_a_standstill),
              ElementsAre(HasSubstr("w1")))
      << "too late";
}

TEST(JointLaws, WhatARoleInterruptsItselfIsNoStandstill) {
  Told told;
  told.phase(10, "marvin", "running", "watch");
  told.componel(20, "marvin", "w1", "running").perceives("marvin", 9, 20, 100);
  told.componel(99, "marvin", "w1", "aborting").componel(100, "marvin", "w1", "aborted");

  EXPECT_THAT(told.broken(roles_at_a_standstill), IsEmpty());
}

TEST(JointLaws, AJointTaskEndsAlikeAtAll) {
  Told told;
  told.phase(10, "marvin", "running", "watch").componel(11, "marvin", "w1", "ended");
  told.phase(10, "heliv", "running", "relay").componel(11, "heliv", "r1", "ended");
  told.phase(50, "marvin", "ended", "watch");
  EXPECT_THAT(Told(told).phase(52, "heliv", "ended", "relay").broken(joint_tasks_apart), IsEmpty());
  EXPECT_THAT(Told(told).phase(52, "heliv", "aborted", "relay").broken(joint_tasks_apart),
              ElementsAre(HasSubstr("has ended at marvin")));
}

TEST(JointLaws, WhoIsInterruptedAfterTheOthersEndedIsNotApartFromThem) {
  Told told;
  told.phase(10, "marvin", "running", "watch").componel(11, "marvin", "w1", "ended");
  told.phase(10, "heliv", "running", "relay").componel(11, "heliv", "r1", "ended");
  told.phase(50, "marvin", "ended", "watch");

  EXPECT_THAT(Told(told)
                  .phase(57, "heliv", "leaving", "relay", "interrupted")
                  .phase(59, "heliv", "aborted", "relay", "interrupted")
                  .broken(joint_tasks_apart),
              IsEmpty());
  EXPECT_THAT(Told(told)
                  .phase(47, "heliv", "leaving", "relay", "interrupted")
                  .phase(59, "heliv", "aborted", "relay", "interrupted")
                  .broken(joint_tasks_apart),
              ElementsAre(HasSubstr("has ended at marvin")));
}

TEST(JointLaws, WhoGivesUpHearingOfTheEndOverARadioThatIsDownIsNotApartFromThem) {
  const auto gives_up = [](double down, double up,
                           const std::string& why = "no contact with 'marvin'") {
    Told told;
    told.link(0, true).link(down, false);
    if (up > 0) told.link(up, true);
    told.phase(10, "marvin", "running", "watch").componel(11, "marvin", "w1", "ended");
    told.phase(10, "heliv", "running", "relay").componel(11, "heliv", "r1", "ended");
    told.phase(50, "marvin", "ended", "watch");
    return told.phase(95, "heliv", "aborted", "relay", why).broken(joint_tasks_apart);
  };

  EXPECT_THAT(gives_up(35, 0), IsEmpty());
  EXPECT_THAT(gives_up(35, 120), IsEmpty());
  EXPECT_THAT(gives_up(35, 120, "contact lost: hold"), IsEmpty()) << "--partners 800036";
  EXPECT_THAT(gives_up(35, 120, "no way"), SizeIs(1));
  EXPECT_THAT(gives_up(35, 90), ElementsAre(HasSubstr("has ended at marvin")));
  EXPECT_THAT(gives_up(60, 0), ElementsAre(HasSubstr("has ended at marvin")));
}

TEST(JointLaws, AnAttemptThatAllAbortedIsNoneOfTheOneThatAllEnded) {
  Told told;
  for (const char* uav : {"marvin", "heliv"})
    told.phase(10, uav, "running", "watch").componel(11, uav, "w1", "ended");
  for (const char* uav : {"marvin", "heliv"}) told.phase(20, uav, "aborted", "watch", "no contact");
  for (const char* uav : {"marvin", "heliv"})
    told.phase(40, uav, "running", "watch", "", 8).phase(90, uav, "ended", "watch", "", 8);

  EXPECT_THAT(told.broken(joint_tasks_apart), IsEmpty());
}

TEST(JointLaws, AJointTaskHasAnEndAndSaysWhy) {
  Told told;
  told.phase(10, "marvin", "running", "watch").goal(100, "marvin", "failed");
  EXPECT_THAT(told.broken(joint_tasks_without_end), ElementsAre(HasSubstr("is still running")));

  EXPECT_THAT(Told(told).phase(99, "marvin", "aborted", "watch").broken(joint_tasks_without_end),
              ElementsAre(HasSubstr("no reason")));
  EXPECT_THAT(Told(told)
                  .phase(99, "marvin", "aborted", "watch", "no contact")
                  .broken(joint_tasks_without_end),
              IsEmpty());
}

TEST(JointLaws, AJointTaskThatIsAskedForWithAnotherNumberGoesOn) {
  Told told;
  told.phase(10, "marvin", "loading", "", "", 5).phase(20, "marvin", "running", "watch");
  told.phase(90, "marvin", "ended", "watch").goal(92, "marvin", "achieved");

  EXPECT_THAT(told.broken(joint_tasks_without_end), IsEmpty());
}

TEST(JointLaws, AJointTaskThatIsUnderWayAtTheEndOfTheRunNeedsNoEnd) {
  Told told;
  told.phase(10, "marvin", "running", "watch").goal(10, "marvin", "under-way");

  EXPECT_THAT(told.broken(joint_tasks_without_end), IsEmpty());
}

/// Both took part, and Marvin perceived for so long.
Told watched(double seconds, const world::Vector3& from) {
  Told told;
  told.phase(10, "marvin", "running", "watch").phase(12, "heliv", "running", "relay");
  told.perceives("marvin", 9, 20, 20 + seconds).is_at("marvin", from);
  told.phase(90, "marvin", "ended", "watch").phase(91, "heliv", "ended", "relay");
  return told.goal(92, "marvin", "achieved");
}

TEST(JointLaws, WhatIsAchievedTogetherWasPerceivedForAsLongAsAskedFromWhereItMay) {
  EXPECT_THAT(watched(60, {0, 0, 40}).broken(joint_tasks_not_done), IsEmpty());
  EXPECT_THAT(watched(30, {0, 0, 40}).broken(joint_tasks_not_done),
              ElementsAre(HasSubstr("for 30.0 of 60.0 s")));
  EXPECT_THAT(watched(60, {100, 0, 5}).broken(joint_tasks_not_done),
              ElementsAre(HasSubstr("for 0.0 of 60.0 s")));
}

/// 160 m by 80 m, of which each sees what is within 75 m from below it.
Told mapped(const world::Vector3& marvin, const world::Vector3& heliv) {
  Told told;
  told.shares({{-30, -40}, {130, -40}, {130, 40}, {-30, 40}});
  told.phase(10, "marvin", "running", "watch").phase(12, "heliv", "running", "relay");
  told.perceives("marvin", 9, 20, 80).is_at("marvin", marvin);
  told.perceives("heliv", 19, 20, 80).is_at("heliv", heliv);
  told.phase(90, "marvin", "ended", "watch").phase(91, "heliv", "ended", "relay");
  return told.goal(92, "marvin", "achieved");
}

TEST(JointLaws, WhatIsPerceivedByOneAfterTheOtherAddsUp) {
  Told told = watched(30, {0, 0, 40});
  told.perceives("heliv", 19, 55, 85).is_at("heliv", {0, 30, 40});

  EXPECT_THAT(told.broken(joint_tasks_not_done), IsEmpty());
}

TEST(JointLaws, WhatIsAchievedTogetherWasDoneByAllAtOneTime) {
  Told alone;
  alone.phase(10, "marvin", "running", "watch").perceives("marvin", 9, 20, 80);
  alone.is_at("marvin", {0, 0, 40}).phase(90, "marvin", "ended", "watch");
  alone.goal(92, "marvin", "achieved");
  EXPECT_THAT(alone.broken(joint_tasks_not_done),
              ElementsAre(HasSubstr("role relay was held by 0")));

  alone.phase(200, "heliv", "running", "relay").phase(220, "heliv", "ended", "relay");
  EXPECT_THAT(alone.broken(joint_tasks_not_done), ElementsAre(HasSubstr("never took part")));
}

TEST(JointLaws, AnAreaThatIsSharedWasInViewOfAllTogether) {
  EXPECT_THAT(mapped({0, 0, 60}, {100, 0, 60}).broken(joint_tasks_not_done), IsEmpty());
  EXPECT_THAT(mapped({0, 0, 60}, {0, 0, 60}).broken(joint_tasks_not_done),
              ElementsAre(HasSubstr("% of P1 was in view")));
}

TEST(JointLaws, NoGoalIsAchievedOfWhichNoJointTaskEnded) {
  Told told;
  told.phase(10, "marvin", "running", "watch").goal(92, "marvin", "achieved");

  EXPECT_THAT(told.broken(joint_tasks_not_done), ElementsAre(HasSubstr("has ended")));
}

TEST(JointLaws, APlaceKeepsItsConstraintsWhereThingsAreInTruth) {
  Told told;
  told.place(50, "marvin", "far", {60, 0, 30});
  EXPECT_THAT(told.broken(places_against_constraints), IsEmpty());

  EXPECT_THAT(Told(told).place(60, "marvin", "far", {95, 0, 10}).broken(places_against_constraints),
              ElementsAre(HasSubstr("against far: 20.0 m")));
  // The point was told to be elsewhere, and everybody knows.
  EXPECT_THAT(Told(told)
                  .told_of(55, "P1", {0, 100, 0})
                  .place(70, "marvin", "far", {95, 0, 10})
                  .broken(places_against_constraints),
              IsEmpty());
  EXPECT_THAT(Told(told)
                  .told_of(55, "P1", {60, 0, 30})
                  .place(70, "marvin", "far", {60, 0, 30})
                  .broken(places_against_constraints),
              SizeIs(1));
}

TEST(JointLaws, WhereAThingIsSeenLaterSaysNothingOfAPlaceBefore) {
  Told told;
  told.place(50, "marvin", "far", {60, 0, 30}).seen(80, "P1", {60, 0, 30});
  EXPECT_THAT(told.broken(places_against_constraints), IsEmpty());

  EXPECT_THAT(told.place(85, "marvin", "far", {60, 0, 30}).broken(places_against_constraints),
              SizeIs(1));
}

TEST(JointLaws, APlaceKeepsApartFromPartners) {
  Told told;
  told.phase(10, "marvin", "running", "watch").phase(10, "heliv", "running", "relay");
  told.is_at("heliv", {0, 0, 40});

  EXPECT_THAT(
      Told(told).place(50, "marvin", "apart", {2, 0, 40}).broken(places_against_constraints),
      ElementsAre(HasSubstr("m from heliv")));
  EXPECT_THAT(
      Told(told).place(50, "marvin", "apart", {60, 0, 40}).broken(places_against_constraints),
      IsEmpty());
}

}  // namespace
}  // namespace skein::laws
