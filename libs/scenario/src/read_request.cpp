// SPDX-License-Identifier: Apache-2.0
// Requests of operators: the actions of scripts, and what only people do.
#include <cmath>
#include <limits>

#include "read_missions.hpp"
#include "skein/config/parse.hpp"
#include "skein/scenario/operator_request.hpp"

namespace skein::scenario {

namespace {

using config::Reader;
using ground_station::OperatorDeed;

constexpr const char* kKinds =
    "one of take_in_hand, give_back, degree, mission, cancel, play, plan, abort, message, update, "
    "resume_plan, drop_plan, close_air, open_air, know_place, know_ground, global_mission, "
    "declare_lost, declare_found, finish: true, ask, "
    "keep, let_go, answer, judge_alarm, go";

std::string read_uav(const Reader& reader, const TaskContext& context) {
  return reader.required("uav").name_among(context.names.uavs, "a UAV");
}

OperatorDeed read_let_go(const Reader& reader, const TaskContext& context) {
  reader.keys({"uav", "to"});
  return ground_station::LetGo{read_uav(reader, context), reader.optional("to").text()};
}

OperatorDeed read_judgement(const Reader& reader) {
  reader.keys({"alarm", "as"});
  const auto alarm =
      reader.required("alarm").integer(1, 1, std::numeric_limits<std::int32_t>::max());
  const bool confirmed = reader.required("as").choice({"confirmed", "infirmed"}) == 0;
  return ground_station::JudgeAlarm{
      ground_station::AlarmId(static_cast<std::uint32_t>(alarm)),
      confirmed ? ground_station::AlarmState::kConfirmed : ground_station::AlarmState::kInfirmed};
}

bool is_pair(const Reader& point) {
  return point.is_sequence() && point.items().size() == 2 && point.items()[0].is_scalar();
}

std::string in_metres(double figure) { return std::to_string(std::lround(figure)); }

// What its vehicle would refuse, in words for whoever steers it.
void check_point(const world::Vector3& point, const UavSpec& uav, const Reader& reader,
                 const TaskContext& context) {
  const std::string at = in_metres(point.x()) + "," + in_metres(point.y());
  if (!context.terrain.contains(point.x(), point.y())) {
    const world::TerrainSpec& spec = context.scenario.world.terrain;
    reader.error(at + " is outside the terrain",
                 "x from " + in_metres(spec.west) + " to " + in_metres(spec.east) + ", y from " +
                     in_metres(spec.south) + " to " + in_metres(spec.north) + " m");
    return;
  }
  const double height = point.z() - context.terrain.elevation(point.x(), point.y());
  if (uav.model.ground || height <= uav.model.ceiling) return;
  reader.error(at + " is " + in_metres(height) + " m above the ground there",
               "at most the ceiling of " + uav.name + ", " + in_metres(uav.model.ceiling) + " m");
}

// Points [x, y] are at `altitude` over the ground; without it a point says its own height. What
// drives needs none.
std::vector<world::Vector3> read_flat(const Reader& reader, const std::vector<Reader>& items,
                                      bool drives, const TaskContext& context) {
  const Reader altitude = reader.optional("altitude");
  if (!altitude.present() && !drives) {
    reader.optional("to").error("no height",
                                "altitude (--altitude): metres over the ground, or [x, y, z]");
  }
  const double height = altitude.number(0, {0, 10'000, "m above the ground"});
  std::vector<world::Vector3> points;
  for (const Reader& item : items) {
    const world::Vector2 at = read_point_2d(item);
    points.emplace_back(at.x(), at.y(), context.terrain.elevation(at.x(), at.y()) + height);
  }
  return points;
}

OperatorDeed read_way(const Reader& reader, const TaskContext& context) {
  reader.keys({"uav", "to", "altitude"});
  ground_station::SteerTo steer{read_uav(reader, context), {}};
  const UavSpec* uav = context.scenario.find_uav(steer.uav);
  steer.drives = uav != nullptr && uav->model.ground.has_value();
  const Reader to = reader.required("to");
  const bool is_list = to.is_sequence() && !to.items().empty();
  const bool is_one = is_list && to.items()[0].is_scalar() && number_in(to.items()[0]);
  if (is_list && (is_one ? is_pair(to) : is_pair(to.items()[0]))) {
    const auto items = is_one ? std::vector<Reader>{to} : to.items();
    steer.points = read_flat(reader, items, steer.drives, context);
  } else if (to.present()) {
    steer.points = read_points(reader, context);
  }
  if (uav == nullptr) return steer;
  for (const world::Vector3& point : steer.points) check_point(point, *uav, to, context);
  return steer;
}

// What scripts do not have; nothing: it is none of these.
std::optional<OperatorDeed> read_of_person(const Reader& item, TaskContext& context) {
  const auto uav_of = [&](const char* key) {
    item.optional(key).keys({"uav"});
    return read_uav(item.optional(key), context);
  };
  const auto given = [&](const char* key) { return item.optional(key).present(); };
  if (given("ask")) return ground_station::AskForUav{uav_of("ask")};
  if (given("keep")) return ground_station::KeepUav{uav_of("keep")};
  if (given("let_go")) return read_let_go(item.optional("let_go"), context);
  if (given("answer")) return ground_station::Answer{item.optional("answer").text()};
  if (given("judge_alarm")) return read_judgement(item.optional("judge_alarm"));
  if (given("go")) return read_way(item.optional("go"), context);
  return std::nullopt;
}

void read_item(const Reader& item, TaskContext& context, std::vector<OperatorDeed>& deeds) {
  const bool is_map =
      item.keys({"take_in_hand", "give_back", "degree",   "mission",        "cancel",
                 "plan",         "abort",     "message",  "update",         "drop_plan",
                 "resume_plan",  "close_air", "open_air", "finish",         "know_place",
                 "know_ground",  "ask",       "keep",     "let_go",         "answer",
                 "judge_alarm",  "go",        "play",     "global_mission", "declare_lost",
                 "declare_found"});
  if (!is_map) return;
  if (item.entries().size() != 1) return item.error("an action is one thing", kKinds);
  if (auto deed = read_of_person(item, context)) {
    deeds.push_back(std::move(*deed));
  } else if (auto action = read_action(item, context)) {
    deeds.emplace_back(std::move(*action));
  } else {
    item.error("an action of no kind", kKinds);
  }
}

// As if it were an action of a list.
config::Value as_mission(const config::Value& document) {
  config::Value item = document;
  item.entries.clear();
  item.entries.push_back({"mission", document});
  return item;
}

void read_document(const config::Value& document, TaskContext& context, Diagnostics& diagnostics,
                   std::vector<OperatorDeed>& deeds) {
  const Reader reader(document, "request", diagnostics);
  if (!reader.present()) return reader.error("nothing is asked", kKinds);
  if (reader.is_sequence()) {
    for (const Reader& item : items_of(reader)) read_item(item, context, deeds);
    if (reader.items().empty()) reader.error("nothing is asked", kKinds);
  } else if (reader.is_map() && reader.optional("tasks").present()) {
    const config::Value mission = as_mission(document);
    read_item(Reader(mission, "request", diagnostics), context, deeds);
  } else {
    read_item(reader, context, deeds);
  }
}

}  // namespace

Result<std::vector<OperatorDeed>, Diagnostics> RequestReader::read(std::string_view text) {
  const auto document = config::parse_yaml(text, "request");
  if (!document) return tl::unexpected(document.error());
  if (!terrain_) terrain_ = std::make_unique<world::Terrain>(scenario_->world.terrain);
  TaskContext context{*scenario_, names_of(*scenario_), *terrain_};
  context.live = true;
  Diagnostics diagnostics;
  std::vector<OperatorDeed> deeds;
  read_document(*document, context, diagnostics, deeds);
  if (!diagnostics.empty()) return tl::unexpected(std::move(diagnostics));
  return deeds;
}

}  // namespace skein::scenario
