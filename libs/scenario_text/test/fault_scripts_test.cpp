// SPDX-License-Identifier: Apache-2.0
#include "skein/scenario_text/fault_scripts.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "skein/scenario/scenario.hpp"
#include "skein/scenario_text/scenario_text.hpp"

namespace skein::scenario_text {
namespace {

const std::string kFile = SKEIN_SOURCE_DIR "/scenarios/comets/confirmed.yaml";

std::string comets_text() {
  std::ifstream in(kFile);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// What is said of COMETS with these scripts, in files "1.yaml", "2.yaml" and so on.
std::string told(const std::vector<std::string>& scripts) {
  std::string text = comets_text();
  std::vector<NamedText> files{{"comets.yaml", text}};
  for (const std::string& script : scripts) {
    files.push_back({std::to_string(files.size()) + ".yaml", script});
    text = with_radio(text, script).value();
  }
  const auto read = scenario::read_scenario_text(text, kFile);
  if (read) return "";
  return to_text(as_written(read.error(), kFile, files));
}

TEST(FaultScripts, WhatIsWrongIsSaidWithTheScriptsFileAndLine) {
  EXPECT_EQ(told({"radio:\n  loss: 1.3\n"}),
            "1.yaml:2:9: radio.loss: '1.3'; expected a number from 0 to 0.99\n");
}

TEST(FaultScripts, CutsOfSeveralScriptsAreCountedInEach) {
  const std::string cut = "    - {between: [marvin, ground], from: 1, until: 2}\n";
  EXPECT_EQ(
      told({"radio:\n  cuts:\n" + cut + cut,
            "radio:\n  cuts:\n" + cut + "    - {between: [marvin, nobody], from: 1, until: 2}\n"}),
      "2.yaml:4:26: radio.cuts[1].between[1]: unknown name 'nobody'; expected a UAV or ground\n");
}

TEST(FaultScripts, AKeyIsOfTheLastThatGaveIt) {
  EXPECT_EQ(told({"radio: {capacity: -1}", "radio: {capacity: -2, loss: 0}"}),
            "2.yaml:1:19: radio.capacity: '-2'; expected a number from 1 to 1e+12 bit/s\n");
}

TEST(FaultScripts, AKeyThatThereIsNotIsNamedWhereItIs) {
  const std::string text = told({"radio:\n  links:\n    - {between: [marvin, ground], slot: x}\n"});
  EXPECT_NE(text.find("1.yaml:3:"), text.npos) << text;
  EXPECT_NE(text.find("radio.links[0].slot: unknown key 'slot'"), text.npos) << text;
}

TEST(FaultScripts, WhatIsOfAnotherFileStaysAsItIs) {
  Diagnostics errors;
  errors.add({"model.yaml", 3, 4, "mass", "'x'", "a number", ""});
  EXPECT_EQ(as_written(errors, "joined.yaml", {{"a.yaml", "radio: {}"}}).all(), errors.all());
}

TEST(FaultScripts, NoPathIsTooOdd) {
  for (const char* path : {"", ".", "[", "radio.cuts[", "radio.cuts[99]", "radio.cuts[x]",
                           "radio[0]", "a..b", "radio.cuts[99999999999999999999999]"}) {
    Diagnostics errors;
    errors.add({"joined", 1, 1, path, "wrong", "", ""});
    const auto told = as_written(errors, "joined", {{"a.yaml", "radio: {cuts: [1]}"}});
    EXPECT_EQ(told.all().at(0).file, "a.yaml") << path;
  }
}

TEST(FaultScripts, AKeyGivenTwiceIsSaid) {
  const auto problems = problems_of({{"a.yaml", "x: 1"}, {"b.yaml", "radio: {loss: 0, loss: 1}"}});
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems.all()[0].file, "b.yaml");
}

}  // namespace
}  // namespace skein::scenario_text
