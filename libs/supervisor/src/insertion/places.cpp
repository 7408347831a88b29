// SPDX-License-Identifier: Apache-2.0
// Where high-level tasks take the UAV.
#include "insertion/places.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "planning/gazetteer.hpp"
#include "planning/terms.hpp"
#include "skein/mission/home.hpp"
#include "skein/refiners/area_gates.hpp"
#include "skein/supervisor/visit.hpp"

namespace skein::supervisor {
namespace {

using mission::ParameterKind;
using refiners::Gate;
using world::Vector3;

/// Of more places only so many are ends of the visit: pairs grow with the square.
constexpr std::size_t kMostPlaces = 6;
/// Part of what a sensor sees across that a sweep counts on.
constexpr double kSwathUsed = 0.8;

/// What the arguments name, by kind.
struct Named {
  std::vector<Vector3> places;
  std::vector<const world::Zone*> zones;
};

class Reader {
 public:
  explicit Reader(const PlanningRequest& base)
      : base_(base), gazetteer_(base.knowledge, base.world) {}

  Named read(const mission::HighLevelTask& goal) {
    const auto signature = base_.knowledge->vocabulary.tasks.find(goal.name);
    if (signature == base_.knowledge->vocabulary.tasks.end()) return {};
    const auto& kinds = signature->second.parameters;
    for (std::size_t i = 0; i < std::min(kinds.size(), goal.arguments.size()); ++i)
      read(goal.arguments[i], kinds[i]);
    return std::move(named_);
  }

 private:
  void read(const mission::Argument& argument, ParameterKind kind) {
    if (const auto* location = std::get_if<Vector3>(&argument)) {
      if (kind == ParameterKind::kPlace) named_.places.push_back(over(*location, base_));
    } else if (const auto* name = std::get_if<std::string>(&argument)) {
      if (kind == ParameterKind::kPlace || kind == ParameterKind::kPlaces) add_place(*name);
      if (kind == ParameterKind::kZone) add_zone(*name);
    } else if (const auto* names = std::get_if<std::vector<std::string>>(&argument)) {
      if (kind != ParameterKind::kPlaces) return;
      for (const std::string& each : *names) add_place(each);
    }
  }
  void add_place(const std::string& name) {
    for (const auto& [known, place] : base_.world->places)
      if (same_name(known, name)) return named_.places.push_back(over(place, base_));
    if (mission::means_home(name)) named_.places.push_back(over_home(base_));
  }
  void add_zone(const std::string& name) {
    if (const world::Zone* zone = gazetteer_.zone(name)) named_.zones.push_back(zone);
  }

  const PlanningRequest& base_;
  Gazetteer gazetteer_;
  Named named_;
};

/// Inside counts as nothing: it takes about as long whichever the ends are.
std::vector<Gate> pairs_of(std::vector<Vector3> places) {
  if (places.size() == 1) return {{places.front(), places.front(), {}}};
  places.resize(std::min(places.size(), kMostPlaces));
  std::vector<Gate> gates;
  for (const Vector3& entry : places)
    for (const Vector3& exit : places)
      if (&entry != &exit) gates.push_back({entry, exit, {}});
  return gates;
}

/// What the widest sensor sees across, straight down from the altitude of flights [m].
double swath_of(const Knowledge& knowledge) {
  double aperture = 0;
  for (const world::SensorModel& sensor : knowledge.vehicle.sensors)
    aperture = std::max(aperture, sensor.aperture);
  const double across = 2 * knowledge.altitude * std::tan(std::min(aperture, 1.0));
  return std::max(kSwathUsed * across, 1.0);
}

Vector3 centre_of(const world::Polygon& polygon, const PlanningRequest& base) {
  world::Vector2 sum = world::Vector2::Zero();
  for (const world::Vector2& corner : polygon) sum += corner;
  sum /= static_cast<double>(std::max<std::size_t>(polygon.size(), 1));
  return over({sum.x(), sum.y(), 0}, base);
}

std::vector<Gate> corners_of(const world::Zone& zone, const PlanningRequest& base) {
  refiners::CoverageQuery sweep;
  sweep.vehicle = base.knowledge->vehicle;
  sweep.area = zone.polygon;
  sweep.swath = swath_of(*base.knowledge);
  sweep.altitude = base.knowledge->altitude;
  sweep.mode = refiners::SweepMode::kLongestLine;
  sweep.depart = base.situation.origin;
  const refiners::Setting setting{
      .world = *base.world, .budget = {}, .seed = base.seed, .paths = nullptr};
  if (auto gates = refiners::gates_of(sweep, setting); gates && !gates->empty()) return *gates;
  const Vector3 centre = centre_of(zone.polygon, base);
  return {{centre, centre, {}}};
}

}  // namespace

Vector3 over(const Vector3& point, const PlanningRequest& base) {
  return Gazetteer(base.knowledge, base.world).flown_to(point);
}

Vector3 in_the_air(const PlanningRequest& base) {
  const Situation& situation = base.situation;
  return situation.airborne ? situation.position : over(situation.position, base);
}

Vector3 over_home(const PlanningRequest& base) { return over(base.knowledge->home, base); }

std::vector<Gate> gates_of(const mission::HighLevelTask& goal, const PlanningRequest& base) {
  const Named named = Reader(base).read(goal);
  if (!named.places.empty()) return pairs_of(named.places);
  if (!named.zones.empty()) return corners_of(*named.zones.front(), base);
  return {};
}

std::vector<Gate> visits_of(const mission::HighLevelTask& task,
                            std::shared_ptr<const Knowledge> knowledge,
                            std::shared_ptr<const world::World> world, MissionTime at) {
  PlanningRequest base;
  base.knowledge = std::move(knowledge);
  base.world = std::move(world);
  base.situation.origin = at;
  return gates_of(task, base);
}

bool is_shared(const mission::HighLevelTask& goal, const mission::Vocabulary& vocabulary) {
  const auto signature = vocabulary.tasks.find(goal.name);
  if (signature == vocabulary.tasks.end()) return false;
  const auto& kinds = signature->second.parameters;
  return std::any_of(kinds.begin(), kinds.end(), [](ParameterKind kind) {
    return kind == ParameterKind::kSyncId || kind == ParameterKind::kUavs;
  });
}

}  // namespace skein::supervisor
