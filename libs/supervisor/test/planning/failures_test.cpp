// SPDX-License-Identifier: Apache-2.0
// What planning says when there is no plan, and of domains that are wrong.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/supervisor/domain_warnings.hpp"
#include "testing/planning_lab.hpp"

namespace skein::supervisor {
namespace {

using namespace std::string_literals;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::PlanningLab;
using world::Vector3;

PlanningLab flying() {
  PlanningLab lab;
  lab.flying_at({0, 0, 40}).first_id(1);
  lab.world.places["tree"] = Vector3(100, 0, 0);
  return lab;
}

world::Volume volume(const std::string& name, double west, double south, double east,
                     double north) {
  world::Volume volume;
  volume.name = name;
  volume.polygon = {{west, south}, {east, south}, {east, north}, {west, north}};
  return volume;
}

TEST(PlanningFailures, ABlockedPlaceIsNamedWithWhatBlocksIt) {
  PlanningLab lab = flying();
  lab.world.volumes.push_back(volume("village", -10, 60, 60, 120));
  lab.task(1, "general-wait", {5.0}).task(2, "general-gotoxyz", {"P2"s}).task(3, "general-land");

  const auto plan = lab.plan();

  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.error().culprit, mission::GoalId(2));
  EXPECT_THAT(lab.reasons(), AllOf(HasSubstr("p2"), HasSubstr("'village'")));
}

// Found by random missions (--anything --capacity 9600 984025): a blimp waited for the air of its
// next way over a place near its home, and its circles led into smoke. Home it comes in any case.
TEST(PlanningFailures, APlaceNearHomeNeedsRoomForTheCirclesOfOneThatCannotHover) {
  const auto plan_of = [](const std::string& task, std::vector<mission::Argument> arguments) {
    PlanningLab lab;
    lab.vehicle(testing::vehicle_of("scenarios/comets/models/karma.yaml"));
    lab.flying_at({0, -300, 90});
    lab.knowledge.home = {0, 0, 0};
    lab.knowledge.altitude = 90;
    lab.world.places["there"] = {0, 30, 90};
    lab.world.volumes.push_back(volume("smoke", 18, 50, 140, 170));
    lab.task(1, task, std::move(arguments));
    return lab.plan() ? std::string("a plan") : lab.reasons();
  };

  EXPECT_THAT(plan_of("general-gotoxyz", {"there"s}),
              HasSubstr("'smoke' is too near for the circles that it waits on there"));
  EXPECT_EQ(plan_of("general-land", {}), "a plan");
}

TEST(PlanningFailures, APlaceIsKnownByCapitalsOfOtherAlphabetsToo) {
  PlanningLab lab = flying();
  lab.world.places["\u00d6ster\u00e5ker"] = Vector3(100, 0, 40);
  lab.task(2, "general-gotoxyz", {"\u00d6ster\u00e5ker"s});

  EXPECT_TRUE(lab.plan()) << lab.reasons();
}

TEST(PlanningFailures, WaysGoRoundWhatIsClosed) {
  PlanningLab lab = flying();
  lab.world.volumes.push_back(volume("tower", -20, 30, 40, 60));
  lab.task(2, "general-gotoxyz", {"P2"s});

  const auto plan = lab.plan();

  ASSERT_TRUE(plan) << lab.reasons();
  EXPECT_GT(plan->tasks[0].way.size(), 2U);
  EXPECT_GT(plan->tasks[0].duration.least, Duration::seconds(8.1));
}

TEST(PlanningFailures, AirThatWasClosedAroundTheVehicleIsLeft) {
  PlanningLab lab = flying();
  lab.world.volumes.push_back(volume("sudden", -50, -50, 50, 50));
  lab.task(2, "general-gotoxyz", {"P2"s});

  const auto plan = lab.plan();

  ASSERT_TRUE(plan) << lab.reasons();
  EXPECT_EQ(plan->tasks[0].way.front(), Vector3(0, 0, 40));
  EXPECT_EQ(plan->tasks[0].way.back(), Vector3(10, 80, 40));
}

TEST(PlanningFailures, ADeviceThatIsMissingIsNamedByItsUse) {
  PlanningLab lab = flying();
  lab.knowledge.vehicle.sensors.clear();
  lab.task(7, "perform-mapping", {"Z2"s});

  const auto plan = lab.plan();

  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.error().culprit, mission::GoalId(7));
  EXPECT_THAT(plan.error().reasons,
              ElementsAre("no device on board serves mapping; these would: mapping, singlecam"));
}

