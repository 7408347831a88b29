// SPDX-License-Identifier: Apache-2.0
// `skein run` and `skein report` in virtual time: what they leave, print and answer.
#include "skein/run_tool/run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <sstream>
#include <streambuf>

#include "skein/foundation/exit_code.hpp"
#include "testing/scenario_copy.hpp"

namespace skein::run_tool {
namespace {

using testing::Folder;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::read_text;
using testing::write_text;
using testing::fs::exists;

RunOptions virtual_run(const std::string& scenario, const std::string& out) {
  RunOptions options;
  options.scenario = scenario;
  options.virtual_time = true;
  options.out = out;
  return options;
}

const std::string kConfirmed = testing::kComets + "confirmed.yaml";

TEST(Run, WithAllExpectationsMetGivesZeroAndAFullFolder) {
  const Folder folder;
  std::ostringstream out;
  std::ostringstream err;

  EXPECT_EQ(run(virtual_run(kConfirmed, folder.text()), out, err), kExitOk) << out.str();

  EXPECT_THAT(out.str(), HasSubstr("20 of 20 expectations met"));
  EXPECT_THAT(out.str(), HasSubstr(folder.text() + "/report.html"));
  for (const char* name :
       {"events.jsonl", "run.json", "report.html", "junit.xml", "result.json", "scenario.yaml"}) {
    EXPECT_TRUE(exists(folder / name)) << name;
  }
}

TEST(Run, ShowsProgressOnTheErrorStreamUnlessQuiet) {
  const Folder folder;
  std::ostringstream out;
  std::ostringstream loud;
  std::ostringstream silent;
  RunOptions options = virtual_run(kConfirmed, folder.text());

  run(options, out, loud);
  options.quiet = true;
  run(options, out, silent);

  EXPECT_THAT(loud.str(), HasSubstr("Monitoring  | marvin"));
  EXPECT_EQ(silent.str(), "");
}

TEST(Run, TwiceWithOneSeedLeavesTheSameBytes) {
  const Folder folder;
  std::ostringstream out;
  std::ostringstream err;

  run(virtual_run(kConfirmed, (folder / "a").string()), out, err);
  run(virtual_run(kConfirmed, (folder / "b").string()), out, err);

  for (const char* name : {"events.jsonl", "run.json", "report.html", "junit.xml", "result.json"}) {
    EXPECT_EQ(read_text(folder / "a" / name), read_text(folder / "b" / name)) << name;
  }
}

TEST(Run, AnExpectationThatIsNotMetGivesOneAndSaysWhatWasSeen) {
  const Folder folder;
  write_text(folder / "s.yaml",
             testing::comets_text("confirmed") +
                 "  - {name: nobody ever flies, never: {kind: task, type: takeoff}}\n");
  std::ostringstream out;
  std::ostringstream err;

  EXPECT_EQ(run(virtual_run(folder / "s.yaml", (folder / "out").string()), out, err),
            kExitNegative);

  EXPECT_THAT(out.str(), HasSubstr("FAILED  nobody ever flies"));
  EXPECT_THAT(out.str(), HasSubstr("20 of 21 expectations met"));
  EXPECT_THAT(read_text(folder / "out/junit.xml"), HasSubstr("<failure"));
}

TEST(Run, AMissionThatDoesNotEndInTimeSaysSo) {
  const Folder folder;
  write_text(folder / "s.yaml", testing::replaced(testing::comets_text("confirmed"),
                                                  "duration_limit: 2100", "duration_limit: 100"));
  std::ostringstream out;
  std::ostringstream err;

  EXPECT_EQ(run(virtual_run(folder / "s.yaml", (folder / "out").string()), out, err),
            kExitNegative);

  EXPECT_THAT(out.str(), HasSubstr("the time limit came before the mission's end"));
  EXPECT_THAT(read_text(folder / "out/events.jsonl"), HasSubstr("\"state\":\"time-limit\""));
}

TEST(Run, AMissionThatDoesNotEndAndExpectsNothingHasNotPassed) {
  const Folder folder;
  std::string text = testing::comets_text("confirmed");
  text = text.substr(0, text.find("\nexpect:") + 1);
  write_text(folder / "ends.yaml", text);
  write_text(folder / "cut.yaml",
             testing::replaced(text, "duration_limit: 2100", "duration_limit: 100"));
  std::ostringstream out;
  std::ostringstream err;

  EXPECT_EQ(run(virtual_run(folder / "ends.yaml", (folder / "a").string()), out, err), kExitOk);
  EXPECT_EQ(run(virtual_run(folder / "cut.yaml", (folder / "b").string()), out, err),
            kExitNegative);

  EXPECT_THAT(out.str(), HasSubstr("the mission did not end, and the scenario expects nothing"));
}

TEST(Run, AWrongScenarioGivesTwoWithEveryErrorAndStartsNothing) {
  const Folder folder;
  std::string text = testing::comets_text("confirmed");
  text = testing::replaced(text, "rate: 20", "rate: -20");
  text = testing::replaced(text, "degree: 3, contact_loss: {policy: hold, after: 60}",
                           "degree: 9, contact_loss: {policy: hould, after: 60}");
  text = testing::replaced(text, "uav: karma", "uav: krama");
  write_text(folder / "s.yaml", text);
  std::ostringstream out;
  std::ostringstream err;

  EXPECT_EQ(run(virtual_run(folder / "s.yaml", (folder / "out").string()), out, err),
            kExitBadInput);

  EXPECT_THAT(err.str(), HasSubstr("s.yaml:7:"));
  EXPECT_THAT(err.str(), HasSubstr("rate"));
  EXPECT_THAT(err.str(), HasSubstr("uavs.marvin.degree"));
  EXPECT_THAT(err.str(), HasSubstr("did you mean 'hold'?"));
  EXPECT_THAT(err.str(), HasSubstr("did you mean 'karma'?"));
  EXPECT_EQ(out.str(), "");
  EXPECT_FALSE(exists(folder / "out"));
}

TEST(Run, WrongOverridesAndAWrongAssemblyGiveTwo) {
  const Folder folder;
  write_text(folder / "s.yaml", testing::replaced(testing::comets_text("confirmed"),
                                                  "start: [0, 0]", "start: [99000, 0]"));
  std::ostringstream out;
  std::ostringstream err;
  RunOptions options = virtual_run(kConfirmed, (folder / "out").string());
  options.overrides.degrees = {"marvn=1", "8"};

  EXPECT_EQ(run(options, out, err), kExitBadInput);
  EXPECT_EQ(run(virtual_run(folder / "s.yaml", (folder / "out").string()), out, err),
            kExitBadInput);

  EXPECT_THAT(err.str(), HasSubstr("did you mean 'marvin'?"));
  EXPECT_THAT(err.str(), HasSubstr("'8'"));
  EXPECT_THAT(err.str(), HasSubstr("marvin"));
  EXPECT_FALSE(exists(folder / "out"));
}

TEST(Run, WithoutANodeThatTheScenarioDoesNotHaveGivesTwo) {
  const Folder folder;
  std::ostringstream out;
  std::ostringstream err;
  RunOptions options = virtual_run(kConfirmed, (folder / "out").string());
  options.without = {"sim", "marvn"};

  EXPECT_EQ(run(options, out, err), kExitBadInput);

  EXPECT_THAT(err.str(), HasSubstr("no node 'marvn' in this scenario; did you mean 'marvin'?"));
  EXPECT_FALSE(exists(folder / "out"));
}

TEST(Run, AScenarioThatIsNotThereGivesTwo) {
  std::ostringstream out;
  std::ostringstream err;

  EXPECT_EQ(run(virtual_run("/no/such.yaml", "/no/out"), out, err), kExitBadInput);

  EXPECT_THAT(err.str(), HasSubstr("/no/such.yaml"));
}

TEST(Run, AFolderThatCannotBeMadeGivesThree) {
  std::ostringstream out;
  std::ostringstream err;

  EXPECT_EQ(run(virtual_run(kConfirmed, "/dev/null/out"), out, err), kExitSystem);

  EXPECT_THAT(err.str(), HasSubstr("/dev/null/out"));
}

TEST(Run, OnlyToCheckPlaysNothing) {
  const Folder folder;
  std::ostringstream out;
  std::ostringstream err;
  RunOptions options = virtual_run(kConfirmed, (folder / "out").string());
  options.check_only = true;

  EXPECT_EQ(run(options, out, err), kExitOk);

  EXPECT_THAT(out.str(), HasSubstr("3 UAVs"));
  EXPECT_FALSE(exists(folder / "out"));
}

TEST(Run, ACheckFindsMissionsThatWillBeRefused) {
  const Folder folder;
  const std::string scenarios = std::string(SKEIN_SOURCE_DIR) + "/scenarios/";
  std::string text = testing::replaced(read_text(scenarios + "karma/detection.yaml"),
                                       "[perform-detection", "[perfrom-detection");
  for (const char* part : {"worlds/", "comets/", "domains/"})
    text = testing::replaced(text, std::string("../") + part, scenarios + part);
  write_text(folder / "s.yaml", text);
  std::ostringstream out;
  std::ostringstream err;
  RunOptions options = virtual_run(folder / "s.yaml", (folder / "out").string());
  options.check_only = true;

  EXPECT_EQ(run(options, out, err), kExitNegative);

  EXPECT_THAT(err.str(), HasSubstr("did you mean 'perform-detection'"));
  EXPECT_THAT(out.str(), HasSubstr("some missions will be refused"));
}

TEST(Run, AsJsonPrintsOneDocumentAndNothingElse) {
  const Folder folder;
  std::ostringstream out;
  std::ostringstream err;
  RunOptions options = virtual_run(kConfirmed, folder.text());
  options.json = true;

  EXPECT_EQ(run(options, out, err), kExitOk);

  const auto document = nlohmann::json::parse(out.str(), nullptr, false);
  ASSERT_TRUE(document.is_object()) << out.str();
  EXPECT_EQ(document.dump(), nlohmann::json::parse(read_text(folder / "result.json")).dump());
  EXPECT_EQ(err.str(), "");
}

// A user who presses Ctrl-C as soon as the first line of progress appears.
class ImpatientUser : public std::streambuf {
 public:
  bool pressed() const { return pressed_; }

