// SPDX-License-Identifier: Apache-2.0
// Missions of other programs, imported and flown to their ends. The judge is where the vehicle
// truly was, and places reckoned by the ellipsoid's radii of curvature, which the import does not
// use.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "skein/assembly/assembly.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/import_tool/import.hpp"
#include "temporary_folder.hpp"
#include "testing/mission.hpp"

namespace skein::testing {
namespace {

using world::Vector3;

constexpr double kHomeLatitude = 47.5, kHomeLongitude = 8.25;

/// East and north of home [m], for places near it.
Vector3 enu(double latitude, double longitude, double height) {
  constexpr double kA = 6378137, kE2 = 6.69437999014e-3;
  const double phi = kHomeLatitude * std::numbers::pi / 180;
  const double w = 1 - kE2 * std::sin(phi) * std::sin(phi);
  const double meridian = kA * (1 - kE2) / std::pow(w, 1.5), normal = kA / std::sqrt(w);
  const double radian = std::numbers::pi / 180, over = 430;
  return {(longitude - kHomeLongitude) * radian * (normal + over) * std::cos(phi),
          (latitude - kHomeLatitude) * radian * (meridian + over), height};
}

/// Where the vehicle truly was, a position a second.
std::vector<Vector3> track(const Mission& mission) {
  std::vector<Vector3> all;
  for (const auto& record : mission.find({{"kind", "telemetry"}})) {
    const auto at = record.numbers("position");
    all.emplace_back(at.at(0), at.at(1), at.at(2));
  }
  return all;
}

struct Passed {
  double distance = 1e9;  ///< least, of the straight pieces between positions
  std::size_t when = 0;   ///< index of the position before
};

Passed passed(const std::vector<Vector3>& track, const Vector3& place, std::size_t from) {
  Passed best;
  for (std::size_t i = from; i + 1 < track.size(); ++i) {
    const Vector3 piece = track[i + 1] - track[i];
    const double length = piece.squaredNorm();
    const double part =
        length > 0 ? std::clamp((place - track[i]).dot(piece) / length, 0.0, 1.0) : 0;
    const double distance = (place - track[i] - part * piece).norm();
    if (distance < best.distance) best = {distance, i};
  }
  return best;
}

class Imported : public ::testing::Test {
 protected:
  Mission fly(const std::string& name, const std::string& text, const std::string& camera = "") {
    import_tool::ImportOptions options;
    options.file = (folder_.path() / name).string();
    options.out = (folder_.path() / "s.yaml").string();
    options.model = std::string(SKEIN_SOURCE_DIR) + "/scenarios/comets/models/marvin.yaml";
    options.camera = camera;
    std::ofstream(options.file) << text;
    std::ostringstream out, err;
    EXPECT_EQ(import_tool::import_mission(options, out, err), kExitOk) << err.str();
    const auto scenario = assembly::load_scenario(options.out, {});
    if (!scenario) {
      ADD_FAILURE() << to_text(scenario.error());
      return {};
    }
    return play(*scenario);
  }
  skein::testing::TemporaryFolder folder_;
};

/// In this order, each within two metres of the true track.
void expect_reached(const Mission& mission, const std::vector<Vector3>& places) {
  const auto flown = track(mission);
  ASSERT_GT(flown.size(), 10U);
  std::size_t from = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Passed here = passed(flown, places[i], from);
    EXPECT_LT(here.distance, 2.0) << "place " << i + 1;
    from = here.when;
  }
}

constexpr const char* kWaypoints =
    "QGC WPL 110\n"
    "0\t1\t0\t16\t0\t0\t0\t0\t47.5\t8.25\t430\t1\n"
    "1\t0\t3\t22\t0\t0\t0\t0\t0\t0\t20\t1\n"
    "2\t0\t3\t16\t0\t0\t0\t0\t47.5010\t8.2500\t25\t1\n"
    "3\t0\t3\t16\t8\t0\t0\t0\t47.5010\t8.2520\t40\t1\n"
    "4\t0\t0\t16\t0\t0\t0\t0\t47.5000\t8.2520\t460\t1\n"
    "5\t0\t3\t20\t0\t0\t0\t0\t0\t0\t0\t1\n";

TEST_F(Imported, AWayPointFileIsFlownPlaceByPlaceAndEndsOnTheGroundAtHome) {
  const Mission mission = fly("copter.waypoints", kWaypoints);

  EXPECT_EQ(mission.end, End::kFinished);
  EXPECT_EQ(mission.failures(), "");
  EXPECT_EQ(mission.untrue, "");
  expect_reached(mission, {enu(47.5010, 8.2500, 25), enu(47.5010, 8.2520, 40),
                           enu(47.5000, 8.2520, 30), enu(47.5, 8.25, 30)});
  EXPECT_LT((track(mission).back() - enu(47.5, 8.25, 0)).norm(), 2.0);
}

TEST_F(Imported, TheHoldIsHeld) {
  const Mission mission = fly("copter.waypoints", kWaypoints);

  const auto flown = track(mission);
  const Vector3 held = enu(47.5010, 8.2520, 40);
  const auto seconds = std::count_if(flown.begin(), flown.end(),
                                     [&](const Vector3& at) { return (at - held).norm() < 2.0; });
  EXPECT_GE(seconds, 8);
}

TEST_F(Imported, AMissionOfAnotherPlaceIsNotTakenForThis) {
  const Mission mission = fly("copter.waypoints", kWaypoints);

  EXPECT_GT(passed(track(mission), enu(47.5010, 8.2505, 80), 0).distance, 20)
      << "the judge must be able to say no";
}

TEST_F(Imported, ASurveyTakesPicturesOnItsLanesInsideTheFence) {
  const std::string plan = R"({"fileType": "Plan", "version": 1, "groundStation": "QGroundControl",
  "geoFence": {"version": 2, "circles": [{"circle": {"center": [47.5005, 8.2535], "radius": 30}, "inclusion": false}],
    "polygons": [{"inclusion": true, "version": 1,
      "polygon": [[47.499, 8.2485], [47.499, 8.255], [47.503, 8.255], [47.503, 8.2485]]}]},
  "rallyPoints": {"version": 2, "points": [[47.5, 8.251, 20]]},
  "mission": {"version": 2, "plannedHomePosition": [47.5, 8.25, 430], "items": [
    {"type": "SimpleItem", "autoContinue": true, "command": 22, "frame": 3, "params": [0, 0, 0, null, 47.5, 8.25, 30]},
    {"type": "ComplexItem", "complexItemType": "survey", "polygon": [[47.501, 8.2505], [47.501, 8.252], [47.502, 8.252], [47.502, 8.2505]],
     "TransectStyleComplexItem": {"Items": [
      {"type": "SimpleItem", "autoContinue": true, "command": 16, "frame": 3, "params": [0, 0, 0, null, 47.501, 8.2505, 30]},
      {"type": "SimpleItem", "autoContinue": true, "command": 206, "frame": 2, "params": [25, 0, 1, 0, 0, 0, 0]},
      {"type": "SimpleItem", "autoContinue": true, "command": 16, "frame": 3, "params": [0, 0, 0, null, 47.502, 8.2505, 30]},
      {"type": "SimpleItem", "autoContinue": true, "command": 16, "frame": 10, "params": [0, 0, 0, null, 47.502, 8.252, 30]},
      {"type": "SimpleItem", "autoContinue": true, "command": 16, "frame": 10, "params": [0, 0, 0, null, 47.501, 8.252, 30]},
      {"type": "SimpleItem", "autoContinue": true, "command": 206, "frame": 2, "params": [0, 0, 1, 0, 0, 0, 0]}]}},
    {"type": "SimpleItem", "autoContinue": true, "command": 21, "frame": 3, "params": [0, 0, 0, null, 47.5, 8.2505, 0]}]}})";

  const Mission mission = fly("survey.plan", plan, "visible");

  EXPECT_EQ(mission.end, End::kFinished);
  EXPECT_EQ(mission.failures(), "");
  EXPECT_EQ(mission.untrue, "");
  expect_reached(mission, {enu(47.501, 8.2505, 30), enu(47.502, 8.2505, 30), enu(47.502, 8.252, 30),
                           enu(47.501, 8.252, 30), enu(47.5, 8.2505, 0)});
  const auto when = [&](const char* type, const char* state, std::size_t which) {
    const auto found = mission.find({{"kind", "task"}, {"type", type}, {"state", state}});
    return found.size() > which ? found[which].at().to_seconds() : -1;
  };
  ASSERT_EQ(mission.count({{"kind", "task"}, {"type", "takeshot"}, {"state", "running"}}), 1U);
  EXPECT_NEAR(when("takeshot", "running", 0), when("goto", "ended", 0), 2) << "where lanes begin";
  EXPECT_NEAR(when("takeshot", "aborted", 0), when("goto", "ended", 1), 2) << "where they end";
  EXPECT_GT(when("goto", "ended", 1), when("goto", "ended", 0) + 20);
}

TEST_F(Imported, ALineOfAMapIsFlownAndTheVehicleComesHome) {
  const Mission mission = fly(
      "lap.kml",
      "<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document>"
      "<Placemark><name>home</name><Point><coordinates>8.25,47.5</coordinates></Point></Placemark>"
      "<Placemark><name>lap</name><LineString><altitudeMode>relativeToGround</altitudeMode>"
      "<coordinates>8.2515,47.5,30 8.2515,47.501,35 8.25,47.501,30</coordinates></LineString>"
      "</Placemark></Document></kml>");

  EXPECT_EQ(mission.failures(), "");
  // The file says no home: the first point of the way is taken for it, and is the frame's origin.
  const Vector3 moved = enu(47.5, 8.2515, 0);
  expect_reached(mission, {enu(47.5, 8.2515, 30) - moved, enu(47.501, 8.2515, 35) - moved,
                           enu(47.501, 8.25, 30) - moved, Vector3(0, 0, 0)});
}

}  // namespace
}  // namespace skein::testing
