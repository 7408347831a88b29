// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

#include "skein/manual/pages.hpp"

namespace skein::manual {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;

class Manual : public ::testing::Test {
 protected:
  Manual() : app_("Weaves, and winds", "loom") {
    app_.set_version_flag("--version", "1");
    CLI::App* weave = app_.add_subcommand("weave", "Make cloth");
    weave->add_option("pattern", pattern_, "The .pattern of it")->required();
    weave->add_option("-n,--count", count_, "How many")->capture_default_str();
    weave->add_option("--yarn", yarn_, "Of what")->check(CLI::IsMember({"silk", "wool"}));
    weave->add_flag("--fast", fast_, "Don't wait\\rest");
    weave->add_option("--secret", yarn_, "Hidden")->group("");
    weave->footer("\nExamples:\n.weave 'x'");
    CLI::App* wind = app_.add_subcommand("wind", "Wind");
    wind->add_subcommand("up", "Upwards")->add_flag("--high", fast_, "Higher");
  }
  Command command() const { return command_of(app_); }

  CLI::App app_;
  std::string pattern_, yarn_;
  int count_ = 3;
  bool fast_ = false;
};

TEST_F(Manual, ACommandIsWhatItsDefinitionSays) {
  const Command program = command();

  ASSERT_THAT(program.commands, SizeIs(2));
  const Command& weave = program.commands[0];
  EXPECT_EQ(weave.path, "loom weave");
  ASSERT_THAT(weave.options, SizeIs(5)) << "--help too, what is hidden not";
  EXPECT_TRUE(weave.options[1].positional);
  EXPECT_TRUE(weave.options[1].required);
  EXPECT_THAT(weave.options[2].names, ElementsAre("--count", "-n"));
  EXPECT_EQ(weave.options[2].usual, "3");
  EXPECT_THAT(weave.options[3].choices, ElementsAre("silk", "wool"));
  EXPECT_EQ(weave.options[4].value, "") << "a flag";
  EXPECT_EQ(program.commands[1].commands[0].path, "loom wind up");
}

TEST_F(Manual, ThereIsAPageOfTheProgramAndOfEachCommand) {
  const auto pages = man_pages(command(), "loom 1");

  ASSERT_THAT(pages, SizeIs(3));
  EXPECT_EQ(pages[0].file, "loom.1");
  EXPECT_EQ(pages[1].file, "loom-weave.1");
  EXPECT_EQ(pages[2].file, "loom-wind.1");
  EXPECT_THAT(pages[0].text, HasSubstr("\\fBloom\\-weave\\fR(1)\nMake cloth"));
  EXPECT_THAT(pages[2].text, HasSubstr(".SS loom wind up\n"));
  EXPECT_THAT(pages[2].text, HasSubstr("\\fB\\-\\-high\\fR\nHigher"));
}

TEST_F(Manual, AProgramWithoutCommandsIsOnePage) {
  CLI::App daemon("Runs", "loomd");
  const auto pages = man_pages(command_of(daemon), "loom 1", 8);

  ASSERT_THAT(pages, SizeIs(1));
  EXPECT_EQ(pages[0].file, "loomd.8");
}

TEST_F(Manual, WhatLooksLikeARequestIsText) {
  const std::string text = man_pages(command(), "loom 1")[1].text;

  EXPECT_THAT(text, HasSubstr("\nThe .pattern of it"));
  EXPECT_THAT(text, HasSubstr("\n\\&.weave 'x'\n"));
  EXPECT_THAT(text, HasSubstr("Don't wait\\erest"));
  EXPECT_THAT(text, HasSubstr("(one of silk, wool)"));
  EXPECT_THAT(text, HasSubstr("How many [default: 3]"));
}

TEST_F(Manual, ScriptsOfShellsQuoteWhatTheySay) {
  EXPECT_THAT(fish_completion(command()), HasSubstr("-l fast -d 'Don'\\''t wait\\rest'"));
  EXPECT_THAT(zsh_completion(command()), HasSubstr("--fast[Don'\\''t wait\\\\rest]"));
}

TEST_F(Manual, WhatIsHiddenIsNowhere) {
  for (const char* shell : {"bash", "zsh", "fish"})
    EXPECT_THAT(completion(command(), shell), Not(HasSubstr("secret"))) << shell;
  for (const Page& page : man_pages(command(), "loom 1"))
    EXPECT_THAT(page.text, Not(HasSubstr("secret")));
}

TEST_F(Manual, AnotherShellHasNoScript) { EXPECT_EQ(completion(command(), "tcsh"), ""); }

}  // namespace
}  // namespace skein::manual
