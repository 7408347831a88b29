// SPDX-License-Identifier: Apache-2.0
// `skein storm` from its options to its exit code.
#include "skein/storm_tool/storm.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "skein/foundation/exit_code.hpp"

namespace skein::storm_tool {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

const std::string kScenarios = SKEIN_SOURCE_DIR "/scenarios";

struct Told {
  int code = 0;
  std::string out, err;
};

Told run(const StormOptions& options) {
  std::ostringstream out, err;
  const int code = storm(options, out, err);
  return {code, out.str(), err.str()};
}

StormOptions karma(const std::string& seeds) {
  StormOptions options;
  options.scenarios = {kScenarios + "/karma/detection.yaml"};
  options.seeds = seeds;
  options.save = "";
  return options;
}

TEST(Storm, PlaysAScenarioOnceASeedAndKeepsTheLaws) {
  const Told told = run(karma("1..4"));

  EXPECT_EQ(told.code, kExitOk) << told.out;
  EXPECT_THAT(told.out, HasSubstr("4 missions"));
  EXPECT_THAT(told.out, HasSubstr("0 missions break a law"));
}

TEST(Storm, DrawsMissionsWhenNoneIsGiven) {
  StormOptions options;
  options.seeds = "5..6";
  options.save = "";
  options.models = kScenarios;
  options.json = true;

  const Told told = run(options);

  EXPECT_EQ(told.code, kExitOk) << told.out;
  EXPECT_EQ(nlohmann::json::parse(told.out).at("runs"), 2);
  EXPECT_EQ(told.err, "");
}

// Marvin is dead for good, and a command to it may live for ten minutes: longer than the law
// allows. Whatever else the scenario has is not needed for that.
TEST(Storm, KeepsASmallScenarioOfARunThatBreaksALaw) {
  const fs::path folder = fs::path(::testing::TempDir()) / "skein-storm-kept";
  fs::remove_all(folder);
  fs::create_directories(folder);
  const std::string model = "model: " + kScenarios + "/comets/models/";
  const auto meets = [](const std::string& uav) {
    return "do: [{plan: {uav: " + uav +
           ", tasks: [{id: 1, type: takeoff, mode: VUT, params: {altitude: 30}}, {id: 2, type: "
           "goto, "
           "mode: DEP, params: {to: [30, 0, 30]}}]}}]}\n";
  };
  std::ofstream(folder / "near.yaml")
      << "scenario: near\nepoch: 2005-05-19T09:00:00Z\nduration_limit: 100\n"
      << "world: {origin: {latitude: 40, longitude: -8, altitude: 0}, terrain: {west: -300, south: "
         "-300, east: 300, north: 300, cell: 20}}\n"
      << "uavs:\n  marvin: {" << model << "marvin.yaml, start: [0, 0]}\n  heliv: {" << model
      << "heliv.yaml, start: [60, 0]}\n  other: {" << model << "heliv.yaml, start: [200, 200]}\n"
      << "separation: {merge: false}\n"
      << "ground:\n  script:\n"
      << "    - {step: one, when: {time: 5}, " << meets("marvin")
      << "    - {step: two, when: {time: 6}, " << meets("heliv")
      << "faults: [{at: 50, slow: {uav: other, factor: 2, for: 9}}]\n";
  StormOptions options;
  options.scenarios = {(folder / "near.yaml").string()};
  options.seeds = "1";
  options.save = (folder / "kept").string();
  options.judge.only = {"separation"};

  const Told told = run(options);

  EXPECT_EQ(told.code, kExitNegative);
  EXPECT_THAT(told.out, HasSubstr("near: "));
  std::ifstream file(folder / "kept" / "separation-near.yaml");
  const std::string kept{std::istreambuf_iterator<char>(file), {}};
  EXPECT_THAT(kept, HasSubstr("# "));
  EXPECT_THAT(kept, HasSubstr("heliv"));
  EXPECT_EQ(kept.find("slow"), std::string::npos) << kept;
  EXPECT_EQ(kept.find("other"), std::string::npos) << kept;
}

TEST(Storm, SaysWhatIsWrongWithItsInput) {
  StormOptions options = karma("4..2");
  EXPECT_EQ(run(options).code, kExitBadInput);
  EXPECT_THAT(run(options).err, HasSubstr("expected A..B"));
  options.seeds = "1";
  options.scenarios = {"/no/such.yaml"};
  EXPECT_EQ(run(options).code, kExitBadInput);
  EXPECT_THAT(run(options).err, HasSubstr("/no/such.yaml"));
  options.scenarios = {};
  const std::string without_comets = std::filesystem::temp_directory_path() / "without-comets";
  std::filesystem::create_directories(without_comets + "/models");
  for (const std::string& folder : {std::string("/nowhere"), without_comets}) {
    options.models = folder;
    EXPECT_EQ(run(options).code, kExitBadInput);
    EXPECT_THAT(run(options).err, HasSubstr("--models"));
  }
}

// A law that nobody knows would never be broken.
TEST(Storm, KnowsTheLawsThatItIsAskedToJudgeBy) {
  StormOptions options = karma("1..1");
  options.judge.only = {"enrgy", "reached"};
  EXPECT_EQ(run(options).code, kExitBadInput);
  EXPECT_THAT(run(options).err, HasSubstr("no law 'enrgy'; did you mean 'energy'?"));
  options.judge.only = {"reached", "same-bytes"};
  EXPECT_EQ(run(options).code, kExitOk);
}

TEST(Storm, ListsTheLaws) {
  StormOptions options;
  options.list_laws = true;

  EXPECT_THAT(run(options).out, HasSubstr("energy: "));
  EXPECT_THAT(run(options).out, HasSubstr("protocol: "));
}

}  // namespace
}  // namespace skein::storm_tool
