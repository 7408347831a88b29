// SPDX-License-Identifier: Apache-2.0
#include "skein/config/reader.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "skein/config/parse.hpp"

namespace skein::config {
namespace {

// What one use of a reader over a text reports.
std::string reported(const std::string& text, const std::function<void(const Reader&)>& use) {
  const auto value = parse_yaml(text, "f");
  if (!value) return to_text(value.error());
  Diagnostics diagnostics;
  use(Reader(*value, "f", diagnostics));
  return to_text(diagnostics);
}

TEST(Reader, ReadsWhatIsThere) {
  const auto report = reported("{n: 2.5, i: -3, s: abc, b: true, l: [1, 2]}", [](const Reader& r) {
    EXPECT_EQ(r.required("n").number(), 2.5);
    EXPECT_EQ(r.required("i").integer(), -3);
    EXPECT_EQ(r.required("s").text(), "abc");
    EXPECT_TRUE(r.required("b").boolean());
    EXPECT_EQ(r.required("l").numbers(2), (std::vector<double>{1, 2}));
    EXPECT_EQ(r.optional("absent").number(7), 7);
  });

  EXPECT_EQ(report, "");
}

TEST(Reader, EveryErrorOfADocumentIsReportedAtOnce) {
  const auto report = reported("{speed: fast, colour: 1}", [](const Reader& r) {
    r.keys({"speed", "color"});
    (void)r.required("speed").number(0, {0, 10, "m/s"});
    (void)r.required("mass").number();
  });

  EXPECT_EQ(report,
            "f:1:23: colour: unknown key 'colour'; expected one of speed, color; "
            "did you mean 'color'?\n"
            "f:1:9: speed: 'fast'; expected a number from 0 to 10 m/s\n"
            "f:1:1: mass: missing\n");
}

TEST(Reader, NumbersArePlainDecimal) {
  for (const char* text : {"012", "0x10", ".inf", ".nan", "1_000", "'5'", "1e400", "- 1", "inf"}) {
    const auto report = reported(std::string("{x: ") + text + "}",
                                 [](const Reader& r) { (void)r.required("x").number(); });
    EXPECT_NE(report, "") << text;
  }
  for (const char* text : {"0", "-0.5", "+3", "1e3", ".5", "0.25"}) {
    const auto report = reported(std::string("{x: ") + text + "}",
                                 [](const Reader& r) { (void)r.required("x").number(); });
    EXPECT_EQ(report, "") << text;
  }
}

TEST(Reader, RangesAreClosed) {
  const auto at = [](double x) {
    return reported("{x: " + std::to_string(x) + "}", [](const Reader& r) {
      (void)r.required("x").number(0, {1, 2, ""});
    });
  };
  EXPECT_EQ(at(1), "");
  EXPECT_EQ(at(2), "");
  EXPECT_NE(at(2.5), "");
  EXPECT_NE(at(0.5), "");
}

TEST(Reader, WholeNumbersHaveNoFraction) {
  EXPECT_NE(reported("{x: 1.5}", [](const Reader& r) { (void)r.required("x").integer(); }), "");
  EXPECT_NE(reported("{x: -1}", [](const Reader& r) { (void)r.required("x").natural(); }), "");
  EXPECT_NE(reported("{x: 6}", [](const Reader& r) { (void)r.required("x").integer(1, 1, 5); }),
            "");
}

TEST(Reader, ChoicesNameTheNearest) {
  EXPECT_EQ(reported("{x: degres}",
                     [](const Reader& r) {
                       (void)r.required("x").choice({"degree", "rate"});
                     }),
            "f:1:5: x: 'degres'; expected one of degree, rate; did you mean 'degree'?\n");
}

TEST(Reader, NamesMustBeAmongTheKnown) {
  EXPECT_EQ(reported("{x: marvn}",
                     [](const Reader& r) {
                       EXPECT_EQ(r.required("x").name_among({"marvin", "heliv"}, "a UAV"), "");
                     }),
            "f:1:5: x: unknown name 'marvn'; expected a UAV; did you mean 'marvin'?\n");
}

TEST(Reader, AWrongKindIsSaidOnceAndReadingGoesOn) {
  EXPECT_EQ(reported("{x: [1], y: {z: 1}}",
                     [](const Reader& r) {
                       EXPECT_EQ(r.required("x").number(4), 4);
                       EXPECT_TRUE(r.required("y").items().empty());
                       EXPECT_EQ(r.required("y").numbers(2).size(), 2U);
                     }),
            "f:1:5: x: a list; expected a number\n"
            "f:1:13: y: a map where a list was expected\n"
            "f:1:13: y: a map; expected a list of 2 numbers\n");
}

TEST(Reader, PathsNameListItems) {
  EXPECT_EQ(reported("{a: [{b: x}]}",
                     [](const Reader& r) {
                       for (const Reader& item : r.required("a").items()) {
                         (void)item.required("b").number();
                       }
                     }),
            "f:1:10: a[0].b: 'x'; expected a number\n");
}

}  // namespace
}  // namespace skein::config
