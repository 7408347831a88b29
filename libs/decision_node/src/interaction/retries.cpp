// SPDX-License-Identifier: Apache-2.0
#include "interaction/retries.hpp"

#include <algorithm>
#include <utility>

#include "skein/foundation/repeats.hpp"

namespace skein::decision_node {

namespace {

constexpr Duration kRarest = Duration::milliseconds(20'000);
constexpr int kFirstTries = 10;  // so often it is repeated each second
/// What keeps it from being agreed on is said once it has stood so long.
constexpr Duration kWorthAWord = Duration::milliseconds(10'000);

}  // namespace

bool Retries::failed(const std::string& why, MissionTime now) {
  at_ = now + doubled(kOftenest, ++in_a_row_ - kFirstTries, kRarest);
  if (why != why_) {
    why_ = why;
    since_ = now;
    said_ = false;
  }
  if (said_ || now < since_ + kWorthAWord) return false;
  return said_ = true;
}

void Retries::see(Circumstances now_in, double near, MissionTime now) {
  if (in_ && in_->is_as(now_in, near)) return;
  in_ = std::move(now_in);
  if (at_) at_ = std::min(*at_, now + kOftenest);
}

void Retries::anew(MissionTime now) {
  in_a_row_ = 0;
  at_ = now + kOftenest;
}

}  // namespace skein::decision_node
