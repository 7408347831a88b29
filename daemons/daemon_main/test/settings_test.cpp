// SPDX-License-Identifier: Apache-2.0
#include "settings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace skein::daemon_main {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A program with an option of each kind, started with some arguments.
class SettingsOfAProgram : public ::testing::Test {
 protected:
  SettingsOfAProgram() {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    path_ =
        (std::filesystem::temp_directory_path() / (std::string("skein-") + info->name())).string();
    app_.option_defaults()->always_capture_default();
    app_.add_option("--rate", rate);
    app_.add_option("--domain", domain)->check(CLI::Range(0, 100));
    app_.add_option("--interface", interfaces)->allow_extra_args(false)->delimiter(',');
    app_.add_option("--multicast", multicast)->default_str("on");
    app_.add_option("--log-level", level);
    app_.add_flag("--log-json", json)->default_str("false");
  }
  ~SettingsOfAProgram() override { std::filesystem::remove(path_); }

  void start(std::vector<std::string> arguments = {}) {
    std::reverse(arguments.begin(), arguments.end());
    app_.parse(arguments);
  }
  Diagnostics complete(const std::string& file = "") {
    settings_.emplace(app_, std::vector<std::string>{"help"});
    if (!file.empty()) std::ofstream(path_) << file;
    return settings_->complete(
        [this](const char* name) {
          const auto found = environment.find(name);
          return found == environment.end() ? nullptr : found->second.c_str();
        },
        file.empty() ? "" : path_);
  }
  std::string text_of(const Diagnostics& problems) {
    std::string text = to_text(problems);
    for (std::size_t at = 0; (at = text.find(path_)) != std::string::npos;)
      text.replace(at, path_.size(), "ddn.yaml");
    return text;
  }
  std::string shown() {
    std::string text = settings_->shown();
    for (std::size_t at = 0; (at = text.find(path_)) != std::string::npos;)
      text.replace(at, path_.size(), "ddn.yaml");
    return text;
  }

  std::optional<double> rate;
  std::uint32_t domain = 0;
  std::vector<std::string> interfaces{"127.0.0.1"};
  bool multicast = true;
  std::string level = "info";
  bool json = false;
  std::map<std::string, std::string> environment;

 private:
  CLI::App app_;
  std::optional<Settings> settings_;
  std::string path_;
};

TEST_F(SettingsOfAProgram, TheCommandLineWinsOverTheEnvironmentThatOverTheFileThatOverDefaults) {
  environment = {{"SKEIN_DOMAIN", "2"}, {"SKEIN_LOG_LEVEL", "warn"}};
  start({"--domain", "1"});

  EXPECT_THAT(complete("domain: 3\nlog-level: error\nrate: 20\n").all(), IsEmpty());

  EXPECT_EQ(domain, 1U);
  EXPECT_EQ(level, "warn");
  EXPECT_EQ(rate, 20);
  EXPECT_TRUE(multicast);
}

TEST_F(SettingsOfAProgram, ListsAreListsInTheFileAndHaveCommasInTheEnvironment) {
  start();
  EXPECT_THAT(complete("interface: [10.0.0.1, 10.0.0.2]\n").all(), IsEmpty());
  EXPECT_THAT(interfaces, ElementsAre("10.0.0.1", "10.0.0.2"));
}

TEST_F(SettingsOfAProgram, AVariableWithCommasIsAList) {
  environment = {{"SKEIN_INTERFACE", "10.0.0.3,10.0.0.4"}};
  start();
  EXPECT_THAT(complete().all(), IsEmpty());
  EXPECT_THAT(interfaces, ElementsAre("10.0.0.3", "10.0.0.4"));
}

TEST_F(SettingsOfAProgram, SwitchesAreWordsInTheFile) {
  start();
  EXPECT_THAT(complete("multicast: off\nlog-json: true\n").all(), IsEmpty());
  EXPECT_FALSE(multicast);
  EXPECT_TRUE(json);
}

TEST_F(SettingsOfAProgram, AnEmptyVariableIsAsGoodAsNone) {
  environment = {{"SKEIN_DOMAIN", ""}};
  start();
  EXPECT_THAT(complete("domain: 3\n").all(), IsEmpty());
  EXPECT_EQ(domain, 3U);
}

TEST_F(SettingsOfAProgram, EveryErrorIsToldAtOnceWithFileAndLine) {
  environment = {{"SKEIN_RATE", "fast"}};
  start();

  const std::string problems =
      text_of(complete("domain: 500\n\nlog-levl: info\nlog-level: [a, b]\nmulticast: {a: b}\n"));

  EXPECT_THAT(problems, HasSubstr("SKEIN_RATE: "));
  EXPECT_THAT(problems, HasSubstr("ddn.yaml:1:9: domain: "));
  EXPECT_THAT(problems, HasSubstr("ddn.yaml:3:11: log-levl: no option of this program; did you "
                                  "mean 'log-level'?"));
  EXPECT_THAT(problems, HasSubstr("ddn.yaml:4:12: log-level: 2 values where one is taken"));
  EXPECT_THAT(problems, HasSubstr("ddn.yaml:5:12: multicast: is a map; expected a value or"));
}

TEST_F(SettingsOfAProgram, AFileThatIsNotThereIsAnError) {
  start();
  complete("domain: 1\n");
  SettingsOfAProgram::environment.clear();
  CLI::App other;
  Settings settings(other, {});
  EXPECT_THAT(to_text(settings.complete([](const char*) { return nullptr; }, "/no/such.yaml")),
              HasSubstr("/no/such.yaml"));
}

TEST_F(SettingsOfAProgram, ShowsEveryValueAndWhereItCameFrom) {
  environment = {{"SKEIN_LOG_LEVEL", "warn"}};
  start({"--domain", "1"});
  complete("interface: [10.0.0.1, 10.0.0.2]\n");

  EXPECT_EQ(shown(),
            "# rate:                                 # default\n"
            "domain: 1                               # command line\n"
            "interface: [10.0.0.1, 10.0.0.2]         # ddn.yaml:1\n"
            "multicast: on                           # default\n"
            "log-level: warn                         # environment, SKEIN_LOG_LEVEL\n"
            "log-json: false                         # default\n");
}

// Law: what is shown, read as a file, gives the same values.
TEST_F(SettingsOfAProgram, WhatIsShownIsAFileOfTheSameValues) {
  start({"--domain", "7", "--interface", "10.0.0.1", "--interface", "10.0.0.2", "--log-json",
         "--log-level", "a: b # 'c'"});
  complete();
  const std::string file = shown();
  domain = 0;
  interfaces.clear();
  json = false;
  level = "";

  start();
  EXPECT_THAT(complete(file).all(), IsEmpty());

  EXPECT_EQ(domain, 7U);
  EXPECT_THAT(interfaces, ElementsAre("10.0.0.1", "10.0.0.2"));
  EXPECT_TRUE(json);
  EXPECT_EQ(level, "a: b # 'c'");
}

}  // namespace
}  // namespace skein::daemon_main
