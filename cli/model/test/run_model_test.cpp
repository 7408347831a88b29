// SPDX-License-Identifier: Apache-2.0
// `skein model run`: spec 7.8, as others will run it.
#include "skein/model_tool/run_model.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

namespace skein::model_tool {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

const fs::path kShared = fs::path(SKEIN_SOURCE_DIR) / "../shared/data/interaction";

std::string content(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  EXPECT_TRUE(in) << file;
  return std::string(std::istreambuf_iterator<char>(in), {});
}

struct Ran {
  int code = 0;
  std::string out, err;
};

Ran run(const std::string& automaton, const std::string& trace,
        std::optional<double> until = std::nullopt) {
  RunOptions options;
  options.automaton = automaton;
  if (until) options.until = MissionTime::seconds(*until);
  std::istringstream in(trace);
  std::ostringstream out, err;
  const int code = run_model(options, in, out, err);
  return {code, out.str(), err.str()};
}

/// An automaton in a file of its own.
class RunModel : public ::testing::Test {
 protected:
  std::string file_with(const std::string& text) {
    const fs::path path = fs::path(::testing::TempDir()) /
                          ::testing::UnitTest::GetInstance()->current_test_info()->name();
    std::ofstream(path, std::ios::binary) << text;
    return path.string();
  }
};

constexpr const char* kOneTask =
    R"({"block":"b","exit":[[{"time":7.5,"is":"passed"}]],"content":[{"task":"t","type":"goto"}]})";

TEST_F(RunModel, GivesTheEffectsOfTheSharedExampleToTheByte) {
  if (!fs::exists(kShared)) GTEST_SKIP() << kShared << " is not there";

  const Ran ran =
      run((kShared / "r1-automaton.json").string(), content(kShared / "r1-trace.jsonl"));

  EXPECT_EQ(ran.out, content(kShared / "r1-effects.jsonl"));
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(ran.err, "");
}

// The role that is shipped is the one of the example, its SCMs given by the coordination table.
TEST_F(RunModel, PlaysARoleOfALibraryAsItsVariantSays) {
  if (!fs::exists(kShared)) GTEST_SKIP() << kShared << " is not there";
  RunOptions options;
  options.automaton = SKEIN_SOURCE_DIR "/scenarios/models/interaction/monitoring-with-relay.yaml";
  options.role = "perceive";
  std::istringstream in(content(kShared / "r1-trace.jsonl"));
  std::ostringstream out, err;

  EXPECT_EQ(run_model(options, in, out, err), 0) << err.str();
  EXPECT_EQ(out.str(), content(kShared / "r1-effects.jsonl"));
}

class RunModelOfEscorts : public RunModel {
 protected:
  Ran escort(std::map<std::string, double> set) {
    RunOptions options;
    options.automaton = SKEIN_SOURCE_DIR "/scenarios/models/interaction/escorting.yaml";
    options.set = std::move(set);
    options.until = MissionTime::seconds(1000);
    std::istringstream in(R"({"at":0,"start":true}
{"at":20,"status":{"componel":"ac71","state":"ended"}}
{"at":30,"status":{"componel":"t71","state":"running"}}
)");
    std::ostringstream out, err;
    const int code = run_model(options, in, out, err);
    return {code, out.str(), err.str()};
  }
};

TEST_F(RunModelOfEscorts, ItFollowsForAsLongAsAsked) {
  EXPECT_NE(escort({{"duration", 100}}).out.find(R"({"at": 120, "interrupt": "t71"})"),
            std::string::npos);
  EXPECT_NE(escort({{"duration", 600}}).out.find(R"({"at": 620, "interrupt": "t71"})"),
            std::string::npos);
}

TEST_F(RunModelOfEscorts, SecondsThatAreNotSaidOrNotAskedForAreNamed) {
  const Ran without = escort({});
  EXPECT_EQ(without.code, 2);
  EXPECT_THAT(without.err, ::testing::HasSubstr("a condition names the parameter 'duration'; "
                                                "expected --set duration=SECONDS"));
  EXPECT_THAT(escort({{"length", 5}}).err,
              ::testing::HasSubstr("no condition on time names 'length'; expected --set with one "
                                   "of duration"));
}

// Spec 7.7: an invitation is answered each time, a violation leads to a valid position, and when
// all have done their part it flies back.
TEST_F(RunModel, TheRelayAnswersMovesAndComesBack) {
  RunOptions options;
  options.automaton = SKEIN_SOURCE_DIR "/scenarios/models/interaction/monitoring-with-relay.yaml";
  options.role = "relay";
  std::istringstream in(R"({"at":0,"start":true}
{"at":20,"status":{"componel":"t21","state":"ended"}}
{"at":25,"status":{"componel":"t22","state":"ended"}}
{"at":30,"message":"role-allocation invitation"}
{"at":31,"status":{"componel":"ac21","state":"ended"}}
{"at":40,"scm":"mcs3","state":"violated"}
{"at":50,"status":{"componel":"t23","state":"ended"}}
{"at":51,"status":{"componel":"t24","state":"aborted"}}
{"at":60,"message":"role-allocation invitation"}
{"at":61,"status":{"componel":"ac21","state":"ended"}}
{"at":900,"status":{"componel":"t24","state":"ended"}}
{"at":950,"status":{"componel":"t25","state":"ended"}}
)");
  std::ostringstream out, err;
  ASSERT_EQ(run_model(options, in, out, err), 0) << err.str();

  std::string done;
  std::istringstream lines(out.str());
  for (std::string line; std::getline(lines, line);) {
    const auto json = nlohmann::json::parse(line);
    for (const char* what : {"compute", "run", "negotiate", "interrupt", "model"}) {
      if (json.contains(what))
        done += std::string(what) + " " + json.at(what).get<std::string>() + "\n";
    }
  }
  EXPECT_EQ(done,
            "compute pl20\nrun t21\nrun t22\nrun t24\nnegotiate ac21\ncompute pl24\nrun t23\n"
            "interrupt t24\nrun t24\nnegotiate ac21\nrun t25\nmodel ended\n");
}

TEST_F(RunModel, WhichRoleIsAskedForIfThereAreSeveral) {
  const std::string file =
      SKEIN_SOURCE_DIR "/scenarios/models/interaction/monitoring-with-relay.yaml";

  EXPECT_EQ(run(file, "").code, 2);
  EXPECT_THAT(run(file, "").err,
              HasSubstr("several roles; expected --role with one of perceive, relay"));
}

TEST_F(RunModel, PlaysOnUntilTheInstantGiven) {
  const std::string file = file_with(kOneTask);
  const std::string start = "{\"at\":1,\"start\":true}\n";

  EXPECT_EQ(run(file, start).out.find("aborting"), std::string::npos);
  EXPECT_EQ(run(file, start, 7).out.find("aborting"), std::string::npos);
  EXPECT_THAT(run(file, start, 7.5).out,
              HasSubstr("{\"at\": 7.5, \"componel\": \"b\", \"state\": \"aborting\"}\n"));
}

TEST_F(RunModel, RefusesWrongLinesWithTheirNumbersAndGoesOn) {
  const Ran ran = run(file_with(kOneTask), R"(nonsense
{"at":1,"start":true}

{"at":0,"message":"m"}
{"at":1,"status":{"componel":"x","state":"ended"}}
{"at":1,"status":{"componel":"b","state":"ended"}}
{"at":1,"status":{"componel":"t","state":"scheduled"}}
{"at":1,"start":false}
{"at":1,"start":true}
{"at":1,"scm":"m","state":"bent"}
{"at":1,"messge":"m"}
{"at":1,"message":"m","by":"b"}
{"at":1,"at":2,"message":"m"}
{"at":2,"status":{"componel":"t","state":"ended"}}
)");

  std::vector<int> refused;
  std::istringstream lines(ran.out);
  std::string last;
  for (std::string line; std::getline(lines, line); last = line) {
    const auto json = nlohmann::json::parse(line);
    if (json.contains("refused")) {
      refused.push_back(json.at("refused").get<int>());
      EXPECT_FALSE(json.at("why").get<std::string>().empty());
    }
  }
  EXPECT_EQ(refused, (std::vector<int>{1, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13}));
  EXPECT_EQ(last, R"({"at": 2, "model": "ended"})");
  EXPECT_EQ(ran.code, 1);
  EXPECT_THAT(ran.err, HasSubstr("standard input:5: unknown componel 'x'"));
}

TEST_F(RunModel, AWrongLineHasNoEffectNotEvenOnTime) {
  const Ran ran =
      run(file_with(kOneTask),
          "{\"at\":1,\"start\":true}\n{\"at\":9,\"status\":{\"componel\":\"x\",\"state\":"
          "\"ended\"}}\n{\"at\":2,\"status\":{\"componel\":\"t\",\"state\":\"running\"}}\n");

  EXPECT_THAT(ran.out, HasSubstr("{\"at\": 2, \"componel\": \"t\", \"state\": \"running\"}"));
}

TEST_F(RunModel, SaysWhyItAbortedALoopWithoutEnd) {
  const Ran ran = run(file_with(R"(
block: b
type: loop
content: [{block: c, pre: [[{componel: b, state: ended}], [{time: 0, is: not-yet-passed}]],
           content: [{task: t, type: goto}]}])"),
                      "{\"at\":1,\"start\":true}\n");

  EXPECT_THAT(ran.out, HasSubstr("\"model\": \"aborted\", \"why\": \"'b' began anew 1000 times"));
}

TEST_F(RunModel, AnAutomatonThatCannotBeUsedIsRefusedWithAllErrors) {
  const Ran ran =
      run(file_with("{block: b, exit: [[{componel: x, state: gone}]], content: []}"), "");

  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(ran.out, "");
  EXPECT_THAT(ran.err, HasSubstr("unknown componel 'x'"));
  EXPECT_THAT(ran.err, HasSubstr("an empty content"));
  EXPECT_EQ(run("/nowhere/a.json", "").code, 2);
}

}  // namespace
}  // namespace skein::model_tool
