// SPDX-License-Identifier: Apache-2.0
#include "features.hpp"

#include "skein/foundation/overloaded.hpp"

namespace skein::refine_tool {
namespace {

using geodata::Feature;
using world::Vector3;

/// Features in the order in which they are said.
class Features {
 public:
  explicit Features(const world::Terrain& terrain) : terrain_(terrain) {}

  void way(std::string name, const refiners::Way& way) {
    if (way.size() > 1) all.push_back({Feature::Kind::kLine, std::move(name), way});
  }
  void place(std::string name, const Vector3& at) {
    all.push_back({Feature::Kind::kPoint, std::move(name), {at}});
  }
  /// On the ground.
  void area(std::string name, const world::Polygon& polygon) {
    Feature feature{Feature::Kind::kPolygon, std::move(name), {}};
    for (const world::Vector2& at : polygon)
      feature.points.emplace_back(at.x(), at.y(), terrain_.elevation(at.x(), at.y()));
    all.push_back(std::move(feature));
  }

  std::vector<Feature> all;

 private:
  const world::Terrain& terrain_;
};

void add(Features& out, const refiners::Path& path, const Query&) { out.way("way", path.way); }

void add(Features& out, const refiners::Tour& tour, const Query& query) {
  const auto& stops = std::get<TourWithAreas>(query.question).tour.stops;
  for (const refiners::Visit& visit : tour.visits) {
    const refiners::Stop& stop = stops[visit.stop];
    out.way("to " + stop.name, visit.way);
    out.place(stop.name, stop.gates[visit.gate].entry);
  }
  out.way("to the end", tour.last);
}

void add(Features& out, const refiners::Coverage& coverage, const Query& query) {
  out.area("area", std::get<refiners::CoverageQuery>(query.question).area);
  out.way("way", coverage.way);
}

void add(Features& out, const refiners::Partition& partition, const Query&) {
  for (const refiners::Part& part : partition.parts) {
    out.area(part.uav, part.polygon);
    out.way(part.uav, part.coverage.way);
  }
}

void add(Features& out, const refiners::Patrol& patrol, const Query& query) {
  out.area("zone", std::get<refiners::PatrolQuery>(query.question).zone);
  out.way("way", patrol.way);
}

void add(Features& out, const refiners::Viewpoints& viewpoints, const Query& query) {
  const Vector3& target = std::get<refiners::ViewpointQuery>(query.question).target;
  out.place("target", target);
  for (std::size_t i = 0; i < viewpoints.points.size(); ++i) {
    const std::string name = "viewpoint " + std::to_string(i + 1);
    out.place(name, viewpoints.points[i].position);
    out.way(name, {viewpoints.points[i].position, target});
  }
}

void add(Features& out, const refiners::Viewshed&, const Query& query) {
  const auto& asked = std::get<refiners::ViewshedQuery>(query.question);
  out.place("from", asked.from);
  if (!asked.area.empty()) out.area("area", asked.area);
}

void add(Features& out, const refiners::Relay& relay, const Query& query) {
  const auto& asked = std::get<refiners::RelayQuery>(query.question);
  refiners::Way chain = {asked.a};
  for (std::size_t i = 0; i < relay.positions.size(); ++i) {
    out.place("relay " + std::to_string(i + 1), relay.positions[i]);
    chain.push_back(relay.positions[i]);
  }
  chain.push_back(asked.b);
  out.way("links", chain);
}

void add(Features& out, const refiners::Evaluation& evaluation, const Query& query) {
  out.way("way", std::get<refiners::EvaluateQuery>(query.question).way);
  for (const refiners::Obstruction& one : evaluation.obstructions)
    out.place("closed by " + one.by, one.at);
}

void add(Features& out, const refiners::Insertion& insertion, const Query&) {
  out.way("to the task", insertion.to);
  out.way("on from it", insertion.from);
}

}  // namespace

std::vector<Feature> features_of(const Query& query, const Solution& solution) {
  Features features(query.world.terrain);
  std::visit([&](const auto& refined) { add(features, refined.task, query); }, solution);
  return std::move(features.all);
}

}  // namespace skein::refine_tool
