// SPDX-License-Identifier: Apache-2.0
#include "insertion/slack.hpp"

#include <algorithm>
#include <cmath>

namespace skein::supervisor {

Slack::Slack(const Goals& order, const mission::Vocabulary& vocabulary) : order_(order) {
  for (std::size_t goal = 0; goal < order.size(); ++goal) {
    const auto signature = vocabulary.tasks.find(order[goal].name);
    if (signature == vocabulary.tasks.end()) continue;
    const auto& kinds = signature->second.parameters;
    const auto& arguments = order[goal].arguments;
    for (std::size_t i = 0; i < std::min(kinds.size(), arguments.size()); ++i) {
      if (kinds[i] != mission::ParameterKind::kDuration) continue;
      if (const auto range = mission::duration_range_of(arguments[i]))
        ranges_.push_back({goal, i, *range});
    }
  }
}

// To whole tenths of a second, as durations of plans are; never below the least.
double Slack::Range::at(int share) const {
  const double seconds = range.most - (range.most - range.least) * share / kAll;
  return std::clamp(std::floor(seconds * 10) / 10, range.least, range.most);
}

Goals Slack::goals(int share) const {
  Goals goals = order_;
  for (const Range& one : ranges_) goals[one.goal].arguments[one.argument] = one.at(share);
  return goals;
}

std::vector<Shortened> Slack::shortened(int share) const {
  std::vector<Shortened> result;
  for (const Range& one : ranges_) {
    const double given = one.at(share);
    if (given < one.range.most)
      result.push_back({order_[one.goal].id, one.range, Duration::seconds(given)});
  }
  return result;
}

int Slack::with_some_to_spare(int share) const {
  double all = 0;
  for (const Range& one : ranges_) all += one.range.most - one.range.least;
  const double wanted = kSpare * static_cast<double>(ranges_.size());
  if (wanted * kAll >= all * (kAll - share)) return kAll;
  return share + static_cast<int>(std::ceil(wanted * kAll / all));
}

std::string to_text(const std::vector<Shortened>& all) {
  std::string text;
  for (const Shortened& one : all) {
    text += (text.empty() ? "goal " : ", goal ") + to_text(one.goal) + " to " + to_text(one.given) +
            " s of " + to_text(Duration::seconds(one.asked.least)) + " to " +
            to_text(Duration::seconds(one.asked.most));
  }
  return text;
}

Duration total_of(const std::vector<Shortened>& all) {
  Duration total;
  for (const Shortened& one : all) total = total + (Duration::seconds(one.asked.most) - one.given);
  return total;
}

}  // namespace skein::supervisor
