// SPDX-License-Identifier: Apache-2.0
// `skein stn check --batch`, `skein stn dc --batch`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "skein/foundation/exit_code.hpp"
#include "skein/temporal_tool/stn.hpp"
#include "stn_runs.hpp"

namespace skein::temporal_tool {
namespace {

using testing::fresh_folder;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::Outcome;
using testing::put;
using testing::run;

std::string generated(bool broken, std::uint64_t seed, const std::string& to) {
  StnGenerateOptions options;
  options.shape = {31, 4, 3, 65, broken};
  options.seed = seed;
  options.to = to;
  return run(generate_stn, options).out;
}

StnBatchOptions about(const std::filesystem::path& folder, StnQuestion question) {
  StnBatchOptions options;
  options.folder = folder.string();
  options.question = question;
  options.common.json = true;
  return options;
}

// The law: a batch says of every file what the command says of it alone.
TEST(StnBatch, SaysOfEachFileWhatIsSaidOfItAlone) {
  const std::filesystem::path folder = fresh_folder();
  for (std::uint64_t i = 0; i < 6; ++i) {
    put(folder / ("n" + std::to_string(i)),
        generated(i % 3 == 0, i + 1, i < 3 ? "json" : "graphml"));
  }

  const Outcome outcome = run(check_stn_batch, about(folder, StnQuestion::kControllable));

  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(outcome.code, kExitNegative);
  EXPECT_EQ(json.at("yes"), 4);
  EXPECT_EQ(json.at("no"), 2);
  ASSERT_EQ(json.at("files").size(), 6U);
  for (const auto& file : json.at("files")) {
    StnOptions alone;
    alone.file = (folder / file.at("file").get<std::string>()).string();
    EXPECT_EQ(run(check_stn_controllability, alone, "").code,
              file.at("controllable") == true ? kExitOk : kExitNegative);
  }
}

TEST(StnBatch, AsksForConsistencyToo) {
  const std::filesystem::path folder = fresh_folder();
  put(folder / "a", generated(false, 1, "json"));

  const Outcome outcome = run(check_stn_batch, about(folder, StnQuestion::kConsistent));

  EXPECT_EQ(outcome.code, kExitOk);
  EXPECT_EQ(nlohmann::json::parse(outcome.out).at("files").at(0).at("consistent"), true);
}

TEST(StnBatch, GivesStatisticsOfTheTimes) {
  const std::filesystem::path folder = fresh_folder();
  for (const char* name : {"a", "b", "c", "d"}) put(folder / name, generated(false, 1, "json"));
  StnBatchOptions options = about(folder, StnQuestion::kConsistent);
  // A clock that makes the checks take 1, 2, 3 and 10 s.
  std::vector<double> readings{0, 1, 1, 3, 3, 6, 6, 16};
  std::size_t next = 0;
  options.common.now = [&] { return readings.at(next++); };

  const auto seconds =
      nlohmann::json::parse(run(check_stn_batch, options).out).at("seconds").at("all");

  EXPECT_EQ(seconds.dump(),
            R"({"files":4,"least":1.0,"mean":4.0,"median":2.5,"most":10.0,"total":16.0})");
}

TEST(StnBatch, NamesEveryFileThatCannotBeUsedAndAsksTheOthers) {
  const std::filesystem::path folder = fresh_folder();
  put(folder / "bad", "{");
  put(folder / "good", generated(false, 1, "json"));
  put(folder / "worse", "<svg/>");
  std::filesystem::create_directories(folder / "inner");

  StnBatchOptions options = about(folder, StnQuestion::kConsistent);
  const auto json = nlohmann::json::parse(run(check_stn_batch, options).out);
  options.common.json = false;
  const Outcome text = run(check_stn_batch, options);

  EXPECT_EQ(json.at("unusable"), 2);
  EXPECT_EQ(json.at("yes"), 1);
  EXPECT_THAT(json.at("files").at(0).at("error").get<std::string>(), HasSubstr("not JSON"));
  EXPECT_EQ(text.code, kExitBadInput);
  EXPECT_THAT(text.err, HasSubstr("worse:1:1: the root element is 'svg'"));
  EXPECT_THAT(text.out, HasSubstr("2 cannot be used"));
}

TEST(StnBatch, RefusesAFolderWithoutFiles) {
  const std::filesystem::path folder = fresh_folder();

  const Outcome empty = run(check_stn_batch, about(folder, StnQuestion::kConsistent));
  const Outcome absent = run(check_stn_batch, about(folder / "no", StnQuestion::kConsistent));

  EXPECT_EQ(empty.code, kExitBadInput);
  EXPECT_THAT(empty.err, HasSubstr("has no files"));
  EXPECT_EQ(absent.code, kExitBadInput);
  EXPECT_THAT(absent.out, IsEmpty());
}

}  // namespace
}  // namespace skein::temporal_tool
