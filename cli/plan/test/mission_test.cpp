// SPDX-License-Identifier: Apache-2.0
// `skein plan --world --vehicle`: the domain of COMETS outside any daemon.
#include <gmock/gmock.h>

#include "testing/command.hpp"

namespace skein::plan_tool {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing_command::Done;
using testing_command::File;

std::string domains(const std::string& name) {
  return std::string(SKEIN_SOURCE_DIR) + "/scenarios/domains/" + name;
}

PlanOptions options_for(const std::string& problem) {
  PlanOptions options;
  options.files = {domains("comets.lisp"), domains(problem)};
  options.mission.world = domains("seeds.yaml");
  options.mission.vehicle = domains("seeds-uav.yaml");
  return options;
}

TEST(PlanMission, ProblemsOfTheSeedsArePlannedWithTheRefiners) {
  for (const char* problem : {"karma.lisp", "heliv.lisp", "marvin.lisp"}) {
    const Done done = testing_command::plan(options_for(problem));

    EXPECT_EQ(done.code, 0) << done.err;
    EXPECT_EQ(done.err, "");
    EXPECT_THAT(done.out, HasSubstr("(!task-land"));
  }
}

TEST(PlanMission, PlansAreShownInTheFormOfTheSeeds) {
  PlanOptions options = options_for("marvin.lisp");
  options.mission.taskreq = true;

  const Done done = testing_command::plan(options);

  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_THAT(done.out, HasSubstr("(TASKREQ TASK-TAKESHOT 44 (DEPENDENCES ((RUNNING 43) (ENDED "
                                  "42)))"));
  EXPECT_THAT(done.out, Not(HasSubstr("!task")));
}

TEST(PlanMission, WithoutTheWorldTheFunctionsOfTheHostAreUnknown) {
  PlanOptions options = options_for("karma.lisp");
  options.mission = {};

  const Done done = testing_command::plan(options);

  EXPECT_EQ(done.code, 2);
  EXPECT_THAT(done.err, HasSubstr("unknown function 'compute-gotoxyz'"));
}

TEST(PlanMission, RefusalsAreShownWhenThereIsNoPlan) {
  const File problem("refused.lisp",
                     "(defproblem refused comets-domain2 ((uavloc flying (loc 0.0 0.0 40.0))\n"
                     " (my-write-time uavloc ((num 0) (num 0)) end none) (task-id 1))\n"
                     " ((:task general-gotoxyz nowhere nil 1)))\n");
  PlanOptions options = options_for("karma.lisp");
  options.files[1] = problem.path();

  const Done done = testing_command::plan(options);

  EXPECT_EQ(done.code, 1) << done.err;
  EXPECT_THAT(done.out, HasSubstr("refused: unknown place 'nowhere'"));
}

TEST(PlanMission, EverythingWrongWithItsFilesIsToldAtOnce) {
  const File raster("raster.yaml", "terrain: {raster: ground.asc}\n");
  const File vehicle("vehicle.yaml", "model: [\n");
  PlanOptions options = options_for("karma.lisp");
  options.mission.world = raster.path();
  options.mission.vehicle = vehicle.path();

  const Done done = testing_command::plan(options);

  EXPECT_EQ(done.code, 2);
  EXPECT_THAT(done.err, HasSubstr("a raster, which is not read here"));
  EXPECT_THAT(done.err, HasSubstr("vehicle.yaml"));
  EXPECT_THAT(done.err, Not(HasSubstr("unknown function")));
}

TEST(PlanMission, AWorldNeedsAVehicle) {
  PlanOptions options = options_for("karma.lisp");
  options.mission.vehicle.clear();

  const Done done = testing_command::plan(options);

  EXPECT_EQ(done.code, 2);
  EXPECT_THAT(done.err, HasSubstr("a world without a vehicle"));
}

TEST(PlanMission, FilesThatAreNotThereAreNamed) {
  PlanOptions options = options_for("karma.lisp");
  options.mission.world = "/nowhere/world.yaml";

  const Done done = testing_command::plan(options);

  EXPECT_EQ(done.code, 2);
  EXPECT_THAT(done.err, HasSubstr("/nowhere/world.yaml"));
}

}  // namespace
}  // namespace skein::plan_tool
