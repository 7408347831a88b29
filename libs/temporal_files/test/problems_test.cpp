// SPDX-License-Identifier: Apache-2.0
#include "problems.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

namespace skein::temporal {
namespace {

using ::testing::HasSubstr;

TEST(NameProblem, AcceptsTextOfAnyScript) {
  for (const char* name : {"a", "v0", "a b", "é∞→", "地図", "\xF0\x9F\x9A\x81", "#'\"<&\\"}) {
    EXPECT_EQ(name_problem(name), "") << name;
  }
  EXPECT_EQ(name_problem(std::string(256, 'x')), "");
}

TEST(NameProblem, RefusesWhatIsEmptyLongOrHarmful) {
  EXPECT_EQ(name_problem(""), "an empty name");
  EXPECT_THAT(name_problem(std::string(257, 'x')), HasSubstr("longer than 256 bytes"));
  for (const char* name : {"\n", "a\tb", "\x1b[31m", "\x7F", "\xC2\x9B"}) {
    EXPECT_THAT(name_problem(name), HasSubstr("control characters")) << name;
  }
}

TEST(NameProblem, RefusesWhatIsNotUtf8) {
  // A lone continuation, a cut character, overlong forms, a surrogate, beyond the last character,
  // noncharacters.
  for (const char* name :
       {"\x80", "\xC3", "\xE2\x88", "\xC0\xAF", "\xE0\x80\xAF", "\xF0\x80\x80\xAF", "\xED\xA0\x80",
        "\xF4\x90\x80\x80", "\xFF", "\xEF\xBF\xBF", "\xEF\xBF\xBE"}) {
    EXPECT_THAT(name_problem(name), HasSubstr("not UTF-8")) << name;
  }
}

TEST(InQuotes, CutsLongTextsBetweenCharacters) {
  std::string text;
  for (int i = 0; i < 100; ++i) text += "é";

  const std::string quoted = in_quotes(text);

  EXPECT_LE(quoted.size(), 70U);
  EXPECT_TRUE(quoted.ends_with("é…'"));
}

RC_GTEST_PROP(InQuotes, GivesPrintableUtf8OfAnyBytes, ()) {
  const auto text = *rc::gen::arbitrary<std::string>();

  RC_ASSERT(name_problem(in_quotes(text)) == "");
}

TEST(Problems, OffersTheNearestOfAFewCandidates) {
  Problems problems("plan.json");

  problems.add_unknown({2, 3, "arcs[0]"}, "node", "strat", {"end", "start"});

  EXPECT_EQ(to_text(problems.take().all().front()),
            "plan.json:2:3: arcs[0]: unknown node 'strat'; did you mean 'start'?");
}

TEST(Problems, SearchesNoNearestAmongVeryMany) {
  Problems problems("");

  problems.add_unknown({}, "node", "strat", std::vector<std::string>(5000, "start"));

  EXPECT_EQ(problems.take().all().front().nearest, "");
}

TEST(Problems, AnnouncesWhatItDoesNotKeep) {
  Problems problems("");
  for (std::size_t i = 0; i < Problems::kMost; ++i) problems.add({}, "wrong");
  EXPECT_FALSE(problems.full());

  problems.add({}, "one more");
  problems.add({}, "and one");

  EXPECT_TRUE(problems.full());
  const Diagnostics found = problems.take();
  EXPECT_EQ(found.size(), Problems::kMost + 1);
  EXPECT_EQ(found.all().back().message, "more errors, not shown");
}

}  // namespace
}  // namespace skein::temporal
