// SPDX-License-Identifier: Apache-2.0
// What cannot be run is refused before anything is started.
#include <gmock/gmock.h>

#include <sys/wait.h>

#include <fstream>
#include <iterator>

#include "testing/dds_run.hpp"

namespace skein::testing {
namespace {

using ::testing::AllOf;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(DdsRefusal, AWrongScenarioGivesTwoWithEveryErrorAndStartsNothing) {
  DdsRun run;
  run.take_scenario("confirmed");
  run.change("rate: 20", "rate: -20");
  run.change("uav: karma", "uav: krama");

  run.start();
  const auto status = run.wait(10);

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 2);
  EXPECT_THAT(run.output(), HasSubstr("rate"));
  EXPECT_THAT(run.output(), HasSubstr("did you mean 'karma'?"));
  EXPECT_THAT(run.daemons(), IsEmpty());
  EXPECT_FALSE(fs::exists(run.folder()));
}

class WrongOption : public ::testing::TestWithParam<std::vector<std::string>> {};

TEST_P(WrongOption, GivesTwoAndStartsNothing) {
  DdsRun run;
  run.take_scenario("confirmed");

  run.start(GetParam());
  const auto status = run.wait(10);

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 2);
  EXPECT_FALSE(run.output().empty());
  EXPECT_THAT(run.daemons(), IsEmpty());
  EXPECT_FALSE(fs::exists(run.folder()));
}

INSTANTIATE_TEST_SUITE_P(DdsRefusal, WrongOption,
                         ::testing::Values(std::vector<std::string>{"--degree", "4"},
                                           std::vector<std::string>{"--degree", "marvn=1"},
                                           std::vector<std::string>{"--rate", "0"},
                                           std::vector<std::string>{"--rate", "fast"},
                                           std::vector<std::string>{"--domain", "500"},
                                           std::vector<std::string>{"--frobnicate"}));

TEST(DdsRefusal, AMissingDaemonGivesThreeAndNamesTheProgram) {
  DdsRun run;
  run.take_scenario("confirmed");
  fs::create_directories(run.file("none"));

  run.start({"--daemons", run.file("none").string()});
  const auto status = run.wait(30);

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 3);
  EXPECT_THAT(run.output(), HasSubstr("cannot start " + run.file("none/skein-sim").string()));
  EXPECT_TRUE(run.nothing_runs());
}

// One program of three is missing: those already started are stopped again.
TEST(DdsRefusal, AMissingDecisionNodeStopsWhatWasStarted) {
  DdsRun run;
  run.take_scenario("confirmed");
  fs::create_directories(run.file("some"));
  for (const char* name : {"skein-sim", "skein-ground"}) {
    fs::create_symlink(fs::path(kPrograms) / name, run.file("some") / name);
  }

  run.start({"--daemons", run.file("some").string()});
  const auto status = run.wait(30);

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 3);
  EXPECT_THAT(run.output(), HasSubstr("skein-ddn"));
  EXPECT_TRUE(run.nothing_runs());
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// A copy of the scenario for one UAV, where the members of its joint tasks keep farther apart.
void write_other_version(const DdsRun& run) {
  const fs::path models = fs::path(SKEIN_SOURCE_DIR) / "scenarios/models/interaction";
  fs::copy(models, run.file("models"), fs::copy_options::recursive);
  const auto changed = [](std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
  };
  const fs::path model = run.file("models/monitoring-with-relay.yaml");
  std::ofstream(model) << changed(text_of(models / model.filename()), "least: 20", "least: 25");
  std::ofstream(run.file("other.yaml"))
      << changed(text_of(run.file("scenario.yaml")), models.string(), run.file("models").string());
}

TEST(DdsRefusal, UavsWithOtherVersionsOfAModelAreGivenNoJointTaskAndBothAreNamed) {
  DdsRun run;
  run.take_scenario_of("mref/nominal");
  run.change("duration_limit: 2400", "duration_limit: 40");
  write_other_version(run);
  const std::string programs = run.programs_with(
      {"skein-ddn"},
      "all=\"$*\"\nfor one; do shift; case \"$all $one\" in *' uav2 '*/scenario.yaml) one='" +
          run.file("other.yaml").string() +
          "';; esac; set -- \"$@\" \"$one\"; done\n"
          "exec \"$programs/skein-ddn\" \"$@\"");

  run.start({"--rate", "10", "--daemons", programs});
  (void)run.wait(60);

  std::vector<std::string> refused;
  for (const journal::Record& record : run.records())
    if (record.kind() == "command" && record.text("state") == "refused")
      refused.emplace_back(record.text("why"));
  EXPECT_THAT(refused, ::testing::SizeIs(2));
  EXPECT_THAT(refused, Each(AllOf(HasSubstr("uav2 has version "),
                                  HasSubstr("of its model, the ground station "))));
  EXPECT_EQ(run.count("joint", "kind", "joint"), 0U);
}

struct Daemon {
  std::string name;
  std::vector<std::string> command;
  std::string says;
};
class WrongDaemon : public ::testing::TestWithParam<Daemon> {};

TEST_P(WrongDaemon, StartedByHandGivesTwoAndSaysWhy) {
  const fs::path log = fs::temp_directory_path() / ("skein-daemon-" + GetParam().name);
  fs::remove(log);
  std::vector<std::string> command = GetParam().command;
  command[0] = kPrograms + "/" + command[0];

  auto process = run_tool::Process::start(command, log.string());
  ASSERT_TRUE(process.has_value());
  siginfo_t info{};
  ASSERT_EQ(waitid(P_PID, static_cast<id_t>(process->pid()), &info, WEXITED | WNOWAIT), 0);

  EXPECT_EQ(process->poll()->code, 2);
  EXPECT_THAT(run_tool::tail_of(log.string(), 20), HasSubstr(GetParam().says));
  fs::remove(log);
}

const std::string kScenario = std::string(SKEIN_SOURCE_DIR) + "/scenarios/comets/confirmed.yaml";

INSTANTIATE_TEST_SUITE_P(
    DdsRefusal, WrongDaemon,
    ::testing::Values(
        Daemon{"unknown_uav",
               {"skein-ddn", "--scenario", kScenario, "--uav", "marvn"},
               "did you mean 'marvin'?"},
        Daemon{"ground_as_uav",
               {"skein-ddn", "--scenario", kScenario, "--uav", "ground"},
               "no UAV 'ground'"},
        Daemon{"no_uav", {"skein-ddn", "--scenario", kScenario}, "--uav"},
        Daemon{"no_scenario", {"skein-sim"}, "--scenario"},
        Daemon{"no_file", {"skein-ground", "--scenario", "/no/such.yaml"}, "/no/such.yaml"},
        Daemon{
            "bad_domain", {"skein-ground", "--scenario", kScenario, "--domain", "101"}, "--domain"},
        Daemon{"bad_peer",
               {"skein-ground", "--scenario", kScenario, "--peer", "marvin"},
               "peer 'marvin' is not an IPv4 address"},
        Daemon{"no_config",
               {"skein-ground", "--scenario", kScenario, "--config", "/no/such.yaml"},
               "/no/such.yaml"}),
    [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace skein::testing
