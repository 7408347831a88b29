// SPDX-License-Identifier: Apache-2.0
#include "interaction/loading_time.hpp"

#include <algorithm>

namespace skein::decision_node {

namespace {

constexpr Duration kAtOnce = Duration::milliseconds(1'000);

}  // namespace

void LoadingTime::plan(const std::vector<mission::Interval>& starts, MissionTime now) {
  Duration latest, first = starts.front().least;
  for (const mission::Interval& one : starts) {
    latest = std::max(latest, one.most);
    first = std::min(first, one.least);
  }
  bounded_ = latest < Duration::seconds(kForever);
  const MissionTime could = std::max(now, MissionTime() + first);
  if (could > now + kAtOnce)
    due_since_.reset();
  else if (!due_since_)
    due_since_ = could;
  const MissionTime due = due_since_.value_or(could);
  since_ = due_since_ ? before_.waits_since.value_or(due) : due;
  const MissionTime again = due + kTryAgainFor;
  const MissionTime whole = since_ + kTryFor;
  const MissionTime unbounded = before_.has_run ? again : std::max(whole, again);
  until_ = bounded_ ? MissionTime() + latest : unbounded;
}

void LoadingTime::put_off(const std::vector<mission::Interval>& starts, MissionTime now) {
  due_since_.reset();
  plan(starts, now);
}

void LoadingTime::follows(const EarlierAttempts& before) {
  before_ = before;
  partners_ = before.engaged;
}

void LoadingTime::engage(const std::string& partner, std::optional<MissionTime> until,
                         MissionTime now) {
  const auto known = partners_.find(partner);
  if (until)
    partners_.insert_or_assign(partner, *until);
  else if (known != partners_.end())
    known->second = std::min(known->second, now);
}

MissionTime LoadingTime::tried_until(Duration after_engagements) const {
  if (bounded_) return until_;
  MissionTime until = until_;
  for (const auto& one : {engaged_, agreed_})
    if (one) until = std::max(until, *one + after_engagements);
  for (const auto& [partner, one] : partners_) until = std::max(until, one + after_engagements);
  return until;
}

}  // namespace skein::decision_node
