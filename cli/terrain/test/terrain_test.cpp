// SPDX-License-Identifier: Apache-2.0
#include "skein/terrain_tool/terrain.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "skein/foundation/exit_code.hpp"
#include "skein/geodesy/geodetic_frame.hpp"
#include "skein/world/terrain_file.hpp"
#include "temporary_folder.hpp"

namespace skein::terrain_tool {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::string kJacksboro = SKEIN_SOURCE_DIR "/scenarios/terrain/jacksboro.asc";

class Folder {
 public:
  std::string file(const std::string& name) const { return (folder_.path() / name).string(); }

 private:
  skein::testing::TemporaryFolder folder_;
};

std::string text_in(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

struct Done {
  int code;
  std::string out, err;
};

Done make(const MakeOptions& options) {
  std::ostringstream out, err;
  const int code = make_terrain(options, out, err);
  return {code, out.str(), err.str()};
}

Done show(const ShowOptions& options) {
  std::ostringstream out, err;
  const int code = show_terrain(options, out, err);
  return {code, out.str(), err.str()};
}

/// Two kilometres of the Jacksboro fault.
MakeOptions jacksboro(const std::string& out) {
  return {kJacksboro,  out,         90, {-1000, -1000, 1000, 1000}, {36.5895, -84.246, 300},
          "EPSG:4326", std::nullopt};
}

/// Every post of the grid, read here without the reader under test, in the frame of an origin.
std::vector<world::Vector3> posts_of_jacksboro(const world::GeodeticOrigin& origin) {
  std::ifstream in(kJacksboro);
  std::string key;
  std::size_t columns = 0, rows = 0;
  double west = 0, south = 0, cell = 0, none = 0, elevation = 0;
  in >> key >> columns >> key >> rows >> key >> west >> key >> south >> key >> cell >> key >> none;
  const geodesy::GeodeticFrame frame(origin);
  std::vector<world::Vector3> posts;
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < columns && in >> elevation; ++column)
      posts.push_back(
          frame.to_local({south + (static_cast<double>(rows - row) - 0.5) * cell,
                          west + (static_cast<double>(column) + 0.5) * cell, elevation}));
  return posts;
}

TEST(TerrainMake, NoPostOfTheRasterStandsOutOfTheGroundOfTheFile) {
  const Folder folder;
  const Done done = make(jacksboro(folder.file("a.terrain")));
  ASSERT_EQ(done.code, kExitOk) << done.err;
  const auto file = world::read_terrain_file(text_in(folder.file("a.terrain")), "a");
  ASSERT_TRUE(file) << to_text(file.error());
  const world::Terrain made(file->terrain);

  int inside = 0;
  for (const world::Vector3& post : posts_of_jacksboro(file->origin)) {
    if (std::abs(post.x()) > 990 || std::abs(post.y()) > 990) continue;
    ++inside;
    ASSERT_GE(made.elevation(post.x(), post.y()), post.z() - 1e-3) << post.transpose();
  }
  EXPECT_GT(inside, 500);
}

TEST(TerrainMake, SaysWhatItMadeAndTheSameEachTime) {
  const Folder folder;
  const Done done = make(jacksboro(folder.file("a.terrain")));
  make(jacksboro(folder.file("b.terrain")));

  EXPECT_THAT(done.out, AllOf(HasSubstr("from jacksboro.asc, EPSG:4326\n"),
                              HasSubstr("origin 36.589500, -84.246000 (WGS 84), 300 m\n"),
                              HasSubstr("24 × 24 corners, 90 m apart\n"), HasSubstr("raised by")));
  EXPECT_EQ(text_in(folder.file("a.terrain")), text_in(folder.file("b.terrain")));
}

TEST(TerrainMake, WhatCannotBeReadIsRefusedAndNothingIsWritten) {
  const Folder folder;
  MakeOptions options = jacksboro(folder.file("a.terrain"));
  options.crs = "";
  EXPECT_THAT(make(options).err, HasSubstr("jacksboro.asc"));
  options.raster = folder.file("none.tif");
  EXPECT_EQ(make(options).code, kExitBadInput);
  options = jacksboro(folder.file("a.terrain"));
  options.extent = {1, 1, -1, -1};
  options.origin[0] = 91;
  EXPECT_EQ(make(options).err,
            "--extent: east must be greater than west\n"
            "--extent: north must be greater than south\n"
            "--origin: no latitude in [-90, 90]\n");

  EXPECT_FALSE(std::filesystem::exists(folder.file("a.terrain")));
}

TEST(TerrainMake, AFileThatCannotBeWrittenIsTheSystems) {
  const Folder folder;
  const Done done = make(jacksboro(folder.file("no/such/folder.terrain")));

  EXPECT_EQ(done.code, kExitSystem);
  EXPECT_THAT(done.err, HasSubstr("cannot be written"));
}

TEST(TerrainShow, SaysWhatIsInAFileAndDrawsIt) {
  const Folder folder;
  make(jacksboro(folder.file("a.terrain")));
  const Done done = show({folder.file("a.terrain"), folder.file("a.svg")});

  EXPECT_EQ(done.code, kExitOk) << done.err;
  EXPECT_THAT(done.out, AllOf(HasSubstr("x -1000 to 1000 m"), HasSubstr("slopes up to")));
  EXPECT_THAT(text_in(folder.file("a.svg")), AllOf(StartsWith("<svg"), HasSubstr("a.terrain")));
}

TEST(TerrainShow, OtherFilesAreRefused) {
  EXPECT_THAT(show({kJacksboro, ""}).err, HasSubstr("this is not a terrain file"));
  EXPECT_EQ(show({"nowhere.terrain", ""}).err, "nowhere.terrain: cannot be read\n");
}

/// The file that scenarios name is the one that this raster gives.
TEST(TerrainFiles, OfScenariosAreFresh) {
  const Folder folder;
  ASSERT_EQ(make({kJacksboro,
                  folder.file("jacksboro.terrain"),
                  60,
                  {-2400, -2400, 2400, 2400},
                  {36.5895, -84.246, 300},
                  "EPSG:4326",
                  std::nullopt})
                .code,
            kExitOk);

  EXPECT_TRUE(text_in(folder.file("jacksboro.terrain")) ==
              text_in(SKEIN_SOURCE_DIR "/scenarios/terrain/jacksboro.terrain"))
      << "skein terrain make scenarios/terrain/jacksboro.asc --crs EPSG:4326 --cell 60 --origin "
         "36.5895 -84.246 300 --extent -2400 -2400 2400 2400 --out "
         "scenarios/terrain/jacksboro.terrain";
}

}  // namespace
}  // namespace skein::terrain_tool
