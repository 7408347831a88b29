// SPDX-License-Identifier: Apache-2.0
#include "result_json.hpp"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "skein/foundation/overloaded.hpp"

namespace skein::refine_tool {
namespace {

using Json = nlohmann::ordered_json;
using world::Vector2;
using world::Vector3;

/// Millimetres and milliseconds: what is finer is noise.
Json rounded(double value) {
  if (!std::isfinite(value)) return nullptr;
  const double fine = std::round(value * 1000) / 1000;
  return fine == 0 ? 0 : fine;  // no -0
}

Json of(const Vector3& at) { return {rounded(at.x()), rounded(at.y()), rounded(at.z())}; }
Json of(const Vector2& at) { return {rounded(at.x()), rounded(at.y())}; }

Json of(Duration duration) {
  return duration == Duration::max() ? Json(nullptr) : rounded(duration.to_seconds());
}

template <class Points>
Json all(const Points& points) {
  Json list = Json::array();
  for (const auto& at : points) list.push_back(of(at));
  return list;
}

Json of(const refiners::DurationInterval& duration) {
  return {{"least", of(duration.least)},
          {"expected", of(duration.expected)},
          {"most", of(duration.most)}};
}

Json task_of(const refiners::Path& path, const Query&) {
  return {{"way", all(path.way)},
          {"length", rounded(path.length)},
          {"graph_cost", rounded(path.graph_cost)},
          {"energy", rounded(path.energy)}};
}

Json task_of(const refiners::Tour& tour, const Query& query) {
  const auto& stops = std::get<TourWithAreas>(query.question).tour.stops;
  Json visits = Json::array();
  for (const refiners::Visit& visit : tour.visits) {
    const refiners::Stop& stop = stops[visit.stop];
    const refiners::Gate& gate = stop.gates[visit.gate];
    visits.push_back({{"stop", stop.name},
                      {"gate", visit.gate},
                      {"entry", of(gate.entry)},
                      {"exit", of(gate.exit)},
                      {"inside", of(gate.inside)},
                      {"way", all(visit.way)}});
  }
  return {{"exact", tour.exact},
          {"length", rounded(tour.length)},
          {"energy", rounded(tour.energy)},
          {"visits", visits},
          {"last", all(tour.last)}};
}

Json task_of(const refiners::Coverage& coverage, const Query&) {
  Json lanes = Json::array();
  for (const refiners::Lane& lane : coverage.lanes)
    lanes.push_back({{"from", of(lane.from)}, {"to", of(lane.to)}});
  Json out = {{"direction", rounded(coverage.direction)},
              {"turns", coverage.turns},
              {"parts", coverage.parts},
              {"length", rounded(coverage.length)},
              {"energy", rounded(coverage.energy)},
              {"lanes", lanes},
              {"way", all(coverage.way)}};
  if (coverage.headland > 0) {
    out["headland"] = rounded(coverage.headland);
    out["left_out"] = rounded(coverage.left_out);
  }
  return out;
}

Json task_of(const refiners::Partition& partition, const Query& query) {
  Json parts = Json::array();
  for (const refiners::Part& part : partition.parts)
    parts.push_back({{"uav", part.uav},
                     {"share", rounded(part.share)},
                     {"anchor", of(part.anchor)},
                     {"altitude", rounded(part.altitude)},
                     {"area", rounded(world::area(part.polygon))},
                     {"duration", of(part.duration)},
                     {"polygon", all(part.polygon)},
                     {"coverage", task_of(part.coverage, query)}});
  return {{"spread", rounded(partition.spread)}, {"apart", partition.apart}, {"parts", parts}};
}

Json task_of(const refiners::Patrol& patrol, const Query&) {
  const refiners::PatrolFigures& p = patrol.predicted;
  const auto beside_bound = [](double value, double bound) {
    return Json{{"value", rounded(value)}, {"lower_bound", rounded(bound)}};
  };
  return {{"cells", p.cells},
          {"hidden", p.hidden},
          {"unseen", p.unseen},
          {"worst_idleness", beside_bound(p.worst_idleness, p.worst_idleness_bound)},
          {"worst_risk_idleness", beside_bound(p.worst_risk_idleness, p.worst_risk_idleness_bound)},
          {"mean_idleness", beside_bound(p.mean_idleness, p.mean_idleness_bound)},
          {"energy", rounded(patrol.energy)},
          {"way", all(patrol.way)}};
}

Json task_of(const refiners::Viewpoints& viewpoints, const Query&) {
  Json points = Json::array();
  for (const refiners::ViewPoint& point : viewpoints.points)
    points.push_back({{"position", of(point.position)},
                      {"heading", rounded(point.heading)},
                      {"pitch", rounded(point.pitch)},
                      {"quality", rounded(point.quality)},
                      {"utility", rounded(point.utility)}});
  return {{"points", points}, {"sight_checks", viewpoints.sight_checks}};
}

/// Rows from the north, a letter a cell: seen, hidden or left out.
Json task_of(const refiners::Viewshed& view, const Query&) {
  constexpr std::array<char, 3> kLetters = {'.', '#', ' '};
  Json rows = Json::array();
  for (std::size_t row = view.grid.rows; row-- > 0;) {
    std::string text;
    for (std::size_t column = 0; column < view.grid.columns; ++column)
      text += kLetters[static_cast<std::size_t>(view.cells[view.grid.index(column, row)])];
    rows.push_back(text);
  }
  const double cell = view.grid.cell;
  return {{"cells", view.asked},
          {"seen", view.seen},
          {"seen_area", rounded(static_cast<double>(view.seen) * cell * cell)},
          {"west", rounded(view.grid.west)},
          {"south", rounded(view.grid.south)},
          {"cell", rounded(cell)},
          {"rows", rows}};
}

Json task_of(const refiners::Relay& relay, const Query&) {
  return {{"margin", rounded(relay.margin)},
          {"spacing", rounded(relay.spacing)},
          {"positions", all(relay.positions)}};
}

Json task_of(const refiners::Evaluation& evaluation, const Query&) {
  Json obstructions = Json::array();
  for (const refiners::Obstruction& one : evaluation.obstructions)
    obstructions.push_back({{"leg", one.leg}, {"at", of(one.at)}, {"by", one.by}});
  return {
      {"length", rounded(evaluation.length)}, {"energy", rounded(evaluation.energy)},
      {"climb", rounded(evaluation.climb)},   {"least_height", rounded(evaluation.least_height)},
      {"obstructions", obstructions},         {"limits", evaluation.limits}};
}

Json task_of(const refiners::Insertion& insertion, const Query&) {
  Json added = Json::array();
  for (const double seconds : insertion.added) added.push_back(rounded(seconds));
  return {{"position", insertion.position},
          {"added", added},
          {"to", all(insertion.to)},
          {"from", all(insertion.from)}};
}

Json refusal_json(const refiners::Refusal& refusal) {
  return {
      {"kind", refiners::to_text(refusal.kind)}, {"field", refusal.field}, {"why", refusal.why}};
}

template <class Task>
void put(Json& out, const refiners::Refined<Task>& refined, const Query& query) {
  out["duration"] = of(refined.duration);
  out["effort"] = {{"steps", refined.effort.steps}, {"cut_short", refined.effort.cut_short}};
  if (query.seconds)
    out["effort"]["budget"] = {{"seconds", *query.seconds}, {"default", query.by_default}};
  out[query.service] = task_of(refined.task, query);
}

}  // namespace

const char* cost_unit(const Solution& solution) {
  return std::visit(
      Overloaded{[](const refiners::Refined<refiners::Path>&) { return "m × crossing cost"; },
                 [](const refiners::Refined<refiners::Viewpoints>&) { return "1 - utility"; },
                 [](const refiners::Refined<refiners::Viewshed>&) { return "of the cells hidden"; },
                 [](const refiners::Refined<refiners::Relay>&) { return "relays"; },
                 [](const auto&) { return "s"; }},
      solution);
}

Json to_json(const Query& query, const Answer& answer) {
  Json out = {{"service", query.service}, {"feasible", answer.has_value()}};
  if (!query.notes.empty()) out["notes"] = query.notes;
  if (!answer) {
    out["refusal"] = refusal_json(answer.error());
    return out;
  }
  out["cost"] = std::visit([](const auto& refined) { return rounded(refined.cost); }, *answer);
  out["cost_unit"] = cost_unit(*answer);
  std::visit([&](const auto& refined) { put(out, refined, query); }, *answer);
  return out;
}

}  // namespace skein::refine_tool
