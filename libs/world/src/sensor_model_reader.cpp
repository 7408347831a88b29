// SPDX-License-Identifier: Apache-2.0
#include "sensor_model_reader.hpp"

#include <limits>
#include <numbers>
#include <utility>

#include "skein/world/environment_reader.hpp"

namespace skein::world {
namespace {

using config::Range;
using config::Reader;

/// Least value of what must be greater than zero.
constexpr double kLeast = 1e-3;
/// What is wrong already compares false with everything, so that it gives no second error.
constexpr double kWrong = std::numeric_limits<double>::quiet_NaN();
constexpr double kRightAngle = std::numbers::pi / 2;
constexpr Range kDistance = {kLeast, 1e5, "m"};
constexpr Range kSpread = {0, 1e4, "m"};
constexpr Range kFraction = {0, 1, ""};
constexpr Range kPeriod = {0.01, 3600, "s"};

Duration seconds(const Reader& reader, Range range) {
  return Duration::seconds(reader.number(range.low, range));
}

void read_responses(const Reader& reader, SensorModel& sensor) {
  for (const auto& [kind, entry] : reader.entries()) {
    entry.keys({"probability", "confidence", "reported_as"});
    SensorResponse response;
    response.probability = entry.required("probability").number(0, kFraction);
    response.confidence = entry.required("confidence").number(0, kFraction);
    response.reported_as = entry.optional("reported_as").text(kind);
    if (!entry.present()) entry.error("missing", "a map with probability and confidence");
    if (response.reported_as.empty()) entry.error("reported_as is empty", "a kind of object");
    sensor.responses[kind] = response;
  }
  if (sensor.responses.empty()) reader.error("sees nothing", "at least one kind of object");
}

void read_false_alarms(const Reader& reader, SensorModel& sensor) {
  if (!reader.present()) return;
  reader.keys({"rate", "kind", "confidence"});
  sensor.false_alarm_rate = reader.required("rate").number(0, {0, 100, "1/s"});
  sensor.false_alarm_kind = reader.required("kind").text();
  sensor.false_alarm_confidence = reader.required("confidence").number(0, kFraction);
}

/// After the range, which it must fit.
void read_quality(const Reader& reader, SensorModel& sensor) {
  if (!reader.present()) return;
  if (!reader.keys({"best_distance", "at_range", "incidence_power"})) return;
  QualityModel& quality = sensor.quality;
  const Reader best = reader.optional("best_distance");
  quality.best_distance = best.number(0, {0, kDistance.high, "m"});
  quality.at_range = reader.optional("at_range").number(1, kFraction);
  quality.incidence_power = reader.optional("incidence_power").number(0, {0, 10, ""});
  if (quality.best_distance > sensor.range)
    best.error("best_distance is greater than the range", "at most the range");
}

/// {reports: {KIND: [if there is a fire, if not]}, confirms, limit}.
std::optional<SensorEvidence> read_evidence(const Reader& reader) {
  if (!reader.present() || !reader.keys({"reports", "confirms", "limit"})) return std::nullopt;
  SensorEvidence evidence;
  Likelihood sum;
  for (const auto& [kind, entry] : reader.required("reports").entries()) {
    const std::vector<double> pair = entry.numbers(2, {kLeast, 1 - kLeast, ""});
    if (pair.size() != 2) continue;
    evidence.kinds[kind] = {pair[0], pair[1]};
    sum.if_fire += pair[0];
    sum.if_not_fire += pair[1];
  }
  if (sum.if_fire >= 1 || sum.if_not_fire >= 1)
    reader.error("all kinds together are reported at every look or more often",
                 "likelihoods that add up to less than 1");
  evidence.confirms = reader.optional("confirms").boolean(false);
  evidence.limit = reader.optional("limit").number(evidence.limit, {0.1, 100, "log-odds"});
  return evidence;
}

std::vector<std::string> read_uses(const Reader& reader) {
  std::vector<std::string> uses;
  for (const Reader& use : items_of(reader)) {
    uses.push_back(use.text());
    const bool word =
        uses.back().find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos;
    if (use.is_scalar() && (uses.back().empty() || !word))
      use.error("'" + uses.back() + "'", "a use that the planning domain knows: detection");
  }
  return uses;
}

}  // namespace

SensorModel read_sensor(const std::string& device, const Reader& reader) {
  reader.keys({"aperture", "pitch", "gimballed", "range", "period", "position_spread",
               "false_alarms", "sees", "quality", "cost", "evidence", "serves"});
  SensorModel sensor;
  sensor.device = device;
  sensor.aperture = reader.required("aperture").number(kLeast, {kLeast, kRightAngle, "rad"});
  sensor.boresight_pitch =
      reader.required("pitch").number(0, {-kRightAngle - 1e-3, kRightAngle, "rad"});
  sensor.gimballed = reader.optional("gimballed").boolean(false);
  sensor.range = reader.required("range").number(kWrong, kDistance);
  sensor.period = seconds(reader.required("period"), kPeriod);
  sensor.position_spread = reader.required("position_spread").number(0, kSpread);
  read_false_alarms(reader.optional("false_alarms"), sensor);
  read_responses(reader.required("sees"), sensor);
  read_quality(reader.optional("quality"), sensor);
  sensor.cost = reader.optional("cost").number(0, kFraction);
  sensor.evidence = read_evidence(reader.optional("evidence"));
  sensor.serves = read_uses(reader.optional("serves"));
  return sensor;
}

}  // namespace skein::world
