// SPDX-License-Identifier: Apache-2.0
#include "history.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace skein::console {

namespace {

using wire::Slot;

bool is_followed(Slot slot) {
  return slot == Slot::kTelemetry || slot == Slot::kPerceptionReport || slot == Slot::kSighting ||
         slot == Slot::kLinkState || slot == Slot::kMissionState || slot == Slot::kUavBoard ||
         slot == Slot::kUavTasks || slot == Slot::kGroundBoard || slot == Slot::kJointTaskState ||
         slot == Slot::kSeenObject;
}

/// The ground station says where a place is, to each UAV: once is enough for the page.
bool is_of_a_place(const wire::Sample& sample) {
  const auto* change = std::get_if<wire::WorldChange>(&sample);
  return change != nullptr && change->part == wire::WorldPart::kPlace;
}

std::string place_line(const wire::WorldChange& change) {
  nlohmann::json place{{"name", change.name}, {"removed", change.remove}};
  if (!change.remove) place["at"] = {change.at.x, change.at.y, change.at.z};
  const nlohmann::json line{{"place", std::move(place)}};
  return line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Those that the page has no use for.
bool is_noise(const std::string& kind) {
  return kind == "message" || kind == "perception" || kind == "telemetry";
}

std::string key_of(const wire::Sample& sample) {
  const wire::SampleHeader& header = wire::header_of(sample);
  const std::string of = " " + std::to_string(header.origin);
  if (const auto* look = std::get_if<wire::PerceptionReport>(&sample))
    return "look" + of + " " + look->device;
  if (const auto* look = std::get_if<wire::Sighting>(&sample))
    return "look" + of + " " + look->device;
  return std::string(wire::slot_name(wire::slot_of(sample))) + of + " " +
         std::to_string(header.instance);
}

std::string rounded(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f", value);
  return text.data();
}

std::string quoted(const std::string& text) {
  using Json = nlohmann::json;
  return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

void History::take(const wire::Sample& sample, Feed& feed) {
  if (std::holds_alternative<wire::OperatorReply>(sample)) {
    feed.add(wire::to_json(sample));
    return;
  }
  if (is_of_a_place(sample)) {
    const auto& change = std::get<wire::WorldChange>(sample);
    feed.set("place " + change.name, place_line(change));
    return;
  }
  if (!is_followed(wire::slot_of(sample))) return;
  feed.set(key_of(sample), wire::to_json(sample));
  if (const auto* tasks = std::get_if<wire::UavTasks>(&sample)) note_states(*tasks, feed);
  const auto* board = std::get_if<wire::UavBoard>(&sample);
  if (board != nullptr && board->located_at != wire::kNoInstant) {
    extend_trail(board->uav, board->position, feed);
  }
}

void History::take(const journal::Record& record, Feed& feed) {
  if (!is_noise(record.kind())) feed.add("{\"record\":" + journal::to_json(record) + "}");
}

void History::note_states(const wire::UavTasks& tasks, Feed& feed) {
  for (const wire::BoardTask& task : tasks.tasks) {
    const auto [last, is_new] = states_.try_emplace({tasks.uav, task.id}, task.state);
    if (!is_new && last->second == task.state) continue;
    last->second = task.state;
    feed.add("{\"mark\":{\"uav\":" + quoted(tasks.uav) + ",\"id\":" + std::to_string(task.id) +
             ",\"type\":" + quoted(task.type) + ",\"state\":\"" + std::string(name_of(task.state)) +
             "\",\"at\":" + std::to_string(task.since) + "}}");
  }
}

void History::extend_trail(const std::string& uav, const wire::Vector3& at, Feed& feed) {
  std::deque<wire::Vector3>& trail = trails_[uav];
  const bool is_far = trail.empty() || std::hypot(at.x - trail.back().x, at.y - trail.back().y,
                                                  at.z - trail.back().z) >= kStep;
  if (!is_far) return;
  trail.push_back(at);
  if (trail.size() > kTrail) trail.pop_front();
  std::string points;
  for (const wire::Vector3& one : trail) {
    points += (points.empty() ? "" : ",") + rounded(one.x) + "," + rounded(one.y);
  }
  feed.set("trail " + uav, "{\"trail\":{\"uav\":" + quoted(uav) + ",\"points\":[" + points + "]}}");
}

}  // namespace skein::console
