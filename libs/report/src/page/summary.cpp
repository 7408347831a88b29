// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "reading/field_reader.hpp"
#include "skein/report/report.hpp"
#include "story/statistics.hpp"

namespace skein::report {

namespace {

using Json = nlohmann::ordered_json;

// Millimetres and milliseconds: finer digits are noise, and would hide that two runs agree.
Json number(double value) { return std::isfinite(value) ? std::round(value * 1000.0) / 1000.0 : 0; }

Json optional_number(const std::optional<double>& value) {
  return value ? number(*value) : Json(nullptr);
}

Json expectations(const Journal& journal) {
  Json list = Json::array();
  for (const ExpectationRecord& e : journal.expectations) {
    list.push_back({{"name", e.name}, {"passed", e.passed}, {"seen", e.seen}});
  }
  return list;
}

Json uavs(const Chronology& story, const Statistics& figures) {
  Json list = Json::array();
  for (std::size_t i = 0; i < story.uavs.size(); ++i) {
    const UavFigures& f = figures.uavs[i];
    list.push_back({{"name", story.uavs[i].name},
                    {"distance_m", number(f.distance)},
                    {"airborne_s", number(f.airborne)},
                    {"max_altitude_m", optional_number(f.max_altitude)},
                    {"max_speed_m_s", number(f.max_speed)},
                    {"energy_used", optional_number(f.energy_used)},
                    {"tasks", f.tasks},
                    {"ended", f.ended},
                    {"aborted", f.aborted}});
  }
  return list;
}

Json separation(const Chronology& story, const Statistics& figures) {
  if (!figures.separation) return nullptr;
  const Separation& s = *figures.separation;
  return {{"metres", number(s.metres)},
          {"at_s", number(s.t)},
          {"between", Json::array({story.uavs[s.first].name, story.uavs[s.second].name})}};
}

Json channels(const Statistics& figures) {
  Json list = Json::array();
  for (const auto& [key, f] : figures.channels) {
    const auto& [slot, from, to] = key;
    const bool timed = !f.latencies.empty();
    list.push_back({{"slot", slot},
                    {"from", from},
                    {"to", to},
                    {"sent", f.sent},
                    {"received", f.received},
                    {"lost", f.lost},
                    {"expired", f.expired},
                    {"latency_median_s", timed ? number(quantile(f.latencies, 0.5)) : Json()},
                    {"latency_p95_s", timed ? number(quantile(f.latencies, 0.95)) : Json()}});
  }
  return list;
}

}  // namespace

std::string summary_json(const RunInfo& info, const Journal& journal) {
  Journal ordered = journal;
  sort_by_time(ordered);
  const Chronology story = tell(info, ordered);
  const Statistics figures = measure(story, ordered);
  Json j;
  j["scenario"] = info.scenario;
  j["passed"] = figures.ok();
  j["outcome"] = ordered.missions.empty() ? "" : ordered.missions.back().state;
  j["runtime"] = info.runtime == RuntimeKind::kDds ? "dds" : "virtual";
  j["rate"] = number(info.rate);
  j["seed"] = info.seed;
  j["version"] = info.version;
  j["mission_seconds"] = number(story.time.to - story.time.from);
  j["wall_seconds"] = number(info.wall_seconds);
  j["expectations"] = expectations(ordered);
  j["uavs"] = uavs(story, figures);
  j["separation"] = separation(story, figures);
  j["messages"] = channels(figures);
  j["log_lines"] = figures.lines;
  j["unreadable_lines"] = journal.unreadable;
  return j.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace skein::report
