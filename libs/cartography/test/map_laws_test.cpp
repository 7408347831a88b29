// SPDX-License-Identifier: Apache-2.0
// Where things stand on a map: every layer against one reckoning of metres to pixels, read back
// from the text of the picture.
#include "skein/cartography/map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <regex>

#include "drawing.hpp"
#include "palette.hpp"
#include "skein/foundation/random.hpp"

namespace skein::cartography {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using world::Vector2;
using world::Vector3;

world::World level_world(double height = 20) {
  world::TerrainSpec spec;
  spec.west = spec.south = -500;
  spec.east = spec.north = 500;
  spec.base = height;
  return {.origin = {},
          .terrain = world::Terrain(spec),
          .wind = {},
          .airspace = {},
          .volumes = {},
          .ground = {},
          .radio = {},
          .zones = {},
          .places = {}};
}

std::vector<double> numbers(const std::string& text) {
  static const std::regex kNumber(R"(-?[0-9]+(\.[0-9]+)?)");
  std::vector<double> found;
  for (std::sregex_iterator at(text.begin(), text.end(), kNumber), end; at != end; ++at)
    found.push_back(std::stod(at->str()));
  return found;
}

/// What the pattern's first group matches, each time.
std::vector<std::string> found(const std::string& svg, const std::string& pattern) {
  const std::regex wanted(pattern);
  std::vector<std::string> out;
  for (std::sregex_iterator at(svg.begin(), svg.end(), wanted), end; at != end; ++at)
    out.push_back((*at)[1]);
  return out;
}

/// A map of a drawn frame, and metres to pixels reckoned by hand: the frame fills 860 by 660.
class MapOfAFrame {
 public:
  explicit MapOfAFrame(std::uint64_t seed) : random(seed), frame(drawn(random)) {
    const double width = frame.east - frame.west, height = frame.north - frame.south;
    per_metre = std::min(860 / width, 660 / height);
  }

  Random random;
  world::World world = level_world();
  Frame frame;
  double per_metre = 1;
  Map map{world, frame};

  Vector2 anywhere() {
    return {random.uniform(frame.west, frame.east), random.uniform(frame.south, frame.north)};
  }
  Vector3 in_the_air() {
    const Vector2 at = anywhere();
    return {at.x(), at.y(), random.uniform(30, 200)};
  }
  void expect_at(double x, double y, const Vector2& at) const {
    EXPECT_NEAR(x, (at.x() - frame.west) * per_metre, 0.051);
    EXPECT_NEAR(y, (frame.north - at.y()) * per_metre, 0.051);
  }
  std::string svg() const { return map.finish("title", {}); }

 private:
  static Frame drawn(Random& random) {
    const double west = random.uniform(-400, 0), south = random.uniform(-400, 0);
    return {west, south, west + random.uniform(100, 400), south + random.uniform(100, 400)};
  }
};

template <class Law>
void on_drawn_maps(const Law& law) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    MapOfAFrame drawn(seed);
    law(drawn);
  }
}

// ---- layers ---------------------------------------------------------------------------------

