// SPDX-License-Identifier: Apache-2.0
#include "skein/temporal_tool/stn.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "skein/foundation/exit_code.hpp"
#include "stn_runs.hpp"

namespace skein::temporal_tool {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::Outcome;
using testing::run;
using ::testing::StartsWith;

constexpr const char* kGood = R"({"nodes":["v0","a","b"],
  "arcs":[{"from":"v0","to":"a","min":0,"max":null}],
  "contingent":[{"from":"a","to":"b","min":2,"max":3}]})";
// Consistent; b comes when nature wants.
constexpr const char* kUncontrollable = R"({"nodes":["v0","a","b"],
  "arcs":[{"from":"v0","to":"a","min":0,"max":0},{"from":"v0","to":"b","min":null,"max":2.5}],
  "contingent":[{"from":"a","to":"b","min":2,"max":3}]})";

std::filesystem::path scratch(const std::string& name) {
  const auto folder = std::filesystem::path(::testing::TempDir()) / "skein-stn-test";
  std::filesystem::create_directories(folder);
  return folder / name;
}

std::string content(const std::filesystem::path& file) {
  std::ifstream in(file);
  return std::string(std::istreambuf_iterator<char>(in), {});
}

TEST(StnCheck, SaysConsistentOfWhatMayNotBeControllable) {
  const Outcome outcome = run(check_stn, StnCheckOptions{}, kUncontrollable);

  EXPECT_EQ(outcome.code, kExitOk);
  EXPECT_THAT(outcome.out, StartsWith("standard input: STNU, 3 nodes"));
  EXPECT_THAT(outcome.out, HasSubstr("\nconsistent"));
}

TEST(StnCheck, LeavesControllabilityOpenUnlessItFollows) {
  StnCheckOptions options;
  options.common.json = true;
  const auto controllable = [&](const std::string& input) {
    return nlohmann::json::parse(run(check_stn, options, input).out).at("controllable");
  };

  EXPECT_EQ(controllable(kUncontrollable), nullptr);
  EXPECT_EQ(controllable(R"({"nodes":["v0"],"arcs":[]})"), true);
  EXPECT_EQ(controllable(R"({"nodes":["v0","a"],"arcs":[{"from":"v0","to":"a","min":1,"max":1},
                             {"from":"a","to":"v0","min":0,"max":1}]})"),
            false);
}

TEST(StnDraw, RefusesMoreThanAThousandNodes) {
  std::string input = R"({"nodes":["v0")";
  for (int i = 0; i < 1000; ++i) input += R"(,"n)" + std::to_string(i) + "\"";

  const Outcome outcome = run(draw_stn, StnDrawOptions{}, input + R"(],"arcs":[]})");

  EXPECT_EQ(outcome.code, kExitBadInput);
  EXPECT_THAT(outcome.err, HasSubstr("1001 nodes are too many for a picture"));
}

// a comes 1 before Z: a network of its own, and none for the CSTNU Tool.
constexpr const char* kBeforeZ =
    "# Time-Point Names\nZ a C\n# Ordinary Edges\nZ -1 a\n# Contingent Links\na 1 3 C\n";

TEST(StnZFirst, LetsNoNodeComeBeforeTheOriginAndIsMentionedWhereItDecides) {
  StnOptions first;
  first.z_first = true;

  EXPECT_EQ(run(check_stn_controllability, first, kBeforeZ).code, kExitNegative);
  EXPECT_EQ(run(check_stn, StnCheckOptions{first, false}, kBeforeZ).code, kExitNegative);
  for (const Outcome& outcome : {run(check_stn_controllability, StnOptions{}, kBeforeZ),
                                 run(check_stn, StnCheckOptions{}, kBeforeZ)}) {
    EXPECT_EQ(outcome.code, kExitOk);
    EXPECT_THAT(outcome.err, HasSubstr("note: a node must come before 'Z'; the CSTNU Tool"));
  }
}

