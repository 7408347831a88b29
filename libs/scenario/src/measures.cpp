// SPDX-License-Identifier: Apache-2.0
#include "measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace skein::scenario {

namespace {

using Records = std::vector<journal::Record>;
using Position = std::vector<double>;

double distance(const Position& a, const Position& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

bool wanted(const std::vector<std::string>& uavs, std::string_view uav) {
  return uavs.empty() || std::find(uavs.begin(), uavs.end(), uav) != uavs.end();
}

// Calls use(record, uav) for each telemetry record of the UAVs that has a position.
template <class Use>
void for_telemetry(const std::vector<std::string>& uavs, const Records& records, Use use) {
  for (const auto& record : records) {
    if (record.kind() != "telemetry" || !wanted(uavs, record.text("uav"))) continue;
    if (record.numbers("position").size() == 3) use(record, std::string(record.text("uav")));
  }
}

// The UAVs' telemetry comes at common instants; each new position is compared with the others'
// last, if those are not older than this.
constexpr double kSameInstant = 0.5;

tl::expected<Measured, std::string> minimum_separation(const std::vector<std::string>& uavs,
                                                       const Records& records) {
  struct Last {
    MissionTime at;
    Position position;
    bool airborne;
  };
  std::map<std::string, Last> last;
  Measured least{std::numeric_limits<double>::infinity(), ""};
  for_telemetry(uavs, records, [&](const journal::Record& record, const std::string& uav) {
    const Last now{record.at(), record.numbers("position"), record.truth("airborne")};
    for (const auto& [name, other] : last) {
      const bool together = (now.at - other.at).to_seconds() <= kSameInstant;
      if (name != uav && together && now.airborne && other.airborne) {
        const double apart = distance(now.position, other.position);
        if (apart >= least.value) continue;
        least = {apart, " m (" + name + " and " + uav + " at " + to_text(now.at) + " s)"};
      }
    }
    last.insert_or_assign(uav, now);
  });
  if (std::isinf(least.value))
    return tl::unexpected<std::string>("no two UAVs were airborne together");
  return least;
}

tl::expected<Measured, std::string> distance_flown(const std::vector<std::string>& uavs,
                                                   const Records& records) {
  std::map<std::string, Position> last;
  double sum = 0;
  for_telemetry(uavs, records, [&](const journal::Record& record, const std::string& uav) {
    const Position position = record.numbers("position");
    const auto before = last.find(uav);
    if (before != last.end()) sum += distance(before->second, position);
    last.insert_or_assign(uav, position);
  });
  if (last.empty()) return tl::unexpected<std::string>("no telemetry");
  return Measured{sum, " m"};
}

tl::expected<Measured, std::string> energy_left(const std::vector<std::string>& uavs,
                                                const Records& records) {
  std::map<std::string, double> last;
  for_telemetry(uavs, records, [&](const journal::Record& record, const std::string& uav) {
    last[uav] = record.number("energy");
  });
  if (last.empty()) return tl::unexpected<std::string>("no telemetry");
  const auto least = std::min_element(
      last.begin(), last.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return Measured{least->second, " (" + least->first + ")"};
}

tl::expected<Measured, std::string> mission_duration(const Records& records) {
  for (const auto& record : records) {
    if (record.kind() == "mission" && record.text("state") == "finished") {
      return Measured{record.at().to_seconds(), " s"};
    }
  }
  return tl::unexpected<std::string>("the mission did not finish");
}

}  // namespace

tl::expected<Measured, std::string> measure(ExpectMeasure::Quantity quantity,
                                            const std::vector<std::string>& uavs,
                                            const std::vector<journal::Record>& records) {
  switch (quantity) {
    case ExpectMeasure::Quantity::kMinimumSeparation:
      return minimum_separation(uavs, records);
    case ExpectMeasure::Quantity::kDistanceFlown:
      return distance_flown(uavs, records);
    case ExpectMeasure::Quantity::kMissionDuration:
      return mission_duration(records);
    case ExpectMeasure::Quantity::kEnergyLeft:
      break;
  }
  return energy_left(uavs, records);
}

}  // namespace skein::scenario