TEST(MapLayers, PutMarkersWhereTheyAre) {
  on_drawn_maps([](MapOfAFrame& drawn) {
    std::vector<Vector2> places;
    for (int count = 0; count < 5; ++count) {
      places.push_back(drawn.anywhere());
      drawn.map.marker(places.back(), "#123456", "");
    }
    const auto circles =
        found(drawn.svg(), R"re(<circle (cx="[^"]*" cy="[^"]*") r="4" fill="#123456")re");
    ASSERT_EQ(circles.size(), places.size());
    for (std::size_t at = 0; at < places.size(); ++at)
      drawn.expect_at(numbers(circles[at])[0], numbers(circles[at])[1], places[at]);
  });
}

TEST(MapLayers, DrawAreasCornerByCorner) {
  on_drawn_maps([](MapOfAFrame& drawn) {
    const world::Polygon polygon{drawn.anywhere(), drawn.anywhere(), drawn.anywhere(),
                                 drawn.anywhere()};
    drawn.map.area(polygon, {.colour = "#abcdef", .opacity = 0.25, .dashed = true, .label = "a&b"});
    const std::string svg = drawn.svg();

    const auto drawn_points =
        found(svg, R"re(<polygon points="([^"]*)" fill="#abcdef" fill-opacity="0.25")re");
    ASSERT_EQ(drawn_points.size(), 1U);
    const std::vector<double> at = numbers(drawn_points[0]);
    ASSERT_EQ(at.size(), 8U);
    for (std::size_t corner = 0; corner < 4; ++corner)
      drawn.expect_at(at[2 * corner], at[2 * corner + 1], polygon[corner]);
    EXPECT_THAT(svg, AllOf(HasSubstr("stroke-dasharray"), HasSubstr(">a&amp;b</text>")));
  });
}

TEST(MapLayers, DrawStripsAsWideAsTheirSwath) {
  on_drawn_maps([](MapOfAFrame& drawn) {
    const Vector2 from = drawn.anywhere(), to = drawn.anywhere();
    const double swath = drawn.random.uniform(5, 80);
    drawn.map.strip(from, to, swath, "#00ff00");

    const auto paths = found(
        drawn.svg(),
        R"re(<path d="(M[^"]*" stroke="#)00ff00" stroke-opacity="0.16" stroke-width="[^"]*")re");
    const auto widths = found(drawn.svg(), R"re(stroke-opacity="0.16" stroke-width="([^"]*)")re");
    ASSERT_EQ(paths.size(), 1U);
    const std::vector<double> ends = numbers(paths[0]);
    drawn.expect_at(ends[0], ends[1], from);
    drawn.expect_at(ends[2], ends[3], to);
    EXPECT_NEAR(std::stod(widths.at(0)), swath * drawn.per_metre, 0.051);
  });
}

TEST(MapLayers, PutArrowsOnAWayEveryNinetyPixelsInItsDirection) {
  on_drawn_maps([](MapOfAFrame& drawn) {
    const refiners::Way way{drawn.in_the_air(), drawn.in_the_air(), drawn.in_the_air()};
    drawn.map.way(way, "#0000ff");
    double length = 0;
    for (std::size_t leg = 1; leg < way.size(); ++leg)
      length += (way[leg] - way[leg - 1]).head<2>().norm() * drawn.per_metre;

    const auto arrows =
        found(drawn.svg(), R"re(<path d="M-5,-4[^>]*fill="#0000ff"[^>]*transform="([^"]*)")re");
    ASSERT_EQ(arrows.size(), static_cast<std::size_t>(std::floor((length + 45) / 90)));
    for (const std::string& arrow : arrows) {
      // On one of the legs, and turned as it is.
      const std::vector<double> at = numbers(arrow);
      double off = 1e9;
      for (std::size_t leg = 1; leg < way.size(); ++leg) {
        const Vector2 from((way[leg - 1].x() - drawn.frame.west) * drawn.per_metre,
                           (drawn.frame.north - way[leg - 1].y()) * drawn.per_metre);
        const Vector2 to((way[leg].x() - drawn.frame.west) * drawn.per_metre,
                         (drawn.frame.north - way[leg].y()) * drawn.per_metre);
        const Vector2 along = (to - from).normalized(), here = Vector2(at[0], at[1]) - from;
        const double turn = std::atan2(along.y(), along.x()) * 180 / std::numbers::pi;
        if (std::abs(turn - at[2]) > 0.06) continue;
        off = std::min(off, std::abs(along.x() * here.y() - along.y() * here.x()));
      }
      EXPECT_LT(off, 0.2);
    }
  });
}

TEST(MapLayers, PutFewerArrowsOnAThinWay) {
  MapOfAFrame drawn(1);
  const double y = (drawn.frame.south + drawn.frame.north) / 2;
  const double metres = 500 / drawn.per_metre;
  const refiners::Way way{{drawn.frame.west, y, 50}, {drawn.frame.west + metres, y, 50}};
  drawn.map.way(way, "#111111", 2);
  drawn.map.way(way, "#222222", 1.4);

  // At 45, 135, … 495 pixels; at 120 and 360.
  EXPECT_EQ(found(drawn.svg(), R"re((<path d="M-5,-4[^>]*fill="#111111"))re").size(), 6U);
  EXPECT_EQ(found(drawn.svg(), R"re((<path d="M-5,-4[^>]*fill="#222222"))re").size(), 2U);
}

TEST(MapLayers, OpenAConeByItsApertureOnEitherSide) {
  on_drawn_maps([](MapOfAFrame& drawn) {
    const Vector3 from = drawn.in_the_air(), to = drawn.in_the_air();
    const double aperture = drawn.random.uniform(0.1, 1.2);
    drawn.map.cone(from, to, aperture, "#0f0f0f");

    const std::vector<double> at = numbers(
        found(drawn.svg(), R"re(<polygon points="([^"]*)" fill="#0f0f0f" fill-opacity="0.18")re")
            .at(0));
    ASSERT_EQ(at.size(), 6U);
    drawn.expect_at(at[0], at[1], from.head<2>());
    const Vector2 tip(at[0], at[1]), left(at[2], at[3]), right(at[4], at[5]);
    drawn.expect_at((left.x() + right.x()) / 2, (left.y() + right.y()) / 2, to.head<2>());
    const double deep = ((left + right) / 2 - tip).norm();
    EXPECT_NEAR((left - right).norm() / 2, deep * std::tan(aperture), 0.2);
    EXPECT_NEAR((left - tip).norm(), (right - tip).norm(), 0.2);
  });
}

TEST(MapLayers, DrawEachCellOfAGridInItsPlace) {
  on_drawn_maps([](MapOfAFrame& drawn) {
    const world::Grid grid{drawn.frame.west + 10, drawn.frame.south + 20, 5, 7, 4};
    drawn.map.heat(grid, std::vector<double>(grid.size(), 0.5), {.title = "visits", .high = 8});
    const std::string svg = drawn.svg();

    const std::vector<double> at = numbers(
        found(svg,
              R"re(<image (x="[^"]*" y="[^"]*" width="[^"]*" height="[^"]*") opacity="0.75")re")
            .at(0));
    drawn.expect_at(at[0], at[1], {grid.west, grid.south + 4 * 5});
    EXPECT_NEAR(at[2], 7 * 5 * drawn.per_metre, 0.051);
    EXPECT_NEAR(at[3], 4 * 5 * drawn.per_metre, 0.051);
    EXPECT_THAT(svg,
                AllOf(HasSubstr(">visits</text>"), HasSubstr(">0</text>"), HasSubstr(">8</text>")));
  });
}

TEST(MapLayers, LeaveCellsWithoutValueTransparent) {
  MapOfAFrame drawn(2);
  const world::Grid grid{0, 0, 5, 2, 1};
  const double none = std::nan("");
  const auto picture = [&](double one, double other) {
    Map map(drawn.world, drawn.frame);
    map.heat(grid, {one, other}, {});
    return map.finish("", {});
  };

  EXPECT_NE(picture(none, 1), picture(0, 1));
  EXPECT_EQ(picture(7, 1), picture(1, 1)) << "beyond the scale is its end";
}

TEST(MapLayers, DrawTheFirstCellOfAGridInTheSouthWest) {
  MapOfAFrame drawn(2);
  const double none = std::nan("");
  drawn.map.heat({0, 0, 5, 2, 2}, {1, none, none, 0.5}, {});

  drawing::Pixels pixels(2, 2);
  pixels.set(0, 1, heat_tint(1));
  pixels.set(1, 0, heat_tint(0.5));
  EXPECT_THAT(drawn.svg(), HasSubstr(png_uri(pixels)));
}

TEST(MapLayers, NameALinkInItsMiddle) {
  MapOfAFrame drawn(3);
  const Vector3 a = drawn.in_the_air(), b = drawn.in_the_air();
  drawn.map.link(a, b, "#010203", "12 dB");

  const std::string svg = drawn.svg();
  const std::vector<double> line =
      numbers(found(svg, R"re(<path d="([^"]*)" stroke="#010203" stroke-width="1.8")re").at(0));
  drawn.expect_at(line[0], line[1], a.head<2>());
  drawn.expect_at(line[2], line[3], b.head<2>());
  const std::vector<double> label =
      numbers(found(svg, R"re(<text (x="[^"]*" y="[^"]*")[^>]*>12 dB<)re").at(0));
  EXPECT_NEAR(label[0], (line[0] + line[2]) / 2, 0.2);
}

// ---- closed air -----------------------------------------------------------------------------

TEST(ClosedAir, IsNamedWithItsLevelsAndTimesWhereItHasThem) {
  const Frame frame{-100, -100, 100, 100};
  const world::World world = level_world();
  const auto words = [&](world::Volume volume) {
    volume.name = "smoke";
    volume.polygon = {{-50, -50}, {50, -50}, {50, 50}, {-50, 50}};
    Map map(world, frame);
    map.closed({volume});
    return found(map.finish("", {}), R"re(>(smoke[^<]*)</text>)re").at(0);
  };
  world::Volume low, high, later, now, between;
  low.ceiling = 120.4;
  high.floor = 60;
  later.when.from = MissionTime::seconds(30);
  now.when.until = MissionTime::seconds(90);
  between.floor = 10;
  between.ceiling = 20;
  between.when = {MissionTime::seconds(5), MissionTime::seconds(6)};

  EXPECT_EQ(words({}), "smoke");
  EXPECT_EQ(words(low), "smoke …–120 m");
  EXPECT_EQ(words(high), "smoke 60–… m");
  EXPECT_EQ(words(later), "smoke from 30 s");
  EXPECT_EQ(words(now), "smoke from 0 s to 90 s");
  EXPECT_EQ(words(between), "smoke 10–20 m from 5 s to 6 s");
}

TEST(ClosedAir, WhoseMiddleIsNotOnTheMapHasNoName) {
  const world::World world = level_world();
  world::Volume volume;
  volume.name = "smoke";
  volume.polygon = {{-300, -50}, {50, -50}, {50, 50}, {-300, 50}};
  Map map(world, {-100, -100, 100, 100});
  map.closed({volume});

  EXPECT_THAT(map.finish("", {}),
              AllOf(HasSubstr("url(#closed)\" stroke="), Not(HasSubstr("smoke"))));
}

// ---- frames ---------------------------------------------------------------------------------

TEST(Frames, ShowAllPointsAndAreNeitherNarrowNorFlat) {
  const world::World world = level_world();
  Random random(4);
  for (int count = 0; count < 200; ++count) {
    FrameBuilder builder;
    std::vector<Vector2> points;
    const double spread = std::pow(10, random.uniform(0, 3.2));
    for (std::uint64_t left = 1 + random.below(5); left > 0; --left) {
      points.emplace_back(random.uniform(-spread, spread), random.uniform(-spread, spread));
      if (count % 4 > 1) points.back()[count % 2] /= 8;  // flat ones, tall ones
      builder.add(points.back());
    }
    const Frame frame = builder.frame(world.terrain);
    const double width = frame.east - frame.west, height = frame.north - frame.south;

    EXPECT_GE(width, 100 - 1e-9);
    EXPECT_GE(height, width / 3 - 1e-9);
    EXPECT_GE(width, height / 3 - 1e-9);
    for (const Vector2& point : points) {
      EXPECT_GE(point.x(), frame.west);
      EXPECT_LE(point.x(), frame.east);
      EXPECT_GE(point.y(), frame.south);
      EXPECT_LE(point.y(), frame.north);
    }
  }
}

TEST(Frames, OfNothingOrOfNoNumbersAreTheWholeTerrain) {
  const world::World world = level_world();
  FrameBuilder builder;
  builder.add(Vector2(std::nan(""), 0));

  const Frame frame = builder.frame(world.terrain);

  EXPECT_EQ(frame.west, -500);
  EXPECT_EQ(frame.east, 500);
  EXPECT_EQ(frame.south, -500);
  EXPECT_EQ(frame.north, 500);
}

// ---- what stands around the map -------------------------------------------------------------

TEST(Ticks, AreTheLeastRoundStepOfFewEnough) {
  Random random(5);
  for (int count = 0; count < 300; ++count) {
    const double span = std::pow(10, random.uniform(-2, 5)), ticks = 2 + random.uniform(0, 10);
    double least = 0;  // by trying every round step from below
    for (int power = -6; power < 7 && least == 0; ++power)
      for (const double factor : {1.0, 2.0, 5.0})
        if (least == 0 && span / (factor * std::pow(10, power)) <= ticks)
          least = factor * std::pow(10, power);

    EXPECT_NEAR(tick_step(span, ticks) / least, 1, 1e-9) << span << " " << ticks;
  }
}

TEST(ScaleBar, IsARoundLengthOfAtMostAQuarterOfTheMap) {
  on_drawn_maps([](MapOfAFrame& drawn) {
    const std::string svg = drawn.svg();
    const double metres = std::stod(found(svg, R"re(>([0-9]+) m</text>)re").at(0));
    const double pixels =
        numbers(found(svg, R"re(<path d="(M12.0 [^"]*)" fill="none")re").at(0)).at(3);

    EXPECT_NEAR(pixels, metres * drawn.per_metre, 0.051);
    EXPECT_LE(metres, (drawn.frame.east - drawn.frame.west) / 4);
    EXPECT_GT(2.5 * metres, (drawn.frame.east - drawn.frame.west) / 4);
  });
}

TEST(Legend, WrapsItsLinesAndThePictureGrowsWithThem) {
  const world::World world = level_world();
  const auto height = [&](int lines) {
    Map map(world, {-100, -100, 100, 100});
    for (int line = 0; line < lines; ++line) map.legend("#000000", "a line of the legend");
    const std::string svg = map.finish("", {});
    return numbers(found(svg, R"re(<svg [^>]* height="([^"]*)")re").at(0)).at(0);
  };
  // 34 + 0.6 * 11 * 20 = 166 px a line; the map is 660 px wide: three in a row.
  EXPECT_NEAR(height(1) - height(0), 18, 0.01);
  EXPECT_NEAR(height(3) - height(0), 18, 0.01);
  EXPECT_NEAR(height(4) - height(0), 36, 0.01);
  EXPECT_NEAR(height(7) - height(0), 54, 0.01);
}

TEST(Titles, ComeWithTheLinesUnderThemAndWithoutEmptyOnes) {
  const world::World world = level_world();
  const Map map(world, {-100, -100, 100, 100});

  EXPECT_EQ(map.finish("a", {"", ""}), map.finish("a", {}));
  EXPECT_THAT(map.finish("a < b", {"one", "two"}),
              AllOf(HasSubstr(">a &lt; b</text>"), HasSubstr(">one</text>"),
                    HasSubstr(">two</text>"), HasSubstr("level ground at 20 m")));
}

// ---- profiles -------------------------------------------------------------------------------

std::vector<Vector2> spots(const std::string& text) {
  std::vector<Vector2> out;
  const std::vector<double> all = numbers(text);
  for (std::size_t at = 0; at + 1 < all.size(); at += 2) out.emplace_back(all[at], all[at + 1]);
  return out;
}

TEST(Profiles, ShowHeightsInProportionOverLevelGround) {
  const world::World world = level_world(20);
  Map map(world, {-200, -200, 200, 200});
  map.profile({{-100, 0, 60}, {100, 0, 100}}, "#0a0b0c");
  const std::string svg = map.finish("", {});

  const auto flown = spots(
      found(svg, R"re(<polyline points="([^"]*)" fill="none" stroke="#0a0b0c" stroke-width="2" )re")
          .at(0));
  const auto ground = spots(found(svg, R"re(<polygon points="([^"]*)" fill="#cbb493")re").at(0));
  ASSERT_GT(flown.size(), 300U);
  const double level = ground[1].y(), per_metre = (level - flown.front().y()) / 40;
  EXPECT_NEAR((level - flown.back().y()) / per_metre, 80, 1);
  for (std::size_t at = 0; at < flown.size(); ++at) {
    const double part =
        (flown[at].x() - flown.front().x()) / (flown.back().x() - flown.front().x());
    EXPECT_NEAR((level - flown[at].y()) / per_metre, 40 + part * 40, 1);
    EXPECT_NEAR(ground[at + 1].y(), level, 0.01);
  }
}

TEST(Profiles, ShowAVolumeWhereTheWayIsOverOrInIt) {
  const world::World world = level_world(0);
  world::Volume volume;
  volume.polygon = {{-50, -50}, {50, -50}, {50, 50}, {-50, 50}};
  volume.floor = 0;
  volume.ceiling = 40;
  Map map(world, {-200, -200, 200, 200});
  map.closed({volume});
  map.profile({{-200, 0, 80}, {200, 0, 80}}, "#0a0b0c");
  map.profile({{-200, 90, 80}, {200, 90, 80}}, "#0a0b0c");
  const std::string svg = map.finish("", {});

  const auto flown = spots(
      found(svg, R"re(<polyline points="([^"]*)" fill="none" stroke="#0a0b0c" stroke-width="2" )re")
          .at(0));
  const auto bands = found(
      svg, R"re(<rect (x="[^"]*" y="[^"]*" width="[^"]*" height="[^"]*") fill="url\(#closed\)")re");
  ASSERT_EQ(bands.size(), 1U) << "the second way passes it by";
  const std::vector<double> band = numbers(bands[0]);
  const double length = flown.back().x() - flown.front().x();
  EXPECT_NEAR((band[0] - flown.front().x()) / length, 150.0 / 400, 0.01);
  EXPECT_NEAR(band[2] / length, 100.0 / 400, 0.01);
  EXPECT_GT(band[1], flown.front().y()) << "its ceiling is below the way";
}

TEST(Profiles, OfAPointAreNone) {
  const world::World world = level_world();
  Map map(world, {-200, -200, 200, 200});
  map.profile({{0, 0, 60}}, "#0a0b0c");

  EXPECT_THAT(map.finish("", {}), Not(HasSubstr("along the way")));
}

}  // namespace
}  // namespace skein::cartography
