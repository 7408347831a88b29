// SPDX-License-Identifier: Apache-2.0
#include "skein/merging/standby.hpp"

#include <algorithm>

namespace skein::merging {

namespace {

constexpr Duration kUnanswered = Duration::milliseconds(2'000);  ///< it is asked for again
constexpr Duration kRefused = Duration::milliseconds(5'000);     ///< likewise, others have it

}  // namespace

void Standby::need(std::vector<Volumes> choices, MissionTime now) {
  if (choices == choices_) return;
  choices_ = std::move(choices);
  choice_ = 0;
  replace(now);
}

void Standby::replace(MissionTime now) {
  request_ = 0;
  kept_ = false;
  due_ = choices_.empty() ? std::nullopt : std::optional(now);
}

void Standby::ask(std::uint64_t request, MissionTime now) {
  request_ = request;
  due_ = now + kUnanswered;
}

void Standby::answered(bool granted, MissionTime now) {
  kept_ = granted;
  if (granted) return due_.reset();
  request_ = 0;
  choice_ = (choice_ + 1) % choices_.size();
  due_ = choice_ == 0 ? now + kRefused : now;
}

bool Standby::keeps(const Volumes& air) const {
  return kept_ && std::all_of(air.begin(), air.end(), [&](const Volume& piece) {
           return std::any_of(volumes().begin(), volumes().end(),
                              [&](const Volume& one) { return contains(one, piece); });
         });
}

}  // namespace skein::merging
