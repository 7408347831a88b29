// SPDX-License-Identifier: Apache-2.0
// `skein stn dc --changes`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "skein/foundation/exit_code.hpp"
#include "skein/foundation/random.hpp"
#include "skein/temporal_tool/stn.hpp"
#include "stn_runs.hpp"

namespace skein::temporal_tool {
namespace {

using testing::fresh_folder;
using ::testing::HasSubstr;
using testing::Outcome;
using testing::put;
using testing::run;

constexpr const char* kPlan = R"({"nodes":["v0","a","b"],
  "arcs":[{"from":"v0","to":"a","min":0,"max":10},{"from":"v0","to":"b","min":0,"max":13}],
  "contingent":[{"from":"a","to":"b","min":2,"max":3}]})";

std::string change(const std::string& from, const std::string& to, const std::string& min,
                   const std::string& max) {
  return R"({"from":")" + from + R"(","to":")" + to + R"(","min":)" + min + R"(,"max":)" + max +
         "}";
}

Outcome follow(const std::string& network, const std::string& changes, bool json) {
  const std::filesystem::path file = fresh_folder() / "changes.json";
  put(file, "[" + changes + "]");
  StnChangesOptions options;
  options.changes = file.string();
  options.compare = true;
  options.common.json = json;
  return run(follow_stn_changes, options, network);
}

std::vector<bool> verdicts(const Outcome& outcome) {
  std::vector<bool> all;
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) {
    all.push_back(nlohmann::json::parse(line).at("controllable"));
  }
  return all;
}

TEST(StnChanges, GiveAVerdictBeforeAndAfterEach) {
  const Outcome outcome =
      follow(kPlan,
             change("v0", "b", "0", "2.5") + "," +        // too early for a long task
                 change("a", "b", "2", "2.5") + "," +     // which is not as long
                 change("b", "v0", "-9", "null") + "," +  // the same arc, turned
                 change("b", "a", "null", "-2.2"),        // and one more arc
             true);

  EXPECT_EQ(verdicts(outcome), (std::vector<bool>{true, false, true, true, false}));
  EXPECT_EQ(outcome.code, kExitNegative);
}

TEST(StnChanges, SayWhatBreaksAndHowLongItTook) {
  const Outcome outcome = follow(kPlan, change("v0", "b", "0", "2.5"), false);

  EXPECT_THAT(outcome.out, HasSubstr("as it is: controllable"));
  EXPECT_THAT(outcome.out, HasSubstr("v0 → b [0, 2.5]: not controllable"));
  EXPECT_THAT(outcome.out, HasSubstr("1 change in "));
  EXPECT_THAT(outcome.out, HasSubstr("the same verdicts"));
}

TEST(StnChanges, NameAChangeThatCannotBe) {
  const Outcome negative = follow(kPlan, change("a", "b", "-1", "2"), false);
  const Outcome unknown = follow(kPlan, change("a", "c", "1", "2"), false);

  EXPECT_EQ(negative.code, kExitBadInput);
  EXPECT_THAT(negative.err, HasSubstr("[0]: contingent link a -> b"));
  EXPECT_EQ(unknown.code, kExitBadInput);
  EXPECT_THAT(unknown.err, HasSubstr("unknown node 'c'"));
}

// The law: after each change the verdict is that of a network with these bounds, written as a file
// and checked by itself. `compare` holds the library to it; this holds the whole command.
TEST(StnChanges, OfAnyKindGiveTheVerdictsOfFilesWithThoseBounds) {
  Random random(4);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    StnGenerateOptions shape;
    shape.shape = {31, 4, 3, 65, false};
    shape.seed = seed;
    nlohmann::json network = nlohmann::json::parse(run(generate_stn, shape).out);
    const std::string before = network.dump();
    std::string changes;
    std::vector<bool> expected{true};
    for (int i = 0; i < 25; ++i) {
      const bool contingent = random.chance(0.3);
      nlohmann::json& links = network.at(contingent ? "contingent" : "arcs");
      nlohmann::json& link = links.at(random.below(links.size()));
      const double min = link.at("min").is_null() ? 0 : link.at("min").get<double>();
      link["min"] = contingent ? 1 + min / 2 : min - static_cast<double>(random.below(20)) + 10;
      link["max"] = link.at("min").get<double>() + 1 + static_cast<double>(random.below(60));
      changes += (i > 0 ? "," : "") + link.dump();
      expected.push_back(run(check_stn_controllability, StnOptions{}, network.dump()).code ==
                         kExitOk);
    }

    const Outcome outcome = follow(before, changes, true);

    EXPECT_EQ(verdicts(outcome), expected) << seed;
  }
}

}  // namespace
}  // namespace skein::temporal_tool
