// SPDX-License-Identifier: Apache-2.0
// Missions that nobody wrote, with daemons that die in them, played over DDS and judged by the
// laws.
#include <gmock/gmock.h>

#include <fstream>
#include <iterator>

#include "process.hpp"
#include "skein/foundation/exit_code.hpp"
#include "testing/dds_run.hpp"

namespace skein::testing {
namespace {

using ::testing::HasSubstr;

/// A command of `skein` to its end.
Answered skein(const std::vector<std::string>& words, const std::string& log, double seconds) {
  std::vector<std::string> all{kPrograms + "/skein"};
  all.insert(all.end(), words.begin(), words.end());
  auto process = run_tool::Process::start(all, log);
  if (!process) return {-1, "cannot be started"};
  holds_within(seconds, [&] { return process->poll().has_value(); });
  std::ifstream in(log);
  return {process->poll() ? process->poll()->code : -1, {std::istreambuf_iterator<char>(in), {}}};
}

TEST(DdsDrawnMissions, KeepTheLawsAndAreJudgedTheSameFromTheirFolders) {
  const DdsRun place;  // for its folder
  const std::string kept = place.file("kept").string();

  const Answered storm = skein(
      {"storm", "--seeds", "1..3", "--over-dds", "20", "--jobs", "3", "--save", "", "--log", kept},
      place.file("storm.log").string(), 250);
  EXPECT_EQ(storm.code, kExitOk) << storm.text;
  EXPECT_THAT(storm.text, HasSubstr("3 missions"));

  const Answered judge =
      skein({"judge", kept + "/1", kept + "/2", kept + "/3"}, place.file("judge.log").string(), 60);
  EXPECT_EQ(judge.code, kExitOk) << judge.text;
}

}  // namespace
}  // namespace skein::testing