TEST(PlanningFailures, ADeviceThatIsBrokenIsNamed) {
  PlanningLab lab = flying();
  lab.situation.broken = {"singlecam"};
  lab.task(7, "perceive", {"tree"s, 5.0});

  const auto plan = lab.plan();

  ASSERT_FALSE(plan);
  EXPECT_THAT(plan.error().reasons,
              ElementsAre("what serves perception on board does not work: singlecam"));
}

TEST(PlanningFailures, APlaceThatCannotBeSeenIsNamedWithTheDevice) {
  PlanningLab lab = flying();
  lab.knowledge.vehicle.sensors.front().range = 3;
  lab.task(7, "perceive", {"tree"s, 5.0});

  EXPECT_THAT(lab.reasons(), HasSubstr("nowhere to see tree with singlecam"));
}

TEST(PlanningFailures, ADeviceThatDoesNotReachTheGroundIsNamed) {
  PlanningLab lab = flying();
  lab.knowledge.vehicle.sensors.front().range = 30;
  lab.task(7, "perform-detection", {"Z2"s, "P2"s, 60.0});

  EXPECT_THAT(lab.reasons(), HasSubstr("singlecam reaches 30 m, and would look from 40 m"));
}

// Found by a random mission (--fires 987014): of 121 s a blimp had looked at a zone, all but
// moments were over when a place became known elsewhere, and the rest could not be planned.
TEST(PlanningFailures, WhatIsLeftOfADetectionIsFlownHoweverShort) {
  for (const char* model : {"comets/models/karma.yaml", "comets/models/heliv.yaml"}) {
    for (const double seconds : {0.1, 0.5, 5.0}) {
      PlanningLab lab;
      lab.vehicle(testing::vehicle_of("scenarios/"s + model)).flying_at({0, 0, 40}).first_id(1);
      lab.task(7, "perform-detection", {"Z2"s, "P2"s, seconds});

      EXPECT_TRUE(lab.plan()) << model << " " << seconds << " s: " << lab.reasons();
    }
  }
}

TEST(PlanningFailures, UnknownPlacesAndZonesAreNamedWithTheNearest) {
  PlanningLab place = flying(), zone = flying();
  place.task(1, "general-gotoxyz", {"tre"s});
  zone.task(1, "perform-mapping", {"Z9"s});

  EXPECT_THAT(place.reasons(), HasSubstr("unknown place 'tre'; did you mean 'tree'?"));
  EXPECT_THAT(zone.reasons(), HasSubstr("unknown zone 'z9'"));
}

TEST(PlanningFailures, EnergyThatDoesNotLastIsToldWithFigures) {
  PlanningLab lab = flying();
  lab.situation.energy = 0.15;
  lab.task(1, "general-wait", {100.0}).task(2, "general-wait", {600.0}).task(3, "general-land");

  const auto plan = lab.plan();

  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.error().culprit, mission::GoalId(2));
  EXPECT_THAT(lab.reasons(), AllOf(HasSubstr("7.0 % of the energy"), HasSubstr("5.0 % are left")));
}

TEST(PlanningFailures, AnUnknownTaskIsNoPlanAndNoCrash) {
  PlanningLab lab = flying();
  lab.task(5, "make-coffee");

  const auto plan = lab.plan();

  ASSERT_FALSE(plan);
  EXPECT_FALSE(plan.error().reasons.empty());
}

TEST(PlanningFailures, NamesCannotSmuggleAnythingIntoTheProblem) {
  PlanningLab lab = flying();
  lab.task(5, "general-gotoxyz", {"x) (task-id 7"s}).task(6, "general-gotoxyz", {"a|b\\"s});

  const auto plan = lab.plan();

  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.error().culprit, mission::GoalId(5));
  EXPECT_THAT(lab.reasons(), HasSubstr("unknown place 'x) (task-id 7'"));
}

