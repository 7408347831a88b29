// SPDX-License-Identifier: Apache-2.0
#include "refinery/outlook.hpp"

#include <cmath>

namespace skein::supervisor {

using refiners::Way;
using world::Vector3;

namespace {

constexpr double kSameView = 0.02;  // parts of a zone seen that are no reason to wait

}  // namespace

bool Outlook::Prospect::beats(const Prospect& other) const {
  if (std::isinf(seconds) || std::isinf(other.seconds)) return seconds < other.seconds;
  if (std::abs(unseen - other.unseen) > kSameView) return unseen < other.unseen;
  return seconds < other.seconds;
}

std::optional<double> Outlook::worth_waiting(const Vector3& from, const Departure& when,
                                             const Venture& venture) const {
  if (!air_.has_windows() || std::isinf(when.most)) return std::nullopt;
  Prospect best = venture(when);
  std::optional<double> wait;
  for (const world::Volume& volume : air_.world().volumes) {
    if (volume.when.until == MissionTime::max()) continue;
    const double longest = (volume.when.until - air_.origin()).to_seconds() - when.least;
    if (longest <= 0 || (best.unseen <= kSameView && longest >= best.seconds)) continue;
    if (!air_.may_stay(from, when, longest)) continue;
    Prospect later = venture(when.after(longest));
    later.seconds += longest;
    if (!later.beats(best)) continue;
    best = later;
    wait = longest;
  }
  return wait;
}

std::optional<Outlook::Arrival> Outlook::arrival(const Vector3& from, const Vector3& to,
                                                 const Departure& when) {
  Arrival at{when, 0};
  Vector3 start = from;
  const auto done = [&at](const Times& times) {
    at.then = at.then.after(times);
    at.seconds += times.expected;
  };
  if (air_.gazetteer().on_ground(from) && !air_.vehicle().ground) {
    const auto up = ways_.takeoff(from, when);
    if (!up) return std::nullopt;
    done(up->times);
    start = up->way.back();
    if (!air_.may_stay(start, at.then, 0)) return std::nullopt;
  }
  const auto there = ways_.path(start, to, at.then);
  if (!there) return std::nullopt;
  done(there->times);
  return at;
}

Outlook::Prospect Outlook::of_way(const Vector3& from, const Vector3& to, double stay,
                                  const Departure& when) {
  const auto there = arrival(from, to, when);
  if (!there || (stay > 0 && !air_.may_stay(to, there->then, stay))) return {};
  return {0, there->seconds};
}

Outlook::Prospect Outlook::of_patrol(const Vector3& from, const Vector3& to,
                                     const world::Zone& zone, const world::SensorModel& device,
                                     double seconds, const Departure& when) {
  const auto there = arrival(from, to, when);
  if (!there) return {};
  const auto motion = patrols_.over(to, zone, device, seconds, there->then);
  return motion ? Prospect{0, there->seconds + motion->times.expected} : Prospect{};
}

Outlook::Prospect Outlook::of_pattern(const Vector3& from, const Answer<Motion>& motion,
                                      const Departure& when) {
  if (!motion) return {};
  const auto there = arrival(from, motion->way.front(), when);
  if (!there || !air_.stays_open(motion->way, there->then)) return {};
  return {1 - motion->seen, there->seconds + motion->times.expected};
}

Outlook::Prospect Outlook::of_sweep(const Vector3& from, const world::Zone& zone,
                                    const world::SensorModel& device, const Departure& when) {
  return of_pattern(from, sweeps_.over(from, zone, device, when), when);
}

Outlook::Prospect Outlook::of_rest(const Vector3& from, const Way& way,
                                   const world::SensorModel& device,
                                   const world::SensorModel& before, const Departure& when) {
  return of_pattern(from, sweeps_.rest(from, way, device, before, when), when);
}

}  // namespace skein::supervisor
