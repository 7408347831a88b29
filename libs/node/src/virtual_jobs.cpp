// SPDX-License-Identifier: Apache-2.0
#include "virtual_jobs.hpp"

#include <algorithm>

namespace skein::node {

// Most jobs are short, few are long.
Duration VirtualJobs::drawn(const StartJob& job, const LaneId& lane) {
  if (times_.least >= times_.most) return times_.least;
  const auto& [node, incarnation, aside] = lane;
  const std::string purpose =
      "jobs of " + node + "/" + std::to_string(incarnation) + (aside ? " aside" : "");
  const double share = random_.try_emplace(lane, seed_, purpose).first->second.uniform();
  const double span = (times_.most - times_.least).to_seconds();
  return std::min(times_.least + Duration::seconds(span * share * share * share),
                  std::max(times_.least, job.at_most));
}

void VirtualJobs::submit(const Owner& owner, StartJob job, MissionTime now) {
  const LaneId id{owner.node, owner.incarnation, job.aside};
  const Duration takes = drawn(job, id);
  Lane& lane = lanes_[id];
  if (lane.jobs.empty()) lane.ends = now + takes;
  lane.jobs.push_back({std::move(job), submitted_++, takes});
}

void VirtualJobs::stop(const Owner& owner, std::uint64_t id, MissionTime now) {
  for (const bool aside : {false, true}) {
    const auto found = lanes_.find({owner.node, owner.incarnation, aside});
    if (found == lanes_.end()) continue;
    Lane& lane = found->second;
    const auto queued = std::find_if(lane.jobs.begin(), lane.jobs.end(),
                                     [&](const Queued& one) { return one.job.id == id; });
    if (queued == lane.jobs.end()) continue;
    queued->takes = std::min(queued->takes, times_.least);
    if (queued == lane.jobs.begin()) lane.ends = std::min(lane.ends, now + queued->takes);
  }
}

std::optional<MissionTime> VirtualJobs::next() const {
  std::optional<MissionTime> next;
  for (const auto& [id, lane] : lanes_) next = next ? std::min(*next, lane.ends) : lane.ends;
  return next;
}

std::optional<VirtualJobs::Done> VirtualJobs::take_done(MissionTime now) {
  auto first = lanes_.end();
  const auto rank = [](const Lane& lane) { return std::pair(lane.ends, lane.jobs.front().number); };
  for (auto lane = lanes_.begin(); lane != lanes_.end(); ++lane) {
    if (lane->second.ends > now) continue;
    if (first == lanes_.end() || rank(lane->second) < rank(first->second)) first = lane;
  }
  if (first == lanes_.end()) return std::nullopt;
  const auto [node, incarnation, aside] = first->first;
  Lane& lane = first->second;
  const StartJob job = std::move(lane.jobs.front().job);
  lane.jobs.pop_front();
  if (lane.jobs.empty())
    lanes_.erase(first);
  else
    lane.ends = lane.ends + lane.jobs.front().takes;
  return Done{{node, incarnation}, {job.id, job.work({}), {}}};
}

}  // namespace skein::node
