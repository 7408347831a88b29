// SPDX-License-Identifier: Apache-2.0
#include "flown.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "skein/foundation/unix_time.hpp"

namespace skein::track_files {
namespace {

using journal::Record;

std::string fixed(double value, int decimals) {
  std::array<char, 330> text{};  // the greatest double has 309 digits before the point
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::fixed, decimals);
  return {text.data(), end.ptr};
}

geodesy::GeodeticFrame frame_of(const report::RunInfo& info) {
  const report::Origin origin = info.origin.value_or(report::Origin());
  return geodesy::GeodeticFrame({origin.latitude, origin.longitude, origin.altitude});
}

}  // namespace

Flown::Flown(const report::RunInfo& info, const std::vector<Record>& records,
             const TrackOptions& options)
    : frame_(frame_of(info)), geoid_(options.geoid), epoch_(epoch_of(info.epoch)) {
  for (const report::UavInfo& uav : info.uavs) tracks_.push_back({uav.name, uav.model, {}});
  for (const report::Place& place : info.places) {
    const auto& at = place.position;
    spots_.push_back({place.name, "place", on_earth(at.x, at.y, at.z)});
  }
  for (const Record& record : records) {
    if (record.kind() == "telemetry") see_telemetry(record);
    if (record.kind() == "alarm") see_alarm(record);
  }
}

world::GeodeticPoint Flown::on_earth(double x, double y, double z) const {
  world::GeodeticPoint point = frame_.to_geodetic({x, y, z});
  point.altitude -= geoid_;
  return point;
}

void Flown::see_telemetry(const Record& record) {
  const auto at = record.numbers("position");
  const auto track = std::find_if(tracks_.begin(), tracks_.end(),
                                  [&](const Track& one) { return one.uav == record.text("uav"); });
  if (at.size() != 3 || track == tracks_.end()) return;
  track->fixes.push_back({unix_time(epoch_, record.at()), on_earth(at[0], at[1], at[2])});
}

void Flown::see_alarm(const Record& record) {
  const auto at = record.numbers("position");
  if (at.size() != 3) return;
  const std::string id =
      "alarm " + std::to_string(static_cast<std::int64_t>(record.number("alarm")));
  const std::string name = id + " " + std::string(record.text("state"));
  const auto known = std::find_if(spots_.begin(), spots_.end(), [&](const Spot& spot) {
    return spot.kind == "alarm" && spot.name.starts_with(id + " ");
  });
  Spot& spot = known == spots_.end() ? spots_.emplace_back() : *known;
  spot = {name, "alarm", on_earth(at[0], at[1], at[2])};
}

std::string degrees(double value) { return fixed(value, 9); }
std::string metres(double value) { return fixed(value, 3); }

}  // namespace skein::track_files