TEST(PlanningFailures, TheSameRequestGivesTheSameAnswer) {
  PlanningLab lab = flying();
  lab.vehicle(testing::vehicle_of("scenarios/comets/models/karma.yaml"));
  lab.task(1, "perform-detection", {"Z2"s, "P2"s, 300.0}).task(2, "perform-mapping", {"Z2"s});
  lab.task(3, "general-land");

  const auto first = lab.plan(), second = lab.plan();

  ASSERT_TRUE(first) << lab.reasons();
  EXPECT_EQ(*first, *second);
}

TEST(PlanningFailures, ABudgetThatIsSpentIsTheReason) {
  PlanningLab lab = flying();
  lab.task(1, "perceive", {"P1"s, 30.0});
  PlanningRequest request = lab.request();
  request.budget.expansions = 2;

  const auto plan = plan_tasks(request);

  ASSERT_FALSE(plan.has_value());
  EXPECT_THAT(plan.error().reasons, ::testing::Contains(HasSubstr("planning ended early")));
}

TEST(PlanningFailures, NothingIsRefinedTwice) {
  PlanningLab lab = flying();
  for (std::uint64_t i = 1; i <= 10; ++i)
    lab.task(i, "general-gotoxyz", {i % 2 == 0 ? "P1"s : "P2"s});
  PlanningEffort effort;

  ASSERT_TRUE(plan_tasks(lab.request(), &effort));

  EXPECT_EQ(effort.refinements, 3U);  // to P2, to P1, and to P2 from there
  EXPECT_GT(effort.expansions, 10U);
}

// ---- domains

std::string errors_of(const std::string& domain) {
  const auto vocabulary = vocabulary_of({"d.lisp", domain});
  return vocabulary ? "" : to_text(vocabulary.error());
}

TEST(PlanningDomain, TheOneThatIsShippedIsSound) {
  const auto vocabulary =
      vocabulary_of({"comets.lisp", testing::file_text("scenarios/domains/comets.lisp")});

  ASSERT_TRUE(vocabulary) << to_text(vocabulary.error());
  EXPECT_EQ(vocabulary->tasks.size(), 22U);
  const auto& detection = vocabulary->tasks.at("perform-detection");
  EXPECT_THAT(detection.parameters,
              ElementsAre(mission::ParameterKind::kZone, mission::ParameterKind::kPlace,
                          mission::ParameterKind::kDuration));
  EXPECT_THAT(detection.uses, ElementsAre("detection"));
  EXPECT_EQ(vocabulary->serves.count("fire-sensor"), 2U);
}

TEST(PlanningDomain, EveryErrorIsGivenAtOnceWithItsLine) {
  const std::string errors = errors_of(
      "(defdomain d (\n"
      "  (:- (high-level-task go (plaice) ()) ())\n"
      "  (:- (high-level-task stay duration) ())\n"
      "  (:- (device-serves camera) ())\n"
      "  (:method (go ?p ?tc ?o) () ((!task-go ?p ?tc ?o)))\n"
      "  (:operator (!task-go ?p ?tc ?o) ((assign ?x (compute-gotoxy ?p ?tc ?o ?x))) () () 0)\n"
      "))\n");

  EXPECT_THAT(errors, HasSubstr("d.lisp:2:28: unknown kind of argument 'plaice'; expected one of "
                                "place, zone, places, duration"));
  EXPECT_THAT(errors, HasSubstr("did you mean 'place'?"));
  EXPECT_THAT(errors, HasSubstr("d.lisp:3:7: a declaration of another shape"));
  EXPECT_THAT(errors, HasSubstr("d.lisp:4:7: a declaration of another shape"));
  EXPECT_THAT(errors, HasSubstr("d.lisp:6:"));
  EXPECT_THAT(errors, HasSubstr("unknown function 'compute-gotoxy'; did you mean "
                                "'compute-gotoxyz'?"));
}