 protected:
  std::streamsize xsputn(const char*, std::streamsize count) override {
    press();
    return count;
  }
  int_type overflow(int_type c) override {
    press();
    return traits_type::not_eof(c);
  }

 private:
  void press() {
    if (!pressed_) raise(SIGINT);
    pressed_ = true;
  }
  bool pressed_ = false;
};

TEST(Run, InterruptedGives130AndStillWritesWhatThereIs) {
  const Folder folder;
  std::ostringstream out;
  ImpatientUser user;
  std::ostream err(&user);

  EXPECT_EQ(run(virtual_run(kConfirmed, folder.text()), out, err), kExitInterrupted);

  EXPECT_TRUE(user.pressed());
  EXPECT_THAT(out.str(), HasSubstr("interrupted"));
  EXPECT_THAT(read_text(folder / "events.jsonl"), Not(HasSubstr("\"state\":\"finished\"")));
  EXPECT_TRUE(exists(folder / "report.html"));
}

TEST(Run, LeavesTheSignalHandlersAsTheyWere) {
  const Folder folder;
  std::ostringstream out;
  std::ostringstream err;
  struct sigaction before {};
  sigaction(SIGINT, nullptr, &before);

  run(virtual_run(kConfirmed, folder.text()), out, err);

  struct sigaction after {};
  sigaction(SIGINT, nullptr, &after);
  EXPECT_EQ(before.sa_handler, after.sa_handler);
}

TEST(Report, IsWrittenAgainFromTheFolder) {
  const Folder folder;
  std::ostringstream out;
  std::ostringstream err;
  run(virtual_run(kConfirmed, folder.text()), out, err);
  const std::string html = read_text(folder / "report.html");
  testing::fs::remove(folder / "report.html");

  EXPECT_EQ(report({folder.text(), {}}, out, err), kExitOk);

  EXPECT_EQ(read_text(folder / "report.html"), html);
}

TEST(Report, OfAFolderWithoutARunGivesTwo) {
  const Folder folder;
  std::ostringstream out;
  std::ostringstream err;

  EXPECT_EQ(report({folder.text(), {}}, out, err), kExitBadInput);

  EXPECT_THAT(err.str(), Not(::testing::IsEmpty()));
}

}  // namespace
}  // namespace skein::run_tool
