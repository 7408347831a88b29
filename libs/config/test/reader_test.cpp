// SPDX-License-Identifier: Apache-2.0
#include "skein/config/reader.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <limits>

#include "skein/config/parse.hpp"
#include "skein/foundation/random.hpp"

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

TEST(Reader, GivesTheValueAsItWasParsedAndNothingForAnAbsentOne) {
  const auto value = parse_yaml("a: {b: \"x\"}", "f.yaml");
  Diagnostics problems;
  const Reader root(*value, "f.yaml", problems);

  EXPECT_TRUE(root.optional("a").value().find("b")->quoted);
  EXPECT_EQ(root.optional("c").value().kind, Value::Kind::kNull);
  EXPECT_TRUE(problems.empty());
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

TEST(Reader, EntriesKeepTheOrderWritten) {
  std::string order;
  const auto report = reported("{z: 1, a: 2, m: 3}", [&](const Reader& r) {
    for (const auto& [key, value] : r.entries()) order += key + std::to_string(value.integer());
  });

  EXPECT_EQ(report, "");
  EXPECT_EQ(order, "z1a2m3");
}

TEST(Reader, AnAbsentValueAnswersEveryQuestionInSilence) {
  const auto report = reported("{a: 1}", [](const Reader& r) {
    const Reader absent = r.optional("b").optional("c");
    EXPECT_FALSE(absent.present());
    EXPECT_EQ(absent.number(2.5), 2.5);
    EXPECT_EQ(absent.integer(4), 4);
    EXPECT_EQ(absent.natural(5), 5U);
    EXPECT_TRUE(absent.boolean(true));
    EXPECT_EQ(absent.text("t"), "t");
    EXPECT_EQ(absent.choice({"x", "y"}, 1), 1U);
    EXPECT_EQ(absent.name_among({"x"}, "a name"), "");
    EXPECT_TRUE(absent.numbers(2).empty());
    EXPECT_TRUE(absent.items().empty());
    EXPECT_TRUE(absent.entries().empty());
    EXPECT_FALSE(absent.keys({"x"}));
  });

  EXPECT_EQ(report, "");
}

TEST(Reader, AMissingKeyOfAMissingMapIsReportedOnce) {
  EXPECT_EQ(
      reported("{a: 1}", [](const Reader& r) { (void)r.required("b").required("c").number(); }),
      "f:1:1: b: missing\n");
}

TEST(Reader, BooleansAreTrueAndFalseOnly) {
  for (const char* text : {"yes", "no", "on", "True", "1", "~"}) {
    bool value = true;
    const auto report = reported(std::string("{x: ") + text + "}",
                                 [&](const Reader& r) { value = r.optional("x").boolean(false); });
    EXPECT_TRUE(!report.empty() || text == std::string("~")) << text;
    EXPECT_FALSE(value) << text;
  }
}

TEST(Reader, ARangeThatIsOpenOnOneSideSaysSo) {
  EXPECT_EQ(
      reported("{x: -1}",
               [](const Reader& r) {
                 (void)r.optional("x").number(0, {0, std::numeric_limits<double>::max(), "m"});
               }),
      "f:1:5: x: '-1'; expected a number of at least 0 m\n");
  EXPECT_EQ(reported("{x: 9}", [](const Reader& r) { (void)r.optional("x").integer(0, 1, 5); }),
            "f:1:5: x: '9'; expected a whole number from 1 to 5\n");
}

TEST(Reader, ExtremesOfWholeNumbersAreReadExactly) {
  const auto report =
      reported("{low: -9223372036854775808, high: 9223372036854775807, big: 18446744073709551615}",
               [](const Reader& r) {
                 EXPECT_EQ(r.optional("low").integer(), std::numeric_limits<std::int64_t>::min());
                 EXPECT_EQ(r.optional("high").integer(), std::numeric_limits<std::int64_t>::max());
                 EXPECT_EQ(r.optional("big").natural(), std::numeric_limits<std::uint64_t>::max());
               });

  EXPECT_EQ(report, "");
  EXPECT_NE(reported("{x: 18446744073709551616}",
                     [](const Reader& r) { (void)r.optional("x").natural(); }),
            "");
}

// Laws on random documents: every key that is there and unknown is reported, and none other.
TEST(ReaderLaws, ExactlyTheUnknownKeysAreReported) {
  Random random(21);
  for (int trial = 0; trial < 300; ++trial) {
    std::string text = "{";
    std::size_t unknown = 0;
    for (int k = 0; k < 6; ++k) {
      const bool known = random.chance(0.5);
      unknown += known ? 0 : 1;
      text +=
          (k > 0 ? ", " : "") + std::string(known ? "known" : "other") + std::to_string(k) + ": 1";
    }
    text += "}";
    const auto value = parse_yaml(text, "f");
    ASSERT_TRUE(value.has_value()) << text;
    Diagnostics diagnostics;

    Reader(*value, "f", diagnostics)
        .keys({"known0", "known1", "known2", "known3", "known4", "known5"});

    EXPECT_EQ(diagnostics.size(), unknown) << text;
  }
}

// A number written in plain decimal reads as the double nearest to it.
TEST(ReaderLaws, PlainDecimalsReadAsTheNearestDouble) {
  Random random(22);
  for (int trial = 0; trial < 1000; ++trial) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*g", 1 + static_cast<int>(random.below(17)),
                  random.normal() * 1e3);
    const auto report = reported(std::string("{x: ") + text + "}", [&](const Reader& r) {
      EXPECT_EQ(r.optional("x").number(), std::strtod(text, nullptr)) << text;
    });
    EXPECT_EQ(report, "");
  }
}

}  // namespace
}  // namespace skein::config
