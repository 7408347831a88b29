// SPDX-License-Identifier: Apache-2.0
#include "skein/foxglove/export.hpp"

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <set>

#include "channels.hpp"
#include "map_features.hpp"
#include "skein/foundation/unix_time.hpp"
#include "skein/journal/log_line.hpp"

namespace skein::foxglove {

namespace {

using journal::Record;
using Json = nlohmann::ordered_json;

std::optional<Frame> frame_of(const report::RunInfo& info) {
  if (!info.origin) return std::nullopt;
  return Frame({info.origin->latitude, info.origin->longitude, info.origin->altitude});
}

class Export {
 public:
  Export(const report::RunInfo& info, const std::vector<Record>& records, mcap::Writer& writer)
      : info_(info),
        epoch_(epoch_of(info.epoch)),
        frame_(frame_of(info)),
        channels_(records, writer) {
    for (std::size_t i = 0; i < info.uavs.size(); ++i) colours_[info.uavs[i].name] = colour_of(i);
    for (const report::ClosedAir& air : info.air) {
      changes_of_air_.insert(MissionTime::seconds(air.from));
      if (air.until) changes_of_air_.insert(MissionTime::seconds(*air.until));
    }
  }

  void run(const std::vector<Record>& records) {
    if (frame_) channels_.geojson("/map/zones", epoch_, zones_geojson(info_, *frame_));
    for (const Record& record : records) {
      if (frame_) draw_until(record.at());
      see(record);
      channels_.record(unix_time(epoch_, record.at()), record);
    }
    if (frame_) draw_until(MissionTime::max());
  }

 private:
  void see(const Record& record) {
    if (const auto line = journal::log_line_of(record)) say(record, *line);
    if (!frame_) return;
    const std::string uav(record.text("uav"));
    if (record.kind() == "telemetry") locate(record, uav);
    if (record.kind() == "planned") plan(record, uav);
    if (record.kind() == "task") forget(record, uav);
    if (record.kind() != "alarm") return;
    alarms_.insert_or_assign(static_cast<std::int64_t>(record.number("alarm")), record);
    channels_.geojson("/map/alarms", unix_time(epoch_, record.at()),
                      alarms_geojson(alarms_, *frame_));
  }

  void say(const Record& record, const journal::LogLine& line) {
    const std::uint64_t time = unix_time(epoch_, record.at());
    const Json json{{"timestamp", Json::parse(timestamp_json(time))},
                    {"level", static_cast<int>(line.level)},
                    {"message", line.text},
                    {"name", record.node()},
                    {"file", ""},
                    {"line", 0}};
    channels_.log("/" + record.node() + "/log", time,
                  json.dump(-1, ' ', false, Json::error_handler_t::replace));
  }

  void locate(const Record& record, const std::string& uav) {
    const auto at = record.numbers("position"), velocity = record.numbers("velocity");
    if (at.size() != 3) return;
    const std::uint64_t time = unix_time(epoch_, record.at());
    const world::GeodeticPoint place = frame_->to_geodetic({at[0], at[1], at[2]});
    const auto colour = colours_[uav];
    // Its headings are clockwise from north, ours counter-clockwise from east.
    const double heading = std::numbers::pi / 2 - record.number("heading");
    Json json{{"timestamp", Json::parse(timestamp_json(time))},
              {"frame_id", uav},
              {"latitude", place.latitude_degrees},
              {"longitude", place.longitude_degrees},
              {"altitude", place.altitude},
              {"position_covariance", std::vector<double>(9, 0)},
              {"position_covariance_type", 0},
              {"heading", std::remainder(heading, 2 * std::numbers::pi)},
              {"color", {{"r", colour[0]}, {"g", colour[1]}, {"b", colour[2]}, {"a", 1}}}};
    if (velocity.size() == 3)
      json["velocity"] = {{"x", velocity[0]}, {"y", velocity[1]}, {"z", velocity[2]}};
    channels_.location("/" + uav + "/location", time,
                       json.dump(-1, ' ', false, Json::error_handler_t::replace));
  }

  void plan(const Record& record, const std::string& uav) {
    const std::string name = task_name(record);
    auto way = record.numbers("way");
    if (way.size() < 6 && !ways_[uav].contains(name)) return;
    ways_[uav][name] = std::move(way);
    changed_ways_.emplace(uav, record.at());
  }

  void forget(const Record& record, const std::string& uav) {
    if (record.text("state") != "ended" && record.text("state") != "aborted") return;
    if (ways_[uav].erase(task_name(record)) > 0) changed_ways_.emplace(uav, record.at());
  }

  static std::string task_name(const Record& record) {
    return std::to_string(static_cast<std::int64_t>(record.number("task"))) + " " +
           std::string(record.text("type"));
  }

  /// What changed before `now`: all lines of an instant make one picture.
  void draw_until(MissionTime now) {
    while (!changes_of_air_.empty() && *changes_of_air_.begin() <= now) {
      const MissionTime at = *changes_of_air_.begin();
      changes_of_air_.erase(at);
      if (now == MissionTime::max() && at > drawn_) return;  // after the end of the run
      channels_.geojson("/map/closed_air", unix_time(epoch_, at), air_geojson(info_, at, *frame_));
    }
    drawn_ = now == MissionTime::max() ? drawn_ : now;
    for (auto one = changed_ways_.begin(); one != changed_ways_.end();) {
      const auto& [uav, since] = *one;
      if (since >= now) {
        ++one;
        continue;
      }
      channels_.geojson("/" + uav + "/way", unix_time(epoch_, since),
                        ways_geojson(ways_[uav], html_colour(colours_[uav]), *frame_));
      one = changed_ways_.erase(one);
    }
  }

  const report::RunInfo& info_;
  std::uint64_t epoch_;
  std::optional<Frame> frame_;
  Channels channels_;
  std::map<std::string, std::array<double, 3>> colours_;
  std::map<std::string, std::map<std::string, std::vector<double>>> ways_;  ///< by UAV, by task
  std::map<std::string, MissionTime> changed_ways_;  ///< not drawn yet: UAV, since when
  std::map<std::int64_t, Record> alarms_;
  std::set<MissionTime> changes_of_air_;
  MissionTime drawn_;
};

}  // namespace

void export_run(const report::RunInfo& info, const std::vector<Record>& records,
                mcap::Writer& writer) {
  writer.metadata("skein",
                  {{"scenario", info.scenario},
                   {"seed", std::to_string(info.seed)},
                   {"version", info.version},
                   {"runtime", info.runtime == report::RuntimeKind::kVirtual ? "virtual" : "dds"}});
  Export(info, records, writer).run(records);
}

}  // namespace skein::foxglove