TEST(StnZFirst, IsNotMentionedWhereItDecidesNothing) {
  const std::string free = "# Time-Point Names\nZ a C\n# Contingent Links\na 1 3 C\n";

  EXPECT_THAT(run(check_stn_controllability, StnOptions{}, free).err, IsEmpty());
  EXPECT_THAT(run(check_stn, StnCheckOptions{}, free).err, IsEmpty());
  EXPECT_THAT(run(check_stn_controllability, StnOptions{}, kGood).err, IsEmpty());
}

TEST(StnZFirst, IsWrittenByConvert) {
  StnConvertOptions options;
  options.to = "json";
  options.common.z_first = true;

  const Outcome outcome = run(convert_stn, options, kBeforeZ);

  EXPECT_EQ(run(check_stn_controllability, StnOptions{}, outcome.out).code, kExitNegative);
}

TEST(StnWarnings, AreSaidAndChangeNoExitCode) {
  const Outcome outcome = run(check_stn_controllability, StnOptions{},
                              "# Time-Point Names\nZ a C\n# Contingent Links\na 0 3 C\n");

  EXPECT_EQ(outcome.code, kExitOk);
  EXPECT_THAT(outcome.err, StartsWith("standard input:4:1: warning: the contingent min 0 is not"));
}

TEST(StnConvert, SaysWhatTheCstnuToolCannotRead) {
  const auto notes = [](const std::string& min, const std::string& to) {
    StnConvertOptions options;
    options.to = to;
    return run(convert_stn, options,
               R"({"nodes":["v0","a"],"arcs":[{"from":"v0","to":"a","min":)" + min +
                   R"(,"max":null}]})")
        .err;
  };

  EXPECT_THAT(notes("1.5", "graphml"), HasSubstr("note: 1 bound is not a whole number"));
  EXPECT_THAT(notes("1", "graphml"), IsEmpty());
  EXPECT_THAT(notes("1.5", "heatlab"), IsEmpty());
}

TEST(StnDc, TellsControllableFromNot) {
  EXPECT_EQ(run(check_stn_controllability, StnOptions{}, kGood).code, kExitOk);

  const Outcome outcome = run(check_stn_controllability, StnOptions{}, kUncontrollable);
  EXPECT_EQ(outcome.code, kExitNegative);
  EXPECT_THAT(outcome.out, HasSubstr("not dynamically controllable: these"));
  EXPECT_THAT(outcome.out, HasSubstr("a → b"));
}

TEST(StnDc, MeasuresWithTheClockItIsGiven) {
  StnOptions options;
  options.json = true;
  options.now = [at = 0.0]() mutable { return at += 0.5; };

  const Outcome outcome = run(check_stn_controllability, options, kGood);

  EXPECT_EQ(nlohmann::json::parse(outcome.out).at("seconds"), 0.5);
}

TEST(StnDc, PaintsOnlyForATerminal) {
  StnOptions options;
  EXPECT_EQ(run(check_stn_controllability, options, kGood).out.find('\033'), std::string::npos);

  options.colour = true;
  EXPECT_THAT(run(check_stn_controllability, options, kGood).out, HasSubstr("\033[1;32m"));
}

TEST(StnCommands, ReportBadInputOnStandardErrorOnly) {
  const std::string bad = R"({"nodes":["v0"],"arcs":[{"from":"v0"}]})";
  for (const Outcome& outcome :
       {run(check_stn, StnCheckOptions{}, bad), run(check_stn_controllability, StnOptions{}, bad),
        run(dispatch_stn, StnDispatchOptions{}, bad), run(draw_stn, StnDrawOptions{}, bad),
        run(convert_stn, StnConvertOptions{{}, "json", ""}, bad)}) {
    EXPECT_EQ(outcome.code, kExitBadInput);
    EXPECT_THAT(outcome.out, IsEmpty());
    EXPECT_THAT(outcome.err, StartsWith("standard input:1:25: arcs[0]: missing key 'to'\n"));
  }
}

