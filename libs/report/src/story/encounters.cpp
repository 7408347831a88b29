// SPDX-License-Identifier: Apache-2.0
#include "story/encounters.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace skein::report {

namespace {

constexpr double kTogether = 1;  // [s] between those who hear one message

}  // namespace

std::vector<Encounter> encounters_of(const Chronology& story) {
  using Pair = std::pair<std::size_t, std::size_t>;
  std::map<std::pair<std::string, Pair>, std::map<Pair, const Flight*>> told;  // first, each course
  for (const Flight& sync : story.syncs) {
    const auto from = story.uav_index(sync.from), to = story.uav_index(sync.to);
    if (!from || !to || !sync.received) continue;
    const Flight*& first = told[{sync.what, std::minmax(*from, *to)}][{*from, *to}];
    if (first == nullptr || *sync.received < *first->received) first = &sync;
  }
  std::vector<Encounter> all;
  for (const auto& [which, courses] : told) {
    const auto& [one, other] = which.second;
    std::map<std::size_t, double> through;
    for (const auto& [course, sync] : courses) {
      const auto& [from, to] = course;
      through[from] = std::max(through[from], sync->sent.value_or(*sync->received));
      through[to] = std::max(through[to], *sync->received);
    }
    all.push_back({which.first, one, other, through[one], through[other]});
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Encounter& a, const Encounter& b) { return a.t() < b.t(); });
  return all;
}

std::vector<TemporalMessage> temporal_messages_of(const Journal& journal, const Chronology& story) {
  std::vector<TemporalMessage> all;
  std::map<std::size_t, std::size_t> last;  // of each sender, in `all`
  for (const auto& [stamp, line] : journal.frontiers) {
    if (line.direction != "received") continue;
    const double t = seconds(stamp);
    const auto from = story.uav_index(line.from), by = story.uav_index(line.uav);
    if (!from || !by) continue;
    const auto before = last.find(*from);
    if (before != last.end() && t - all[before->second].t <= kTogether) {
      auto& heard_by = all[before->second].heard_by;
      if (std::find(heard_by.begin(), heard_by.end(), *by) == heard_by.end()) {
        heard_by.push_back(*by);
        continue;
      }
    }
    last[*from] = all.size();
    all.push_back({t, *from, {*by}});
  }
  return all;
}

const char* figure_colour(std::size_t row) {
  static constexpr std::array<const char*, 12> kColours = {
      "#0072b2", "#d55e00", "#00876c", "#a64d9a", "#b8860b", "#4ba3d9",
      "#c1272d", "#5b5f6b", "#7a9a01", "#6a3d9a", "#8c564b", "#17869c"};
  return kColours.at(row % kColours.size());
}

}  // namespace skein::report
