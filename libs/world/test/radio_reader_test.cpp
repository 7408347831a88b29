// SPDX-License-Identifier: Apache-2.0
#include "skein/world/radio_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/config/parse.hpp"

namespace skein::world {
namespace {

using ::testing::HasSubstr;

/// A text that stays as long as what reads it.
class Text {
 public:
  explicit Text(const std::string& text) : value_(*config::parse_yaml(text, "r.yaml")) {}
  config::Reader reader() { return {value_, "r.yaml", diagnostics_}; }
  std::string report() const { return to_text(diagnostics_); }

 private:
  config::Value value_;
  Diagnostics diagnostics_;
};

std::string report(const std::string& said) {
  Text text(said);
  read_radio(text.reader());
  return text.report();
}

TEST(RadioReader, ReadsARangeAndAllThatGoesWithIt) {
  Text text("{range: 800, line_of_sight: false, latency: 0.1, loss: 0.2, hysteresis: 0.1}");

  const RadioModel radio = read_radio(text.reader());

  EXPECT_EQ(radio, (RadioModel{800, false, Duration::milliseconds(100), 0.2, 0.1}));
  EXPECT_EQ(text.report(), "");
}

TEST(RadioReader, WhatIsNotSaidHasItsDefault) {
  Text text("{a: 1}");
  const RadioModel usual = {10'000, true, Duration::milliseconds(20), 0, 0.05};

  EXPECT_EQ(read_radio(text.reader().optional("radio")), usual);
  EXPECT_EQ(text.report(), "");
}

TEST(RadioReader, ABudgetTakesThePlaceOfTheRange) {
  Text text("{power: 27, sensitivity: -95, reference_loss: 41, exponent: 2.5}");

  const RadioModel radio = read_radio(text.reader());

  EXPECT_EQ(radio.budget, (LinkBudget{27, -95, 41, 2.5}));
  EXPECT_EQ(radio.reach(), radio.budget->range());
  EXPECT_EQ(text.report(), "");
}

TEST(RadioReader, ABudgetIsWholeAndAlone) {
  EXPECT_THAT(report("{power: 27, sensitivity: -95, range: 100}"),
              HasSubstr("range: a range beside a link budget"));
  EXPECT_THAT(report("{exponent: 2}"), HasSubstr("exponent: exponent without power"));
  EXPECT_THAT(report("{power: 27}"), HasSubstr("sensitivity: missing"));
}

TEST(RadioReader, ABudgetThatReachesNobodyIsRefused) {
  EXPECT_THAT(report("{power: 0, sensitivity: 0}"), HasSubstr("nothing to receive at 1 m"));
}

TEST(RadioReader, FiguresOutOfTheirRangeAreRefused) {
  for (const char* figure : {"range: 0", "latency: -1", "loss: 1", "hysteresis: 2"})
    EXPECT_THAT(report("{" + std::string(figure) + "}"), HasSubstr("expected a number from"))
        << figure;
}

TEST(RadioReader, OnlyTheKeysOfTheCallerMayStandBesideItsOwn) {
  Text text("{range: 100, cuts: [], cutz: []}");

  EXPECT_EQ(read_radio(text.reader(), "cuts").range, 100);

  EXPECT_THAT(text.report(), HasSubstr("unknown key 'cutz'"));
  EXPECT_THAT(text.report(), HasSubstr("hysteresis, cuts; did you mean 'cuts'?"));
  EXPECT_THAT(report("{cuts: []}"), HasSubstr("unknown key 'cuts'"));
}

}  // namespace
}  // namespace skein::world
