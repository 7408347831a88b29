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
  const bool bounded = latest < Duration::seconds(kForever);
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
  until_ = bounded ? MissionTime() + latest : unbounded;
}

}  // namespace skein::decision_node
