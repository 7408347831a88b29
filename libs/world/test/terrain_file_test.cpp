// SPDX-License-Identifier: Apache-2.0
// Measured ground as a text file of our own.
#include "skein/world/terrain_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace skein::world {
namespace {

using ::testing::HasSubstr;

/// 4 × 3 corners, each with its number.
MeasuredTerrain numbered() {
  MeasuredTerrain measured{{36.5, -84.25, 300}, "a \"made-up\" hill", {}};
  measured.terrain = {-30, 10, 60, 70, 30, 0, {}, {}};
  for (int i = 0; i < 12; ++i) measured.terrain.elevations.push_back(i - 1.5);
  return measured;
}

std::string replaced(std::string text, const std::string& piece, const std::string& instead) {
  const std::size_t at = text.find(piece);
  if (at == std::string::npos) ADD_FAILURE() << "no '" << piece << "' in " << text;
  return text.replace(at, piece.size(), instead);
}

std::string errors_of(const std::string& text) {
  const auto read = read_terrain_file(text, "f");
  return read ? "" : to_text(read.error());
}

TEST(TerrainFile, IsAMapThatPeopleCanRead) {
  EXPECT_EQ(terrain_file_text(numbered()),
            "# Elevations at the corners of square cells [m over the origin's level]; local frame: "
            "x east, y north.\n"
            "skein_terrain: 1\n"
            "source: \"a \\\"made-up\\\" hill\"\n"
            "origin: {latitude: 36.5, longitude: -84.25, altitude: 300}\n"
            "west: -30\nsouth: 10\neast: 60\nnorth: 70\ncell: 30\n"
            "---\n"
            "6.5 7.5 8.5 9.5\n"
            "2.5 3.5 4.5 5.5\n"
            "-1.5 -0.5 0.5 1.5\n");
}

TEST(TerrainFile, IsReadAsItWasWritten) {
  const MeasuredTerrain written = numbered();
  const auto read = read_terrain_file(terrain_file_text(written), "f");
  ASSERT_TRUE(read) << to_text(read.error());

  EXPECT_EQ(read->origin, written.origin);
  EXPECT_EQ(read->source, written.source);
  EXPECT_EQ(read->terrain.elevations, written.terrain.elevations);
  EXPECT_EQ(Terrain(read->terrain).elevation(60, 70), 9.5);
}

RC_GTEST_PROP(TerrainFile, AnyGroundIsGivenBackAtMostACentimetreHigherAndNeverLower, ()) {
  MeasuredTerrain written;
  TerrainSpec& spec = written.terrain;
  spec.cell = *rc::gen::inRange(30, 400) * 0.1;
  spec.west = *rc::gen::inRange(-5000, 5000) * 0.1;
  spec.south = *rc::gen::inRange(-5000, 5000) * 0.1;
  spec.east = spec.west + *rc::gen::inRange(5, 600);
  spec.north = spec.south + *rc::gen::inRange(5, 600);
  spec.elevations = *rc::gen::container<std::vector<double>>(
      corners_of(spec).count(), rc::gen::map(rc::gen::inRange(-10'000'000, 40'000'000),
                                             [](int height) { return height * 1.01e-4; }));
  const auto read = read_terrain_file(terrain_file_text(written), "f");
  RC_ASSERT(read.has_value());
  RC_ASSERT(read->terrain.elevations.size() == spec.elevations.size());
  for (std::size_t i = 0; i < spec.elevations.size(); ++i) {
    const double higher = read->terrain.elevations[i] - spec.elevations[i];
    RC_ASSERT(higher >= -1e-7);
    RC_ASSERT(higher <= 0.01 + 1e-9);
  }
  RC_ASSERT(terrain_file_text({read->origin, read->source, read->terrain}) ==
            terrain_file_text(written));
}

TEST(TerrainFile, EveryWrongRowIsTold) {
  const std::string text = terrain_file_text(numbered());

  EXPECT_EQ(errors_of(replaced(text, "6.5 7.5 8.5 9.5", "6.5 7.5 x 1e9")),
            "f:11: 'x'; expected an elevation in metres\n"
            "f:11: '1e9'; expected an elevation in metres\n"
            "f:11: 2 elevations in a row; expected 4\n");
  EXPECT_EQ(errors_of(replaced(text, "2.5 3.5 4.5 5.5\n", "")),
            "f: 2 rows of elevations; expected 3\n");
  EXPECT_EQ(errors_of(text + "1 2 3 4\n"), "f: 4 rows of elevations; expected 3\n");
  EXPECT_EQ(errors_of(replaced(text, " 1.5", " nan")),
            "f:13: 'nan'; expected an elevation in metres\n"
            "f:13: 3 elevations in a row; expected 4\n");
}

TEST(TerrainFile, ComplaintsHaveAnEnd) {
  std::string text = terrain_file_text(numbered());
  for (int i = 0; i < 1000; ++i) text += "no elevation\n";

  EXPECT_EQ(read_terrain_file(text, "f").error().size(), 20u);
}

TEST(TerrainFile, EveryErrorOfTheHeadIsTold) {
  std::string text = replaced(terrain_file_text(numbered()), "east: 60\n", "");
  text = replaced(text, "latitude: 36.5", "latitude: 136.5");
  text = replaced(text, "cell: 30", "cel: 30");

  const std::string errors = errors_of(text);
  EXPECT_THAT(errors, HasSubstr("unknown key 'cel'"));
  EXPECT_THAT(errors, HasSubstr("did you mean 'cell'?"));
  EXPECT_THAT(errors, HasSubstr("origin.latitude: '136.5'"));
  EXPECT_THAT(errors, HasSubstr("east: missing"));
}

TEST(TerrainFile, AnotherVersionAndOtherFilesAreRefused) {
  const std::string text = terrain_file_text(numbered());

  EXPECT_THAT(errors_of(replaced(text, "skein_terrain: 1", "skein_terrain: 2")),
              HasSubstr("skein_terrain: '2'"));
  for (const std::string other : {"", "---\n", "ncols 403\nnrows 344\n", "\n---\n"})
    EXPECT_NE(errors_of(other), "") << other;
  EXPECT_THAT(errors_of("ncols 403\n"), HasSubstr("this is not a terrain file"));
}

TEST(TerrainFile, LinesOfOtherSystemsEndWithCarriageReturns) {
  std::string text = terrain_file_text(numbered());
  for (std::size_t at = text.find("---") + 4; (at = text.find('\n', at)) != std::string::npos;
       at += 2)
    text.insert(at, "\r");

  EXPECT_EQ(errors_of(text), "");
}

}  // namespace
}  // namespace skein::world
