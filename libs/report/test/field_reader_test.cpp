// SPDX-License-Identifier: Apache-2.0
#include "field_reader.hpp"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <array>

namespace skein::report {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 2> kColours{"red", "green"};

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
    EXPECT_EQ(f.id("u"), 7U);
    EXPECT_EQ(f.one_of("c", kColours), 1U);
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
            "f:3: p.s: not a position; expected [x, y, z] in metres\n");
  EXPECT_EQ(faults_of(document, [](FieldReader& f) { f.unsigned_integer("s"); }),
            "f:3: p.s: not an unsigned integer; expected an unsigned 64-bit integer\n");
}

TEST(FieldReader, AnUnknownWordNamesTheNearest) {
  EXPECT_EQ(faults_of({{"c", "gren"}}, [](FieldReader& f) { f.one_of("c", kColours); }),
            "f:3: p.c: unknown value 'gren'; expected red, green; did you mean 'green'?\n");
}

TEST(FieldReader, ALongWrongWordIsCutInTheMessage) {
  const std::string faults = faults_of({{"c", std::string(100'000, 'x')}},
                                       [](FieldReader& f) { f.one_of("c", kColours); });

  EXPECT_LT(faults.size(), 300U);
}

TEST(FieldReader, NumbersHaveALimit) {
  EXPECT_EQ(faults_of({{"n", 11}}, [](FieldReader& f) { f.number("n", 10); }),
            "f:3: p.n: number out of range; expected a number\n");
  EXPECT_EQ(faults_of({{"n", -10}}, [](FieldReader& f) { f.number("n", 10); }), "");
}

TEST(FieldReader, AListCountsItsElements) {
  faults_of({{"a", {1, 2, 3}}, {"i", 5}}, [](FieldReader& f) {
    EXPECT_EQ(f.count("a"), 3);
    EXPECT_EQ(f.count("i"), 5);
  });
}

TEST(FieldReader, NullIsAbsent) {
  const json document{{"t", nullptr}};

  EXPECT_EQ(faults_of(document, [](FieldReader& f) { EXPECT_EQ(f.optional_text("t"), ""); }), "");
  EXPECT_EQ(faults_of(document, [](FieldReader& f) { EXPECT_FALSE(f.optional_id("t")); }), "");
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
