// SPDX-License-Identifier: Apache-2.0
// Air that is closed for a time: which of it counts, and whether waiting for it is worth while.
#include <algorithm>
#include <cmath>

#include "closed_air.hpp"
#include "refinery.hpp"

namespace skein::supervisor {

using refiners::Way;
using world::Vector3;

namespace {

constexpr double kSameView = 0.02;  // parts of a zone seen that are no reason to wait

}  // namespace

bool Refinery::Prospect::beats(const Prospect& other) const {
  if (std::isinf(seconds) || std::isinf(other.seconds)) return seconds < other.seconds;
  if (std::abs(unseen - other.unseen) > kSameView) return unseen < other.unseen;
  return seconds < other.seconds;
}

world::TimeWindow Refinery::window(const Departure& when, double seconds) const {
  const auto at = [&](double s) {
    return std::isinf(s) ? MissionTime::max() : origin_ + Duration::seconds(s);
  };
  return {at(when.least), at(when.most + seconds)};
}

Refinery::Counted Refinery::counted(const Departure& when, double seconds) const {
  const world::TimeWindow flight = window(when, seconds);
  Counted all;
  for (const world::Volume& volume : world().volumes) {
    const bool touches = volume.when.overlaps(flight) || volume.when.from == flight.from;
    const bool lasts = volume.when.from <= flight.from && flight.until <= volume.when.until;
    all.push_back(when.suited ? lasts : touches);
  }
  return all;
}

Refinery::Volumes Refinery::closed() const { return closed(counted({}, 0)); }

Refinery::Volumes Refinery::closed(const Counted& counted) const {
  Volumes all;
  for (std::size_t i = 0; i < counted.size(); ++i)
    if (counted[i] && world().volumes[i].polygon.size() > 2) all.push_back(world().volumes[i]);
  return all;
}

Answer<Motion> Refinery::kept_clear(const Vector3& from, const Departure& when, double seconds,
                                    const Planner& plan) const {
  Counted counts = counted(when, seconds);
  while (true) {
    auto motion = plan(counts);
    if (!motion || !has_windows_) return motion;
    const Vector3& first = motion->way.front();
    const double approach = first == from ? 0 : flown({from, first}).times.most;
    Counted all = counted(when, approach + motion->times.most);
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = all[i] || counts[i];
    if (all == counts) return motion;
    counts = std::move(all);
  }
}

bool Refinery::may_stay(const Vector3& at, const Departure& when, double seconds) const {
  return gazetteer_.on_ground(at) || has_room(at, closed(counted(when, seconds)));
}

bool Refinery::stays_open(const Vector3& at, const Departure& when, double seconds) const {
  if (!has_windows_ || gazetteer_.on_ground(at)) return true;
  Counted closing = counted(when, seconds);
  const Counted before = counted({when.least, when.least}, 0);
  for (std::size_t i = 0; i < closing.size(); ++i) closing[i] = closing[i] && !before[i];
  return has_room(at, closed(closing));
}

bool Refinery::stays_open(const Way& way, const Departure& when) const {
  return !has_windows_ || !met(way, closed(counted(when, flown(way).times.most)));
}

std::optional<double> Refinery::worth_waiting(const Vector3& from, const Departure& when,
                                              const Venture& venture) const {
  if (!has_windows_ || std::isinf(when.most)) return std::nullopt;
  Prospect best = venture(when);
  std::optional<double> wait;
  for (const world::Volume& volume : world().volumes) {
    if (volume.when.until == MissionTime::max()) continue;
    const double longest = (volume.when.until - origin_).to_seconds() - when.least;
    if (longest <= 0 || (best.unseen <= kSameView && longest >= best.seconds)) continue;
    if (!may_stay(from, when, longest)) continue;
    Prospect later = venture(when.after(longest));
    later.seconds += longest;
    if (!later.beats(best)) continue;
    best = later;
    wait = longest;
  }
  return wait;
}

std::optional<Refinery::Arrival> Refinery::arrival(const Vector3& from, const Vector3& to,
                                                   const Departure& when) {
  Arrival at{when, 0};
  Vector3 start = from;
  const auto done = [&at](const Times& times) {
    at.then = at.then.after(times);
    at.seconds += times.expected;
  };
  if (gazetteer_.on_ground(from)) {
    const auto up = takeoff(from, when);
    if (!up) return std::nullopt;
    done(up->times);
    start = up->way.back();
    if (!may_stay(start, at.then, 0)) return std::nullopt;
  }
  const auto there = path(start, to, at.then);
  if (!there) return std::nullopt;
  done(there->times);
  return at;
}

Refinery::Prospect Refinery::of_way(const Vector3& from, const Vector3& to, double stay,
                                    const Departure& when) {
  const auto there = arrival(from, to, when);
  if (!there || (stay > 0 && !may_stay(to, there->then, stay))) return {};
  return {0, there->seconds};
}

Refinery::Prospect Refinery::of_patrol(const Vector3& from, const Vector3& to,
                                       const world::Zone& zone, const world::SensorModel& device,
                                       double seconds, const Departure& when) {
  const auto there = arrival(from, to, when);
  if (!there) return {};
  const auto motion = patrol(to, zone, device, seconds, there->then);
  return motion ? Prospect{0, there->seconds + motion->times.expected} : Prospect{};
}

Refinery::Prospect Refinery::of_pattern(const Vector3& from, const Answer<Motion>& motion,
                                        const Departure& when) {
  if (!motion) return {};
  const auto there = arrival(from, motion->way.front(), when);
  if (!there || !stays_open(motion->way, there->then)) return {};
  return {1 - motion->seen, there->seconds + motion->times.expected};
}

Refinery::Prospect Refinery::of_sweep(const Vector3& from, const world::Zone& zone,
                                      const world::SensorModel& device, const Departure& when) {
  return of_pattern(from, sweep(from, zone, device, when), when);
}

Refinery::Prospect Refinery::of_rest(const Vector3& from, const Way& way,
                                     const world::SensorModel& device,
                                     const world::SensorModel& before, const Departure& when) {
  return of_pattern(from, rest(from, way, device, before, when), when);
}

}  // namespace skein::supervisor
