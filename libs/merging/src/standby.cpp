// SPDX-License-Identifier: Apache-2.0
#include "skein/merging/standby.hpp"

#include <algorithm>

namespace skein::merging {

namespace {

constexpr Duration kUnanswered = Duration::milliseconds(2'000);  ///< it is asked for again
constexpr Duration kRefused = Duration::milliseconds(5'000);     ///< likewise, others have it

}  // namespace

void Standby::need(Volumes volumes, MissionTime now) {
  if (volumes == volumes_) return;
  volumes_ = std::move(volumes);
  replace(now);
}

void Standby::replace(MissionTime now) {
  request_ = 0;
  kept_ = false;
  due_ = volumes_.empty() ? std::nullopt : std::optional(now);
}

void Standby::ask(std::uint64_t request, MissionTime now) {
  request_ = request;
  due_ = now + kUnanswered;
}

void Standby::answered(bool granted, MissionTime now) {
  kept_ = granted;
  if (granted) return due_.reset();
  request_ = 0;
  due_ = now + kRefused;
}

bool Standby::keeps(const Volumes& air) const {
  return kept_ && std::all_of(air.begin(), air.end(), [&](const Volume& piece) {
           return std::any_of(volumes_.begin(), volumes_.end(),
                              [&](const Volume& one) { return contains(one, piece); });
         });
}

}  // namespace skein::merging
