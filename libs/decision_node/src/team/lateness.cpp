// SPDX-License-Identifier: Apache-2.0
#include "team/lateness.hpp"

#include <algorithm>

namespace skein::decision_node {

void Lateness::begun() { *this = Lateness(); }

void Lateness::planned(MissionTime earliest, MissionTime latest) {
  earliest_ = earliest;
  latest_ = latest;
  if (!promised_ && latest != MissionTime::max()) promised_ = latest;
}

std::optional<Duration> Lateness::behind(MissionTime now) const {
  if (!promised_) return std::nullopt;
  const Duration by = std::max(now, earliest_) - *promised_;
  return by < margin_ ? std::nullopt : std::optional(by);
}

std::optional<MissionTime> Lateness::due() const {
  return promised_ ? std::optional(*promised_ + margin_) : std::nullopt;
}

void Lateness::renew(MissionTime now) {
  promised_ = std::max({now, earliest_, latest_ == MissionTime::max() ? now : latest_});
  margin_ = margin_ + margin_;
}

}  // namespace skein::decision_node
