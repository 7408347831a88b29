// SPDX-License-Identifier: Apache-2.0
#include "random_missions/command.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace skein::mission_lab {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Outcome {
  int code = 0;
  std::string out, err;
};

Outcome run(std::vector<std::string> words) {
  words.insert(words.begin(), "skein_random_missions");
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  Outcome result;
  result.code = command(static_cast<int>(arguments.size()), arguments.data());
  result.out = ::testing::internal::GetCapturedStdout();
  result.err = ::testing::internal::GetCapturedStderr();
  return result;
}

TEST(RandomMissionsCommand, AFileThatIsNotThereIsNoMissionThatBreaksNoLaw) {
  const Outcome missing = run({"no-such-folder/mission.yaml"});

  EXPECT_EQ(missing.code, 2);
  EXPECT_THAT(missing.err, HasSubstr("no-such-folder/mission.yaml: cannot be read"));
  EXPECT_THAT(missing.err, HasSubstr("1 of 1 scenarios were not played"));
  EXPECT_THAT(missing.out, IsEmpty());
}

TEST(RandomMissionsCommand, AScenarioThatMakesNoSenseIsNoMissionThatBreaksNoLaw) {
  const std::string file =
      (std::filesystem::path(::testing::TempDir()) / "senseless-mission.yaml").string();
  std::ofstream(file) << "scenario: senseless\n";

  const Outcome senseless = run({file});
  std::filesystem::remove(file);

  EXPECT_EQ(senseless.code, 2);
  EXPECT_THAT(senseless.err, HasSubstr("duration_limit: missing"));
  EXPECT_THAT(senseless.out, IsEmpty());
}

}  // namespace
}  // namespace skein::mission_lab
