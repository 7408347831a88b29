// SPDX-License-Identifier: Apache-2.0
#include "skein/scenario_text/scenario_text.hpp"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "skein/scenario/scenario.hpp"

namespace skein::scenario_text {
namespace {

const std::string kFolder = SKEIN_SOURCE_DIR "/scenarios/comets";

std::string comets() {
  std::ifstream in(kFolder + "/confirmed.yaml");
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(WithRadio, TakesThePlaceOfWhatItNamesAndAddsItsCuts) {
  const auto text = with_radio(
      "radio: {range: 100, loss: 0.1, cuts: [{between: [a, b], from: 1, until: 2}]}\nx: 007\n",
      "radio: {loss: 0.3, cuts: [{between: [a, c], from: 3, until: 4}]}");

  ASSERT_TRUE(text.has_value()) << text.error().why;
  const YAML::Node document = YAML::Load(*text);
  EXPECT_EQ(document["radio"]["range"].as<int>(), 100);
  EXPECT_EQ(document["radio"]["loss"].as<double>(), 0.3);
  ASSERT_EQ(document["radio"]["cuts"].size(), 2U);
  EXPECT_EQ(document["radio"]["cuts"][1]["from"].as<int>(), 3);
  EXPECT_EQ(document["x"].as<std::string>(), "007") << "written as it was";
}

TEST(WithRadio, GivesAScenarioWithoutARadioOne) {
  const auto text = with_radio("scenario: x\n", "radio: {loss: 0.3}");
  ASSERT_TRUE(text.has_value());
  EXPECT_EQ(YAML::Load(*text)["radio"]["loss"].as<double>(), 0.3);
}

TEST(WithRadio, RefusesWhatIsNoFaultScript) {
  for (const char* wrong :
       {"", "[1]", "radio: 3", "faults: []", "radio: {}\nuavs: {}", "radio: {cuts: 3}", "radio: {"})
    EXPECT_FALSE(with_radio("scenario: x\n", wrong).has_value()) << wrong;
  EXPECT_FALSE(with_radio("[1]", "radio: {loss: 0.3}").has_value());
}

TEST(Moved, MeansTheSameInAnotherFolder) {
  const std::string there = ::testing::TempDir();
  const std::string text = moved(comets(), kFolder, there);
  const auto before = scenario::read_scenario_text(comets(), kFolder + "/confirmed.yaml");
  const auto after = scenario::read_scenario_text(text, there + "/confirmed.yaml");
  ASSERT_TRUE(after.has_value()) << to_text(after.error());
  ASSERT_EQ(after->uavs.size(), before->uavs.size());
  EXPECT_EQ(after->uavs[0].name, before->uavs[0].name);
}

/// A folder in which there is a file, and another to move to.
struct TwoFolders {
  std::filesystem::path from = std::filesystem::path(::testing::TempDir()) / "moved-from",
                        to = std::filesystem::path(::testing::TempDir()) / "moved-to";
  explicit TwoFolders(const std::string& file) {
    std::filesystem::create_directories(from);
    std::filesystem::create_directories(to);
    std::ofstream(from / file) << "x";
  }
  ~TwoFolders() {
    std::filesystem::remove_all(from);
    std::filesystem::remove_all(to);
  }
  std::string moved(const std::string& yaml) const {
    return scenario_text::moved(yaml, from.string(), to.string());
  }
};

TEST(Moved, LeavesAllElseAsItIsWritten) {
  const TwoFolders folders("bee.yaml");
  EXPECT_EQ(folders.moved("# A bee.\nb:   {model: bee.yaml, x: 007}  # model: bee.yaml\n"
                          "c: ['bee.yaml',\n    \"bee.yaml\", no.yaml, ä, bee.yaml]\n"),
            "# A bee.\nb:   {model: ../moved-from/bee.yaml, x: 007}  # model: bee.yaml\n"
            "c: [../moved-from/bee.yaml,\n    ../moved-from/bee.yaml, no.yaml, ä, "
            "../moved-from/bee.yaml]\n");
}

TEST(Moved, ChangesWhatAnAnchorNamesWhereverItIsMeant) {
  const TwoFolders folders("bee.yaml");
  const YAML::Node moved = YAML::Load(folders.moved("a: &it bee.yaml\nb: *it\nc: *it\n"));
  for (const char* key : {"a", "b", "c"})
    EXPECT_EQ(moved[key].as<std::string>(), "../moved-from/bee.yaml") << key;
}

TEST(Moved, QuotesWhatNeedsIt) {
  const TwoFolders folders("a: #b.yaml");
  EXPECT_EQ(YAML::Load(folders.moved("x: 'a: #b.yaml'\n"))["x"].as<std::string>(),
            "../moved-from/a: #b.yaml");
}

TEST(Moved, LeadsToAFileWrittenWithEscapesToo) {
  const TwoFolders folders("bee.yaml");
  EXPECT_EQ(YAML::Load(folders.moved("# lost\nx: \"b\\x65e.yaml\"\n"))["x"].as<std::string>(),
            "../moved-from/bee.yaml");
}

}  // namespace
}  // namespace skein::scenario_text
