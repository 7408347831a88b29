// SPDX-License-Identifier: Apache-2.0
#include "skein/scenario/measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "reading.hpp"
#include "skein/foundation/rounded_seconds.hpp"

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
        least = {apart, " m (" + name + " and " + uav + " at " + in_seconds(now.at) + ")"};
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

bool holds(const Closure& closure, MissionTime at, const Position& p) {
  const world::Volume& volume = closure.volume;
  return at >= closure.when.from && at < closure.when.until && p[2] >= volume.floor &&
         p[2] < volume.ceiling && world::contains(volume.polygon, {p[0], p[1]});
}

std::vector<Closure> closures_of(const std::vector<ClosedAir>& air, const Records& records) {
  std::vector<Closure> closures;
  const auto first = [&](const Pattern& pattern, MissionTime from) {
    const auto found = std::find_if(records.begin(), records.end(), [&](const auto& record) {
      return record.at() >= from && pattern.matches(record);
    });
    return found == records.end() ? MissionTime::max() : found->at();
  };
  for (const ClosedAir& one : air) {
    world::TimeWindow when = one.volume.when;
    const MissionTime closed = one.closed_by ? first(*one.closed_by, {}) : MissionTime();
    when.from = std::max(when.from, closed);
    if (one.opened_by) when.until = std::min(when.until, first(*one.opened_by, closed));
    closures.push_back({one.volume, when});
  }
  return closures;
}

tl::expected<Measured, std::string> time_in_volume(const ExpectMeasure& wanted,
                                                   const Records& records) {
  const std::vector<Closure> closures = closures_of(wanted.air, records);
  std::map<std::string, std::optional<MissionTime>> inside;  // since when, by UAV
  Measured sum{0, " s"};
  for_telemetry(wanted.uavs, records, [&](const journal::Record& record, const std::string& uav) {
    auto& since = inside[uav];
    if (since) sum.value += (record.at() - *since).to_seconds();
    since.reset();
    if (!record.truth("airborne")) return;
    const Position position = record.numbers("position");
    for (const Closure& closure : closures) {
      if (!holds(closure, record.at(), position)) continue;
      since = record.at();
      if (sum.context == " s") {
        sum.context +=
            " (" + uav + " in " + closure.volume.name + " at " + to_text(record.at()) + " s first)";
      }
      break;
    }
  });
  if (inside.empty()) return tl::unexpected<std::string>("no telemetry");
  return sum;
}

}  // namespace

tl::expected<Measured, std::string> measure(const ExpectMeasure& wanted, const Records& records) {
  switch (wanted.quantity) {
    case ExpectMeasure::Quantity::kMinimumSeparation:
      return minimum_separation(wanted.uavs, records);
    case ExpectMeasure::Quantity::kDistanceFlown:
      return distance_flown(wanted.uavs, records);
    case ExpectMeasure::Quantity::kTimeInVolume:
      return time_in_volume(wanted, records);
    case ExpectMeasure::Quantity::kMissionDuration:
      return mission_duration(records);
    case ExpectMeasure::Quantity::kEnergyLeft:
      break;
  }
  return energy_left(wanted.uavs, records);
}

std::vector<Closure> closures_of(const Scenario& scenario, const Records& records) {
  return closures_of(closed_air_of(scenario), records);
}

namespace {

using Quantity = ExpectMeasure::Quantity;

struct About {
  std::string_view name, unit;
};

constexpr std::array<About, 5> kAll{{{"minimum-separation", "m"},
                                     {"distance-flown", "m"},
                                     {"mission-duration", "s"},
                                     {"energy-left", ""},
                                     {"time-in-volume", "s"}}};

const About& about(Quantity quantity) { return kAll.at(static_cast<std::size_t>(quantity)); }

NamedMeasure of_all(Quantity quantity) {
  ExpectMeasure what;
  what.quantity = quantity;
  return {std::string(name_of(quantity)), std::move(what)};
}

}  // namespace

std::string_view name_of(Quantity quantity) { return about(quantity).name; }

std::string_view unit_of(Quantity quantity) { return about(quantity).unit; }

std::string_view unit_of(const std::string& measure) {
  const std::string_view quantity = std::string_view(measure).substr(0, measure.find(' '));
  const auto* found = std::find_if(kAll.begin(), kAll.end(),
                                   [&](const About& one) { return one.name == quantity; });
  return found == kAll.end() ? std::string_view() : found->unit;
}

std::vector<NamedMeasure> measures_of_any_run() {
  return {of_all(Quantity::kMissionDuration), of_all(Quantity::kDistanceFlown),
          of_all(Quantity::kEnergyLeft), of_all(Quantity::kMinimumSeparation)};
}

std::vector<NamedMeasure> measures_of(const Scenario& scenario) {
  std::vector<NamedMeasure> all = measures_of_any_run();
  const std::vector<ClosedAir> air = closed_air_of(scenario);
  if (!air.empty()) {
    all.push_back(of_all(Quantity::kTimeInVolume));
    all.back().what.air = air;
  }
  for (const Expectation& expectation : scenario.expectations) {
    const auto* measure = std::get_if<ExpectMeasure>(&expectation.what);
    if (measure == nullptr) continue;
    NamedMeasure one{std::string(name_of(measure->quantity)), *measure};
    for (const std::string& uav : measure->uavs) one.name += " " + uav;
    const bool known = std::any_of(
        all.begin(), all.end(), [&](const NamedMeasure& other) { return other.name == one.name; });
    if (!known) all.push_back(std::move(one));
  }
  return all;
}

}  // namespace skein::scenario
