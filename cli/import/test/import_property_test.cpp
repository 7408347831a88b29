// SPDX-License-Identifier: Apache-2.0
// Any mission: what was imported is accepted and says of every place what the file says, or the
// file is refused with a reason.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "skein/ground_orders/script.hpp"
#include "skein/import_tool/import.hpp"
#include "skein/mission_files/read.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::import_tool {
namespace {

constexpr double kLatitude = 47.5, kLongitude = 8.25, kOverSea = 430;

ImportOptions options() {
  ImportOptions options;
  options.file = "any.waypoints";
  options.model = std::string(SKEIN_SOURCE_DIR) + "/scenarios/comets/models/marvin.yaml";
  options.leave_out = true;
  return options;
}

struct Place {
  double east, north, over_home;
  int frame;
};

/// By which places near home are reckoned; the import does not use them.
struct Radii {
  double meridian, parallel;  ///< [m] per radian, at home's height
};
Radii radii() {
  constexpr double kA = 6378137, kE2 = 6.69437999014e-3;
  const double phi = kLatitude * std::numbers::pi / 180;
  const double w = 1 - kE2 * std::sin(phi) * std::sin(phi);
  return {kA * (1 - kE2) / std::pow(w, 1.5) + kOverSea,
          (kA / std::sqrt(w) + kOverSea) * std::cos(phi)};
}

std::string row(int index, int frame, int command, const Place& place) {
  const double degree = 180 / std::numbers::pi;
  std::ostringstream out;
  out.precision(12);
  const double height = frame == 0 ? place.over_home + kOverSea : place.over_home;
  out << index << "\t0\t" << frame << '\t' << command << "\t0\t0\t0\t0\t"
      << kLatitude + place.north / radii().meridian * degree << '\t'
      << kLongitude + place.east / radii().parallel * degree << '\t' << height << "\t1\n";
  return out.str();
}

std::string head() {
  return "QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t47.5\t8.25\t430\t1\n1\t0\t3\t22\t0\t0\t0\t0\t0\t0\t"
         "20\t1\n";
}

std::vector<world::Vector3> flown_points(const scenario::Scenario& scenario) {
  std::vector<world::Vector3> points;
  for (const auto& step : scenario.ground.script.steps)
    for (const auto& action : step.actions)
      if (const auto* plan = std::get_if<ground_station::SendPlan>(&action))
        for (const auto& task : plan->tasks)
          for (const auto& target : task.targets)
            if (const auto* at = std::get_if<ground_station::AtPoints>(&target.where))
              points.insert(points.end(), at->points.begin(), at->points.end());
  return points;
}

RC_GTEST_PROP(AnyMission, HasItsWayPointsWhereTheFileSaysThem, ()) {
  const auto places =
      *rc::gen::nonEmpty(rc::gen::container<std::vector<Place>>(rc::gen::construct<Place>(
          rc::gen::map(rc::gen::inRange(-8000, 8000), [](int x) { return x / 10.0; }),
          rc::gen::map(rc::gen::inRange(-8000, 8000), [](int x) { return x / 10.0; }),
          rc::gen::map(rc::gen::inRange(30, 2500), [](int x) { return x / 10.0; }),
          rc::gen::element(0, 3, 10))));
  std::string text = head();
  for (std::size_t i = 0; i < places.size(); ++i)
    text += row(static_cast<int>(i) + 2, places[i].frame, 16, places[i]);

  const auto contents = mission_files::read_text(text, "any.waypoints");
  RC_ASSERT(contents.has_value());
  const auto made = to_scenario(*contents, options(), "any.yaml");
  RC_ASSERT(made.has_value());
  const auto scenario = scenario::read_scenario_text(made->yaml, "any.yaml");
  RC_ASSERT(scenario.has_value());

  const auto points = flown_points(*scenario);
  RC_ASSERT(points.size() == places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    // The Earth falls away below straight axes: 10 cm, 1.1 km away. Over the ground it does not.
    RC_ASSERT(std::abs(points[i].x() - places[i].east) < 0.3);
    RC_ASSERT(std::abs(points[i].y() - places[i].north) < 0.3);
    RC_ASSERT(std::abs(points[i].z() - places[i].over_home) < 0.15);
  }
}

RC_GTEST_PROP(AnyMission, IsAcceptedOrRefusedWithAReason, ()) {
  std::string text = head();
  const int items = *rc::gen::inRange(0, 12);
  for (int i = 0; i < items; ++i) {
    const int command =
        *rc::gen::element(16, 17, 19, 20, 21, 22, 93, 177, 178, 203, 206, 2000, 2001);
    std::ostringstream line;
    line << i + 2 << "\t0\t" << *rc::gen::element(0, 2, 3, 10) << '\t' << command;
    for (int param = 0; param < 4; ++param) line << '\t' << *rc::gen::inRange(-3, 20);
    line << '\t' << 47.5 + *rc::gen::inRange(-5, 5) / 1000.0 << '\t'
         << 8.25 + *rc::gen::inRange(-5, 5) / 1000.0 << '\t' << *rc::gen::inRange(-20, 500)
         << "\t1\n";
    text += line.str();
  }
  ImportOptions how = options();
  how.camera = *rc::gen::element<std::string>("", "visible");

  const auto contents = mission_files::read_text(text, "any.waypoints");
  if (!contents) {
    RC_ASSERT(!contents.error().empty());
    return;
  }
  const auto made = to_scenario(*contents, how, "any.yaml");
  if (!made)
    RC_ASSERT(!made.error().empty());
  else
    RC_ASSERT(scenario::read_scenario_text(made->yaml, "any.yaml").has_value());
}

}  // namespace
}  // namespace skein::import_tool
