// SPDX-License-Identifier: Apache-2.0
#include "sensor_model_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/config/parse.hpp"

namespace skein::world {
namespace {

using ::testing::HasSubstr;

const std::string kCamera = R"(aperture: 0.35
pitch: -0.6
range: 250
period: 0.5
position_spread: 3
sees: {fire: {probability: 0.9, confidence: 0.8}}
)";

struct Reading {
  SensorModel sensor;
  Diagnostics diagnostics;
};

Reading read(const std::string& text) {
  const auto document = config::parse_yaml(text, "camera.yaml");
  Reading reading;
  EXPECT_TRUE(document);
  if (document)
    reading.sensor =
        read_sensor("visible", config::Reader(*document, "camera.yaml", reading.diagnostics));
  return reading;
}

TEST(SensorModelReader, WithoutAQualityEverythingInRangeIsPerceivedEquallyForNothing) {
  const Reading reading = read(kCamera);

  EXPECT_TRUE(reading.diagnostics.empty()) << to_text(reading.diagnostics);
  EXPECT_EQ(reading.sensor.device, "visible");
  EXPECT_EQ(reading.sensor.quality, QualityModel{});
  EXPECT_EQ(reading.sensor.cost, 0);
}

TEST(SensorModelReader, ReadsTheQualityAndTheCostOfUse) {
  const Reading reading = read(
      kCamera + "quality: {best_distance: 60, at_range: 0.2, incidence_power: 1.5}\ncost: 0.1\n");

  EXPECT_TRUE(reading.diagnostics.empty()) << to_text(reading.diagnostics);
  EXPECT_EQ(reading.sensor.quality, (QualityModel{60, 0.2, 1.5}));
  EXPECT_EQ(reading.sensor.cost, 0.1);
}

TEST(SensorModelReader, EachFigureOfTheQualityHasItsRange) {
  struct Case {
    const char* path;
    const char* line;
  };
  const Case cases[] = {
      {"quality.best_distance", "quality: {best_distance: -1}"},
      {"quality.best_distance", "quality: {best_distance: 251}"},
      {"quality.best_distance", "quality: {best_distance: .nan}"},
      {"quality.at_range", "quality: {at_range: 1.01}"},
      {"quality.at_range", "quality: {at_range: -0.01}"},
      {"quality.incidence_power", "quality: {incidence_power: -1}"},
      {"quality.incidence_power", "quality: {incidence_power: 11}"},
      {"cost", "cost: 1.1"},
      {"cost", "cost: -0.1"},
      {"cost", "cost: cheap"},
      {"quality", "quality: good"},
  };
  for (const Case& c : cases) {
    const Reading reading = read(kCamera + c.line + "\n");

    ASSERT_EQ(reading.diagnostics.size(), 1u) << c.line << to_text(reading.diagnostics);
    EXPECT_EQ(reading.diagnostics.all()[0].path, c.path) << c.line;
    EXPECT_GT(reading.diagnostics.all()[0].line, 0) << c.line;
  }
}

TEST(SensorModelReader, AnUnknownKeyOfTheQualityIsRefusedWithTheNearest) {
  const Reading reading = read(kCamera + "quality: {best_distence: 60}\n");

  EXPECT_THAT(to_text(reading.diagnostics), HasSubstr("did you mean 'best_distance'?"));
}

TEST(SensorModelReader, ABadRangeIsNotBlamedOnTheBestDistance) {
  Reading reading = read(std::string(kCamera).replace(kCamera.find("250"), 3, "0  ") +
                         "quality: {best_distance: 60}\n");

  ASSERT_EQ(reading.diagnostics.size(), 1u) << to_text(reading.diagnostics);
  EXPECT_EQ(reading.diagnostics.all()[0].path, "range");
}

TEST(SensorModelReader, SaysWhatItsLooksAreWorthAndWhatItServes) {
  const Reading reading = read(kCamera +
                               "evidence: {reports: {fire: [0.8, 0.02], vehicle: [0.01, 0.2]}, "
                               "confirms: true, limit: 9}\n"
                               "serves: [detection, close-look]\n");
  ASSERT_TRUE(reading.diagnostics.empty()) << to_text(reading.diagnostics);

  ASSERT_TRUE(reading.sensor.evidence);
  EXPECT_EQ(reading.sensor.evidence->kinds.at("vehicle"), (Likelihood{0.01, 0.2}));
  EXPECT_TRUE(reading.sensor.evidence->confirms);
  EXPECT_EQ(reading.sensor.evidence->limit, 9);
  EXPECT_EQ(reading.sensor.serves, (std::vector<std::string>{"detection", "close-look"}));
}

TEST(SensorModelReader, EvidenceOfNothingIsNotTheSameAsNotSaying) {
  EXPECT_FALSE(read(kCamera).sensor.evidence);
  const Reading reading = read(kCamera + "evidence: {reports: {}}\n");
  EXPECT_TRUE(reading.diagnostics.empty()) << to_text(reading.diagnostics);
  EXPECT_TRUE(reading.sensor.evidence && reading.sensor.evidence->kinds.empty());
}

TEST(SensorModelReader, WrongEvidenceAndUsesAreTold) {
  EXPECT_THAT(to_text(read(kCamera + "evidence: {reports: {fire: [0.8]}}\n").diagnostics),
              HasSubstr("evidence.reports.fire"));
  EXPECT_THAT(to_text(read(kCamera + "evidence: {reports: {fire: [1.5, 0.1]}}\n").diagnostics),
              HasSubstr("evidence.reports.fire"));
  EXPECT_THAT(to_text(read(kCamera + "evidence: {reports: {fire: [0.6, 0.1], smoke: [0.5, 0.1]}}\n")
                          .diagnostics),
              HasSubstr("likelihoods that add up to less than 1"));
  EXPECT_THAT(to_text(read(kCamera + "serves: [Detection (now)]\n").diagnostics),
              HasSubstr("serves[0]: 'Detection (now)'"));
}

}  // namespace
}  // namespace skein::world
