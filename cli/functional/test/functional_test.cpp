// SPDX-License-Identifier: Apache-2.0
#include "skein/functional_tool/functional.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "skein/foundation/exit_code.hpp"

namespace skein::functional_tool {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

struct Outcome {
  int code = 0;
  std::string out, err;
};

Outcome check_virtually(const std::string& scenario, const std::string& uav, bool json = false) {
  FunctionalOptions options;
  options.scenario = SKEIN_SOURCE_DIR "/scenarios/" + scenario;
  options.uav = uav;
  options.virtual_time = true;
  options.json = json;
  std::ostringstream out, err;
  const int code = check(options, out, err);
  return {code, out.str(), err.str()};
}

TEST(Functional, TheSimulatorKeepsTheContractOfEveryVehicleOfComets) {
  for (const std::string uav : {"marvin", "heliv", "karma"}) {
    const Outcome outcome = check_virtually("comets/confirmed.yaml", uav);
    EXPECT_EQ(outcome.code, kExitOk) << outcome.out << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("kept  a landing ends on the ground"));
    EXPECT_THAT(outcome.out, Not(HasSubstr("NOT")));
  }
}

TEST(Functional, SaysItAsOneDocument) {
  const Outcome outcome = check_virtually("comets/confirmed.yaml", "marvin", true);

  const auto document = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(document.at("uav"), "marvin");
  EXPECT_EQ(document.at("layer"), "sim");
  EXPECT_TRUE(document.at("kept").get<bool>());
  EXPECT_GE(document.at("points").size(), 21U);
}

TEST(Functional, SaysWhatIsWrongWithTheQuestion) {
  EXPECT_EQ(check_virtually("comets/confirmed.yaml", "marvn").code, kExitBadInput);
  EXPECT_THAT(check_virtually("comets/confirmed.yaml", "marvn").err,
              HasSubstr("did you mean 'marvin'?"));
  EXPECT_THAT(check_virtually("comets/confirmed.yaml", "").err, HasSubstr("name one by --uav"));
  EXPECT_EQ(check_virtually("comets/no-such.yaml", "marvin").code, kExitBadInput);
}

TEST(Functional, OverTheWireTheSimulatorIsNotAskedInItsOwnPlace) {
  FunctionalOptions options;
  options.scenario = SKEIN_SOURCE_DIR "/scenarios/comets/confirmed.yaml";
  options.uav = "marvin";
  std::ostringstream out, err;

  EXPECT_EQ(check(options, out, err), kExitBadInput);
  EXPECT_THAT(err.str(), HasSubstr("functional layer of its own"));
}

}  // namespace
}  // namespace skein::functional_tool
