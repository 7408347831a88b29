// SPDX-License-Identifier: Apache-2.0
// What people see: each golden/NAME.lisp with the errors and warnings in golden/NAME.txt. To write
// the texts anew: SKEIN_UPDATE_GOLDEN=1 skein_htn_test --gtest_filter='*Golden*'.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "testing/reader_fixture.hpp"

namespace skein::htn {
namespace {

namespace fs = std::filesystem;

const fs::path kGolden = fs::path(SKEIN_SOURCE_DIR) / "libs/htn/test/golden";

std::string contents(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string shown(const std::string& name) {
  const std::string text = contents(kGolden / (name + ".lisp"));
  testing::ReaderFixture reader;
  reader.read(text, name + ".lisp");
  std::string out;
  for (const Diagnostic& error : reader.errors.all()) out += "error: " + underlined(error, text);
  for (const Diagnostic& one : reader.warnings.all()) out += "warning: " + underlined(one, text);
  return out;
}

class ReaderGolden : public ::testing::TestWithParam<const char*> {};

TEST_P(ReaderGolden, ShowsTheTextOfTheFile) {
  const std::string name = GetParam();
  const std::string found = shown(name);
  const fs::path expected = kGolden / (name + ".txt");

  ASSERT_NE(contents(kGolden / (name + ".lisp")), "");
  if (std::getenv("SKEIN_UPDATE_GOLDEN") != nullptr) std::ofstream(expected) << found;
  EXPECT_EQ(found, contents(expected));
}

INSTANTIATE_TEST_SUITE_P(Files, ReaderGolden,
                         ::testing::Values("reader-parentheses", "reader-lexical", "reader-items",
                                           "reader-conditions", "reader-tasks", "reader-problems",
                                           "reader-pddl", "reader-warnings"),
                         [](const auto& test) {
                           std::string name = test.param;
                           name[name.find('-')] = '_';
                           return name;
                         });

}  // namespace
}  // namespace skein::htn
