// SPDX-License-Identifier: Apache-2.0
#include "story/statistics.hpp"

#include <algorithm>
#include <cmath>

namespace skein::report {

namespace {

double distance(const Position& a, const Position& b) {
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

/// Of one that was never in the air all of its way counts: it drove.
UavFigures figures_of(const UavStory& uav) {
  UavFigures f;
  const bool drives = uav.keeps_to_ground();
  for (std::size_t i = 0; i < uav.track.size(); ++i) {
    const TrackPoint& p = uav.track[i];
    f.max_altitude = std::max(f.max_altitude.value_or(p.position.z), p.position.z);
    f.max_speed = std::max(f.max_speed, p.speed);
    const bool flew = i > 0 && (p.airborne || uav.track[i - 1].airborne);
    if (i > 0 && (flew || drives)) f.distance += distance(uav.track[i - 1].position, p.position);
    if (flew) f.airborne += p.t - uav.track[i - 1].t;
  }
  if (!uav.track.empty()) f.energy_used = uav.track.front().energy - uav.track.back().energy;
  return f;
}

// At the samples of one, where the other is between two of its own.
void look_from(const Chronology& c, std::size_t one, std::size_t other,
               std::optional<Separation>& best) {
  const std::vector<TrackPoint>& track = c.uavs[other].track;
  std::size_t k = 0;
  for (const TrackPoint& p : c.uavs[one].track) {
    while (k + 1 < track.size() && track[k + 1].t <= p.t) ++k;
    if (!p.airborne || track.empty() || track[k].t > p.t) continue;
    // Walk along with the other track instead of searching it: the whole is linear.
    const std::size_t next = std::min(k + 1, track.size() - 1);
    const std::optional<TrackPoint> q = between(track[k], track[next], p.t);
    if (!q || !q->airborne) continue;
    const double metres = distance(p.position, q->position);
    const bool closer = !best || metres < best->metres;
    if (closer) best = Separation{metres, p.t, std::min(one, other), std::max(one, other)};
  }
}

std::optional<Separation> closest(const Chronology& c) {
  std::optional<Separation> best;
  for (std::size_t a = 0; a < c.uavs.size(); ++a) {
    for (std::size_t b = a + 1; b < c.uavs.size(); ++b) {
      look_from(c, a, b, best);
      look_from(c, b, a, best);
    }
  }
  return best;
}

void count_messages(const Chronology& c, const Journal& journal,
                    std::map<ChannelKey, ChannelFigures>& channels) {
  for (const Flight& m : c.messages) {
    ChannelFigures& f = channels[{m.what, m.from, m.to}];
    f.sent += m.sent ? 1 : 0;
    f.received += m.received ? 1 : 0;
    if (m.sent && m.received && *m.received >= *m.sent) {
      f.latencies.push_back(*m.received - *m.sent);
    }
  }
  for (const UndeliveredRecord& r : journal.undelivered) {
    ChannelFigures& f = channels[{r.slot, r.stamp.node, r.to}];
    ++(r.expired ? f.expired : f.lost);
  }
  for (auto& [key, f] : channels) std::sort(f.latencies.begin(), f.latencies.end());
}

std::size_t count_lines(const Journal& journal) {
  return std::apply([](const auto&... records) { return (records.size() + ...); },
                    records_of(journal));
}

}  // namespace

Statistics measure(const Chronology& c, const Journal& journal) {
  Statistics s;
  for (const UavStory& uav : c.uavs) s.uavs.push_back(figures_of(uav));
  for (const TaskBar& bar : c.tasks) {
    UavFigures& f = s.uavs[bar.uav];
    ++f.tasks;
    f.ended += bar.outcome == TaskState::kEnded ? 1 : 0;
    f.aborted += bar.outcome == TaskState::kAborted ? 1 : 0;
  }
  s.separation = closest(c);
  count_messages(c, journal, s.channels);
  s.lines = count_lines(journal);
  for (const ExpectationRecord& e : journal.expectations) ++(e.passed ? s.passed : s.failed);
  return s;
}

std::vector<std::pair<double, double>> separation_series(const Chronology& c, std::size_t samples) {
  std::vector<std::pair<double, double>> series;
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = c.time.from + (c.time.to - c.time.from) * static_cast<double>(i) /
                                       static_cast<double>(std::max<std::size_t>(samples - 1, 1));
    std::vector<Position> flying;
    for (const UavStory& uav : c.uavs) {
      const std::optional<TrackPoint> p = at(uav.track, t);
      if (p && p->airborne) flying.push_back(p->position);
    }
    std::optional<double> least;
    for (std::size_t a = 0; a < flying.size(); ++a) {
      for (std::size_t b = a + 1; b < flying.size(); ++b) {
        const double d = distance(flying[a], flying[b]);
        least = std::min(least.value_or(d), d);
      }
    }
    if (least) series.emplace_back(t, *least);
  }
  return series;
}

double quantile(const std::vector<double>& ascending, double share) {
  if (ascending.empty()) return 0.0;
  const double rank = std::ceil(share * static_cast<double>(ascending.size())) - 1.0;
  const double last = static_cast<double>(ascending.size() - 1);
  return ascending[static_cast<std::size_t>(std::clamp(rank, 0.0, last))];
}

}  // namespace skein::report