TEST(StnCommands, SayThatAFileCannotBeRead) {
  StnOptions options;
  for (const std::string& file : {scratch("missing").string(), ::testing::TempDir()}) {
    options.file = file;

    const Outcome outcome = run(check_stn_controllability, options, "");

    EXPECT_EQ(outcome.code, kExitBadInput) << file;
    EXPECT_THAT(outcome.err, HasSubstr("cannot be read")) << file;
  }
}

TEST(StnCommands, ReadAndWriteFiles) {
  const auto network = scratch("in.json");
  std::ofstream(network) << kGood;
  StnConvertOptions options;
  options.common.file = network.string();
  options.to = "plain";
  options.output = scratch("out.plainStnu").string();

  const Outcome outcome = run(convert_stn, options, "");

  EXPECT_EQ(outcome.code, kExitOk) << outcome.err;
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_THAT(content(options.output), HasSubstr("'a' 2 3 'b'"));
}

TEST(StnCommands, SayThatAFileCannotBeWritten) {
  StnDrawOptions options;
  options.output = scratch("no/such/folder/x.svg").string();

  const Outcome outcome = run(draw_stn, options, kGood);

  EXPECT_EQ(outcome.code, kExitSystem);
  EXPECT_THAT(outcome.err, HasSubstr("cannot be written"));
}

TEST(StnDispatch, IsTheSameForTheSameSeedAndKeepsTheBounds) {
  StnDispatchOptions options;
  options.common.json = true;
  for (options.seed = 0; options.seed < 50; ++options.seed) {
    const Outcome outcome = run(dispatch_stn, options, kGood);

    ASSERT_EQ(outcome.code, kExitOk) << outcome.out;
    EXPECT_EQ(outcome.out, run(dispatch_stn, options, kGood).out);
    const auto events = nlohmann::json::parse(outcome.out).at("events");
    ASSERT_EQ(events.size(), 3U);
    EXPECT_EQ(events[2].at("observed"), true);
    const double duration = events[2].at("at").get<double>() - events[1].at("at").get<double>();
    EXPECT_GE(duration, 2);
    EXPECT_LE(duration, 3);
  }
}

TEST(StnDispatch, RefusesWhatIsNotControllable) {
  const Outcome outcome = run(dispatch_stn, StnDispatchOptions{}, kUncontrollable);

  EXPECT_EQ(outcome.code, kExitNegative);
  EXPECT_THAT(outcome.out, HasSubstr("not dynamically controllable"));
}

TEST(StnDraw, ShowsDatesAndConflict) {
  const Outcome outcome = run(draw_stn, StnDrawOptions{}, kUncontrollable);

  EXPECT_EQ(outcome.code, kExitOk);
  EXPECT_THAT(outcome.out, StartsWith("<svg "));
  EXPECT_THAT(outcome.out, HasSubstr(">2 … 2.5<"));
  EXPECT_THAT(outcome.out, HasSubstr(">conflict<"));
}

TEST(StnDraw, WarnsThatALargePictureIsLarge) {
  std::string nodes = R"("v0")";
  for (int i = 0; i < 100; ++i) nodes += ",\"n" + std::to_string(i) + "\"";
  const std::string large = R"({"nodes":[)" + nodes + R"(],"arcs":[]})";

  EXPECT_THAT(run(draw_stn, StnDrawOptions{}, large).err, HasSubstr("note: 101 nodes"));
  EXPECT_THAT(run(draw_stn, StnDrawOptions{}, kGood).err, IsEmpty());
}

TEST(StnConvert, SaysWhichFormatWasMeantAndWhyOneCannotHoldTheNetwork) {
  EXPECT_EQ(run(convert_stn, StnConvertOptions{{}, "grapml", ""}, kGood).err,
            "--to: unknown format 'grapml'; did you mean 'graphml'?\n");
  EXPECT_THAT(run(convert_stn, StnConvertOptions{{}, "mastn", ""}, kGood).err,
              HasSubstr("cannot be written as mastn: nobody knows whose nodes they are"));
}

}  // namespace
}  // namespace skein::temporal_tool
