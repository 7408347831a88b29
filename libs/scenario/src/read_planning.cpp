// SPDX-License-Identifier: Apache-2.0
// The parts of a scenario about deliberation on board, closed air, and what differs between runs.
#include <algorithm>
#include <filesystem>
#include <numbers>

#include "reading.hpp"
#include "skein/foundation/nearest.hpp"

namespace skein::scenario {

namespace {

using config::Range;
using config::Reader;

constexpr Range kFraction{0, 1, ""};
constexpr std::int64_t kGreatestFirstId = 400'000'000;  // a decision node's own tasks come later
constexpr Range kLevel{-10'000, 100'000, "m"};

world::RiskPeaks read_peaks(const Reader& reader) {
  world::RiskPeaks peaks;
  if (!reader.keys({"peaks", "base"})) return peaks;
  peaks.base = reader.optional("base").number(0, kFraction);
  for (const Reader& peak : items_of(reader.required("peaks"))) {
    if (!peak.keys({"at", "risk", "radius"})) continue;
    peaks.peaks.push_back({read_point_2d(peak.required("at")),
                           peak.required("risk").number(0, kFraction),
                           peak.required("radius").number(1, {1, world::kFarthest, "m"})});
  }
  return peaks;
}

world::GroundRequest read_risk(const Reader& reader) {
  world::GroundRequest ground;
  ground.mark = {reader.line(), reader.path()};
  if (reader.is_map()) {
    ground.risk = read_peaks(reader);
  } else {
    ground.risk = reader.number(0.5, kFraction);
  }
  return ground;
}

// {UAV: figure, …}, each figure as `read` has it.
template <class Read>
auto read_by_uav(const Reader& reader, const Names& names, Read read) {
  std::map<std::string, decltype(read(reader))> by_uav;
  for (const auto& [uav, figure] : entries_of(reader)) {
    if (std::find(names.uavs.begin(), names.uavs.end(), uav) == names.uavs.end()) {
      figure.error("no UAV '" + uav + "'", "a UAV", nearest_name(uav, names.uavs));
    }
    by_uav.emplace(uav, read(figure));
  }
  return by_uav;
}

executive::TaskId read_first_id(const Reader& reader) {
  return executive::TaskId(static_cast<std::uint64_t>(reader.integer(1, 1, kGreatestFirstId)));
}

double read_altitude(const Reader& reader) {
  return reader.number(40, {2, 10'000, "m above the ground"});
}

std::optional<Variations::Range> read_range(const Reader& reader, Range within) {
  if (!reader.present()) return std::nullopt;
  const std::vector<double> bounds = reader.numbers(2, within);
  if (bounds.size() != 2) return std::nullopt;
  if (bounds[1] < bounds[0]) reader.error("no figure is between these", "[LEAST, MOST]");
  return Variations::Range{bounds[0], bounds[1]};
}

std::optional<temporal::Algorithm> read_consistency(const Reader& reader) {
  using temporal::Algorithm;
  constexpr std::array kAlgorithms{Algorithm::kDipM, Algorithm::kDipL, Algorithm::kDipG,
                                   Algorithm::kCip};
  const auto which = reader.choice({"dip-m", "dip-l", "dip-g", "cip", "none"});
  if (which >= kAlgorithms.size()) return std::nullopt;
  return kAlgorithms[which];
}

}  // namespace

std::optional<PlanningSpec> read_planning(const Reader& reader, const std::string& folder,
                                          const Names& names) {
  if (!reader.present()) return std::nullopt;
  PlanningSpec planning;
  if (!reader.keys({"domain", "altitude", "voxel", "ceiling", "risk", "horizon", "first_ids",
                    "altitudes", "consistency", "partner_lease", "takes"})) {
    return planning;
  }
  const Reader domain = reader.required("domain");
  planning.domain_file = domain.text();
  if (!planning.domain_file.empty()) {
    planning.domain_path = (std::filesystem::path(folder) / planning.domain_file).string();
    planning.domain = read_text_of(domain, "domain file", planning.domain_path).value_or("");
  }
  planning.altitude = read_altitude(reader.optional("altitude"));
  planning.altitudes = read_by_uav(reader.optional("altitudes"), names, read_altitude);
  planning.voxel = reader.optional("voxel").number(10, {0.1, 10'000, "m"});
  const Reader ceiling = reader.optional("ceiling");
  if (ceiling.present()) planning.ceiling = ceiling.number(0, kLevel);
  planning.ground = read_risk(reader.optional("risk"));
  planning.horizon = read_seconds(reader.optional("horizon"), planning.horizon);
  planning.consistency = read_consistency(reader.optional("consistency"));
  planning.partner_lease =
      Duration::seconds(reader.optional("partner_lease")
                            .number(planning.partner_lease.to_seconds(), {60, 86'400, "s"}));
  if (const auto takes = read_range(reader.optional("takes"), {0, 600, "s"})) {
    planning.takes_least = Duration::seconds(takes->low);
    planning.takes_most = Duration::seconds(takes->high);
  }
  planning.first_ids = read_by_uav(reader.optional("first_ids"), names, read_first_id);
  return planning;
}

void read_variations(const Reader& reader, Variations& variations) {
  constexpr double kTurn = 2 * std::numbers::pi;
  if (!reader.present()) return;
  reader.keys({"wind_speed", "wind_toward", "speed_factor", "latency", "loss", "start_delay"});
  variations.wind_speed = read_range(reader.optional("wind_speed"), {0, 50, "m/s"});
  variations.wind_toward = read_range(reader.optional("wind_toward"), {-kTurn, kTurn, "rad"});
  variations.speed_factor = read_range(reader.optional("speed_factor"), {0.1, 2, ""});
  variations.latency = read_range(reader.optional("latency"), {0, 10, "s"});
  variations.loss = read_range(reader.optional("loss"), {0, 0.99, ""});
  variations.start_delay = read_range(reader.optional("start_delay"), {0, 3600, "s"});
}

}  // namespace skein::scenario