TEST(PlanningDomain, AMisspeltDefinitionIsNamedWithTheNearestForm) {
  const std::string errors = errors_of("; a domain\n(defdomian d (\n  (:method (go) () ())\n))\n");

  EXPECT_THAT(errors, HasSubstr("d.lisp: 0 planning domains in it"));
  EXPECT_THAT(errors, HasSubstr("d.lisp:2:1: 'defdomian' defines nothing; expected a definition; "
                                "did you mean 'defdomain'?"));
}

TEST(PlanningDomain, WhatIsSuspiciousIsAWarningAtItsLine) {
  EXPECT_EQ(
      to_text(warnings_of({"comets.lisp", testing::file_text("scenarios/domains/comets.lisp")})),
      "");

  const std::string warnings = to_text(warnings_of({"d.lisp",
                                                    "(defdomain d (\n"
                                                    "  (:method (go ?p ?tc ?o) () (\n"
                                                    "    (percieve ?p ?tc ?o)\n"
                                                    "    (stay ?p)\n"
                                                    "    (stay ?plaec ?tc)))\n"
                                                    "  (:method (stay ?_p ?_tc) () ())\n"
                                                    "))\n"}));
  EXPECT_THAT(warnings, HasSubstr("d.lisp:3:5: task 'percieve' has neither method nor operator"));
  EXPECT_THAT(warnings, HasSubstr("d.lisp:4:5: task 'stay' with 1 argument matches no head"));
  EXPECT_THAT(warnings, HasSubstr("d.lisp:5:11: variable ?plaec used only once"));
}

TEST(PlanningDomain, ADeclaredTaskNeedsAMethodOfItsForm) {
  const std::string errors = errors_of(
      "(defdomain d (\n"
      "  (:- (high-level-task go (place) ()) ())\n"
      "  (:- (high-level-task go (place) ()) ())\n"
      "  (:method (go ?p) () ())\n"
      "))\n");

  EXPECT_THAT(errors, HasSubstr("d.lisp:2:24: no method for the declared task 'go'"));
  EXPECT_THAT(errors, HasSubstr("d.lisp:3:24: task 'go' is declared twice"));
}

TEST(PlanningDomain, AFileWithoutDomainIsAnError) {
  EXPECT_THAT(errors_of("; nothing\n"), HasSubstr("0 planning domains"));
  EXPECT_THAT(errors_of("(defdomain d ()"), HasSubstr("d.lisp:1"));
}

TEST(PlanningDomain, MutilatedTextNeverCrashes) {
  const std::string text = testing::file_text("scenarios/domains/comets.lisp");
  for (std::size_t cut = 0; cut < text.size(); cut += 997) {
    const std::string shorter = text.substr(0, cut);
    const std::string holed = text.substr(0, cut) + text.substr(std::min(text.size(), cut + 40));

    EXPECT_NE(errors_of(shorter), "") << cut;
    errors_of(holed);
  }
}

TEST(PlanningDomain, AWrongDomainIsWhyThereIsNoPlan) {
  PlanningLab lab = flying();
  lab.domain("(defdomain d ((:method (general-land ?tc ?o) () ((assign))))");
  lab.task(1, "general-land");

  EXPECT_THAT(lab.reasons(), HasSubstr("comets.lisp:1"));
}

TEST(PlanningDomain, AnOperatorOfAnotherShapeIsToldByItsStep) {
  PlanningLab lab = flying();
  lab.domain(
      "(defdomain d ((:operator (!fly ?o) () () () 0)\n"
      "  (:method (general-land ?_tc ?o) () ((!fly ?o)))))");
  lab.task(1, "general-land");

  EXPECT_THAT(lab.reasons(), AllOf(HasSubstr("(!fly 1)"), HasSubstr("expected (!task-NAME")));
}

TEST(PlanningDomain, AHostThatIsCalledWrongIsAnErrorOfTheDomain) {
  PlanningLab lab = flying();
  lab.domain(
      "(defdomain d ((:method (general-land ?_tc ?_o)\n"
      "   ((assign ?x (compute-stay -5)) (call consp ?x)) ())))");
  lab.task(1, "general-land");

  EXPECT_THAT(lab.reasons(),
              AllOf(HasSubstr("compute-stay"), HasSubstr("positive number of seconds")));
}

}  // namespace
}  // namespace skein::supervisor
