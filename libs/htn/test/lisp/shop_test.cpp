// SPDX-License-Identifier: Apache-2.0
// The Lisp of the given domains. They are not part of the repository.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "testing/lisp_fixture.hpp"

namespace skein::htn {
namespace {

std::filesystem::path shop_folder() {
  const char* given = std::getenv("SKEIN_SHARED_DATA");
  return given != nullptr ? std::filesystem::path(given) / "shop"
                          : std::filesystem::path(SKEIN_SOURCE_DIR) / "../shared/data/shop";
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class LispOfShop : public ::testing::Test, protected test::LispFixture {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(shop_folder())) GTEST_SKIP() << "no " << shop_folder();
  }
  void load(const std::string& file) {
    Diagnostics errors;
    Diagnostics warnings;
    const IncludeReader none = [](const std::string&, const std::string&) {
      return Result<std::string, Failure>(failure("no includes here"));
    };
    read_definitions({file, text_of(shop_folder() / file)}, store, none, read_, errors, warnings);
    ASSERT_TRUE(errors.empty()) << to_text(errors);
    definitions = read_.functions;
    restart();
  }

  Definitions read_;
};

TEST_F(LispOfShop, TestCompareOfTheSortExampleSortsByQualityThenValue) {
  load("toy/sort-example.lisp");
  set("?keys", "((preferred . 1) (unpreferred . 3) (preferred . -2) (unpreferred . 8))");

  EXPECT_EQ(value("(sort ?keys #'test-compare)"),
            "((preferred . 1) (preferred . -2) (unpreferred . 8) (unpreferred . 3))");
  EXPECT_EQ(apply("#'test-compare", {"(preferred . 1)", "(unpreferred . 3)"}), "t");
}

TEST_F(LispOfShop, PprintTOfTheOperatorExampleHolds) {
  load("toy/apply-operator-bug.lisp");
  set("?x", "12");

  EXPECT_EQ(call("(call pprint-t (quote ?x))"), "t");
  EXPECT_EQ(call("(call = (quote ?x) 12)"), "t");
  EXPECT_EQ(call("(call variablep (quote ?x))"), "nil");
}

TEST_F(LispOfShop, FunctionsForDebuggingThatNoDomainNeedsAreLeftAlone) {
  load("ipc02-satellite-simpletime/adlsimpleTimeSat.lisp");

  EXPECT_FALSE(definitions.empty());
  EXPECT_EQ(value("(print-last-action)"), "t");
  EXPECT_EQ(value("(+ 1 2)"), "3");
}

// Times of the IPC-2002 domains as SHOP3 gives them in its first plan of pfile1.
TEST_F(LispOfShop, TimesAreThoseOfTheRecordedPlans) {
  set("?start", "1.01");
  set("?end", "14.030001");

  EXPECT_EQ(task("(!!update-track truck1 0 (call + ?start 3 0.01))"),
            "(!!update-track truck1 0 4.0200005)");
  EXPECT_EQ(value("(+ 4.0200005 10 0.01)"), "14.030001");
  EXPECT_EQ(value("(+ ?end 3 0.01)"), "17.04");
  EXPECT_EQ(value("(max 0 (+ 17.04 4 0.01))"), "21.050001");
  EXPECT_EQ(value("(+ 21.050001 10 0.01)"), "31.060001");
}

}  // namespace
}  // namespace skein::htn
