// SPDX-License-Identifier: Apache-2.0
// `skein stn generate` and `skein stn dispatchable`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "skein/foundation/exit_code.hpp"
#include "skein/temporal_tool/stn.hpp"
#include "stn_runs.hpp"

namespace skein::temporal_tool {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::Outcome;
using testing::run;

StnGenerateOptions shape(std::uint32_t nodes, std::uint32_t contingent, bool broken,
                         std::uint64_t seed) {
  StnGenerateOptions options;
  options.shape = {nodes, contingent, 3, 65, broken};
  options.seed = seed;
  return options;
}

TEST(StnGenerate, IsControllableExactlyUnlessBroken) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    for (const bool broken : {false, true}) {
      const Outcome made = run(generate_stn, shape(40, 5, broken, seed));
      ASSERT_EQ(made.code, kExitOk) << made.err;

      EXPECT_EQ(run(check_stn_controllability, StnOptions{}, made.out).code,
                broken ? kExitNegative : kExitOk)
          << seed;
    }
  }
}

TEST(StnGenerate, GivesTheSameFileForTheSameSeedAndSaysTheSameInEveryFormat) {
  StnGenerateOptions options = shape(40, 5, false, 7);
  const std::string own = run(generate_stn, options).out;
  EXPECT_EQ(run(generate_stn, options).out, own);
  for (const char* format : {"graphml", "plain", "heatlab"}) {
    options.to = format;
    StnConvertOptions convert;
    convert.to = format;

    EXPECT_EQ(run(generate_stn, options).out, run(convert_stn, convert, own).out) << format;
  }
}

TEST(StnGenerate, HasTheShapeThatIsAskedFor) {
  const auto made = nlohmann::json::parse(run(generate_stn, shape(61, 9, false, 2)).out);

  EXPECT_EQ(made.at("nodes").size(), 61U);
  EXPECT_EQ(made.at("contingent").size(), 9U);
}

TEST(StnGenerate, SaysWhyNoNetworkHasThatShape) {
  EXPECT_THAT(run(generate_stn, shape(9, 0, false, 1)).err, HasSubstr("--nodes: at least 10"));
  EXPECT_THAT(run(generate_stn, shape(31, 8, false, 1)).err, HasSubstr("--contingent: at most 7"));
  StnGenerateOptions options = shape(40, 5, false, 1);
  options.to = "grapml";

  const Outcome outcome = run(generate_stn, options);

  EXPECT_EQ(outcome.code, kExitBadInput);
  EXPECT_THAT(outcome.err, HasSubstr("did you mean 'graphml'?"));
  EXPECT_THAT(outcome.out, IsEmpty());
}

TEST(StnDispatchable, ExistsForControllableNetworksAndIsReadBackAsOne) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    for (const bool broken : {false, true}) {
      const std::string network = run(generate_stn, shape(31, 4, broken, seed)).out;
      StnDispatchableOptions options;
      options.to = "graphml";

      const Outcome form = run(write_stn_dispatchable, options, network);

      ASSERT_EQ(form.code, broken ? kExitNegative : kExitOk) << form.err;
      if (broken) {
        EXPECT_THAT(form.out, IsEmpty());
        EXPECT_THAT(form.err, HasSubstr("no dispatchable form: not dynamically controllable\n"));
      } else {
        EXPECT_EQ(run(check_stn_controllability, StnOptions{}, form.out).code, kExitOk);
      }
    }
  }
}

// The law of a form without contingent links: looking at neighbours only, from the origin on, gives
// every node its earliest date.
TEST(StnDispatchable, NeighboursAloneGiveTheEarliestDates) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const std::string network = run(generate_stn, shape(31, 0, false, seed)).out;
    StnOptions json;
    json.json = true;
    const auto dates =
        nlohmann::json::parse(run(check_stn, StnCheckOptions{json, true}, network).out).at("dates");
    const auto form =
        nlohmann::json::parse(run(write_stn_dispatchable, StnDispatchableOptions{}, network).out);
    const auto date = [&](const nlohmann::json& node) {
      return dates.at(node.get<std::string>()).at(0).get<double>();
    };

    // "to - from <= max" with max <= 0: `from` waits for `to`, a neighbour that comes before.
    std::map<std::string, double> earliest;
    for (const auto& edge : form.at("edges")) {
      if (edge.at("max").get<double>() > 0) continue;
      double& at = earliest[edge.at("from").get<std::string>()];
      at = std::max(at, date(edge.at("to")) - edge.at("max").get<double>());
    }
    for (const auto& node : form.at("nodes")) {
      EXPECT_EQ(earliest[node.get<std::string>()], date(node)) << node;
    }
  }
}

TEST(StnDispatchable, RefusesAFormatWithoutWaitsAndANodeBeforeTheOrigin) {
  const std::string network = run(generate_stn, shape(31, 4, false, 1)).out;
  StnDispatchableOptions options;
  options.to = "plain";
  EXPECT_THAT(run(write_stn_dispatchable, options, network).err, HasSubstr("json and graphml"));

  const Outcome early =
      run(write_stn_dispatchable, StnDispatchableOptions{},
          R"({"nodes":["v0","a"],"arcs":[{"from":"a","to":"v0","min":1,"max":2}]})");
  EXPECT_EQ(early.code, kExitNegative);
  EXPECT_THAT(early.err, HasSubstr("a node must come before 'v0'"));
}

}  // namespace
}  // namespace skein::temporal_tool
