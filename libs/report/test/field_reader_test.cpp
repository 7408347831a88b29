// SPDX-License-Identifier: Apache-2.0
#include "reading/field_reader.hpp"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <array>

namespace skein::report {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 2> kColours{"red", "green"};

/// A line of the event log with a field of each shape.
struct Shapes {
  static constexpr std::string_view kKind = "shapes";
  journal::Text text = {};
  bool truth = false;
  std::int64_t whole = 0;
  std::uint64_t id = 0;
  double number = 0;
  std::vector<double> numbers = {};
  journal::OptionalText word = {};
  journal::OptionalNumbers more = {};
  std::optional<double> figure = {};
  std::optional<std::uint64_t> other = {};

  static void fields(auto& it, auto&& each) {
    each("text", it.text);
    each("truth", it.truth);
    each("whole", it.whole);
    each("id", it.id);
    each("number", it.number);
    each("numbers", it.numbers);
    each("word", it.word);
    each("more", it.more);
    each("figure", it.figure);
    each("other", it.other);
  }
};

// Reads one field of a document and gives the faults as text.
template <class Read>
std::string faults_of(const json& document, Read read) {
  Diagnostics faults;
  FieldReader fields(document, {"f", 3, 0, "p", "", "", ""}, faults);
  read(fields);
  return to_text(faults);
}

TEST(FieldReader, GoodFieldsHaveNoFault) {
  const json document{{"t", "x"}, {"i", -4},      {"n", 1.5},      {"b", true},
                      {"u", 7U},  {"c", "green"}, {"p", {1, 2, 3}}};

  const std::string faults = faults_of(document, [](FieldReader& f) {
    EXPECT_EQ(f.text("t"), "x");
    EXPECT_EQ(f.integer("i"), -4);
    EXPECT_EQ(f.number("n"), 1.5);
    EXPECT_TRUE(f.boolean("b"));
    EXPECT_EQ(f.unsigned_integer("u"), 7U);
    EXPECT_EQ(f.one_of("c", f.text("c"), kColours), 1U);
    EXPECT_EQ(f.position("p"), (Position{1, 2, 3}));
    EXPECT_EQ(f.rest(), "");
  });

  EXPECT_EQ(faults, "");
}

TEST(FieldReader, FaultsSayFileLineAndPath) {
  EXPECT_EQ(faults_of(json::object(), [](FieldReader& f) { f.text("name"); }),
            "f:3: p.name: missing key\n");
}

TEST(FieldReader, EachTypeIsChecked) {
  const json document{{"x", json::array()}, {"s", "text"}};

  EXPECT_EQ(faults_of(document, [](FieldReader& f) { f.text("x"); }),
            "f:3: p.x: not a text; expected a string\n");
  EXPECT_EQ(faults_of(document, [](FieldReader& f) { f.name("x"); }),
            "f:3: p.x: not a name; expected a string or an integer\n");
  EXPECT_EQ(faults_of(document, [](FieldReader& f) { f.optional_text("x"); }),
            "f:3: p.x: not a text; expected a string\n");
  EXPECT_EQ(faults_of(document, [](FieldReader& f) { f.integer("s"); }),
            "f:3: p.s: not an integer; expected a 64-bit integer\n");
  EXPECT_EQ(faults_of(document, [](FieldReader& f) { f.number("s"); }),
            "f:3: p.s: not a number; expected a number\n");
  EXPECT_EQ(faults_of(document, [](FieldReader& f) { f.boolean("s"); }),
            "f:3: p.s: not a truth value; expected true or false\n");
  EXPECT_EQ(faults_of(document, [](FieldReader& f) { f.position("s"); }),
            "f:3: p.s: not a list of numbers; expected [x, y, …]\n");
  EXPECT_EQ(faults_of(document, [](FieldReader& f) { f.unsigned_integer("s"); }),
            "f:3: p.s: not an unsigned integer; expected an unsigned 64-bit integer\n");
}

TEST(FieldReader, AnUnknownWordNamesTheNearest) {
  EXPECT_EQ(
      faults_of({{"c", "gren"}}, [](FieldReader& f) { f.one_of("c", f.text("c"), kColours); }),
      "f:3: p.c: unknown value 'gren'; expected red, green; did you mean 'green'?\n");
}

TEST(FieldReader, ALongWrongWordIsCutInTheMessage) {
  const std::string faults = faults_of({{"c", std::string(100'000, 'x')}}, [](FieldReader& f) {
    f.one_of("c", f.text("c"), kColours);
  });

  EXPECT_LT(faults.size(), 300U);
}

TEST(FieldReader, NumbersHaveALimit) {
  EXPECT_EQ(faults_of({{"n", 11}}, [](FieldReader& f) { f.number("n", 10); }),
            "f:3: p.n: number out of range; expected a number\n");
  EXPECT_EQ(faults_of({{"n", -10}}, [](FieldReader& f) { f.number("n", 10); }), "");
}

TEST(FieldReader, ALineHasItsFieldsWhateverTheirOrderAndNoneThatMayBeLeftOut) {
  const json document{{"numbers", {1, 2.5}}, {"text", "x"}, {"truth", true},
                      {"whole", -4},         {"id", 7U},    {"number", 1.5}};

  const std::string faults = faults_of(document, [](FieldReader& f) {
    const auto line = f.line<Shapes>();
    EXPECT_EQ(line.text, "x");
    EXPECT_TRUE(line.truth);
    EXPECT_EQ(line.whole, -4);
    EXPECT_EQ(line.id, 7U);
    EXPECT_EQ(line.number, 1.5);
    EXPECT_EQ(line.numbers, (std::vector<double>{1, 2.5}));
    EXPECT_TRUE(line.word.empty() && line.more.empty() && !line.figure && !line.other);
    EXPECT_EQ(f.rest(), "");
  });

  EXPECT_EQ(faults, "");
}

TEST(FieldReader, WhatALineLacksOrHasInAnotherShapeIsToldOnceEach) {
  const json document{{"text", 3},
                      {"whole", 1.5},
                      {"id", -1},
                      {"number", "n"},
                      {"numbers", {"x"}},
                      {"word", false},
                      {"figure", json::array()},
                      {"other", "12x"}};

  EXPECT_EQ(faults_of(document,
                      [](FieldReader& f) {
                        f.line<Shapes>();
                        f.line<Shapes>();
                      }),
            "f:3: p.text: not a text; expected a string\n"
            "f:3: p.truth: missing key\n"
            "f:3: p.whole: not an integer; expected a 64-bit integer\n"
            "f:3: p.id: not an identifier; expected an unsigned 64-bit integer\n"
            "f:3: p.number: not a number; expected a number\n"
            "f:3: p.numbers: not a list of numbers; expected [x, y, …]\n"
            "f:3: p.word: not a text; expected a string\n"
            "f:3: p.figure: not a number; expected a number\n"
            "f:3: p.other: not an identifier; expected an unsigned 64-bit integer\n");
}

TEST(FieldReader, NullIsAbsent) {
  const json document{{"t", nullptr}};

  EXPECT_EQ(faults_of(document, [](FieldReader& f) { EXPECT_EQ(f.optional_text("t"), ""); }), "");
  EXPECT_EQ(faults_of(document, [](FieldReader& f) { EXPECT_FALSE(f.optional_number("t")); }), "");
  EXPECT_EQ(faults_of(document, [](FieldReader& f) { f.text("t"); }), "f:3: p.t: missing key\n");
}

TEST(FieldReader, WhatNobodyAskedForIsTheRest) {
  faults_of({{"a", 1}, {"b", 2}, {"c", {{"d", 3}}}}, [](FieldReader& f) {
    f.integer("b");
    EXPECT_EQ(f.rest(), R"({"a":1,"c":{"d":3}})");
  });
}

TEST(SafeDump, NeverThrowsOnBadUtf8) { EXPECT_EQ(safe_dump(json("\xff")), "\"\xEF\xBF\xBD\""); }

RC_GTEST_PROP(ParseJson, EveryDocumentWithinTheDepthIsParsed, ()) {
  const auto depth = *rc::gen::inRange<std::size_t>(1, 130);
  const std::string text = std::string(depth, '[') + std::string(depth, ']');
  Diagnostics faults;

  const bool parsed = parse_json(text, {}, faults).has_value();

  RC_ASSERT(parsed == (depth <= 64));
  RC_ASSERT(faults.empty() == parsed);
}

}  // namespace
}  // namespace skein::report
