// SPDX-License-Identifier: Apache-2.0
// What others need to know of the network of a plan.
#include <utility>

#include "schedule/plan_network.hpp"

namespace skein::supervisor {

namespace {

using executive::TaskId;
using temporal::Frontier;
using temporal::FrontierLink;
using temporal::kInfinite;
using temporal::kMinusInfinite;
using temporal::Ticks;

/// Numbers for the nodes of a plan, those of the frontier first.
class Numbers {
 public:
  explicit Numbers(const std::map<TaskId, temporal::Meeting>& meetings) {
    of_[temporal::LiveNetwork::kOrigin] = Frontier::kOrigin;
    of_[kPresent] = Frontier::kPresent;
    std::size_t number = 0;
    for (const auto& [task, meeting] : meetings) {
      of_[start_of(task)] = Frontier::arrival_of(number);
      of_[end_of(task)] = Frontier::end_of(number++);
    }
    kept_ = of_.size();
  }
  std::uint32_t of(const temporal::NodeName& node) {
    return of_.emplace(node, static_cast<std::uint32_t>(of_.size())).first->second;
  }
  std::size_t kept() const { return kept_; }
  std::size_t all() const { return of_.size(); }

 private:
  std::map<temporal::NodeName, std::uint32_t> of_;
  std::size_t kept_ = 0;
};

}  // namespace

// How long a meeting takes is for the others to say. What is under way lasts as long as it may:
// that it has not ended yet goes without saying, at every instant anew.
Frontier PlanNetwork::frontier(const std::map<TaskId, temporal::Meeting>& meetings) const {
  Frontier frontier;
  for (const auto& [task, meeting] : meetings) frontier.meetings.push_back(meeting);
  if (meetings.empty()) return frontier;
  Numbers numbers(meetings);
  std::vector<FrontierLink> links;
  const auto add = [&](const temporal::LiveLink& link, Ticks soonest, Ticks slowest, Ticks latest) {
    links.push_back({numbers.of(link.from), numbers.of(link.to), soonest, slowest, latest});
  };
  for (const auto& [id, known] : tasks_) {
    for (const auto& [name, one] : known.links) {
      const BoundKind kind = one.cause.kind;
      const temporal::LiveLink& link = one.link;
      if (kind == BoundKind::kPartner || kind == BoundKind::kNeeded) continue;
      if (kind != BoundKind::kDuration) {
        add(link, link.min, link.min, link.min);
      } else if (meetings.count(id) != 0) {
        add(link, kInstant, kInstant, kInstant);
        continue;
      } else {
        const Ticks least = std::min<Ticks>(link.min, known.task.duration.least.count());
        const Ticks most = link.contingent ? link.max : link.min;
        add(link, least, known.endless ? kInfinite : most, most);
        if (known.seen.started && !known.seen.over)
          links.push_back({Frontier::kPresent, numbers.of(link.to), 0, 0, 0});
      }
      if (link.max == kInfinite) continue;
      links.push_back(
          {numbers.of(link.to), numbers.of(link.from), kMinusInfinite, kMinusInfinite, -link.max});
    }
  }
  frontier.arcs = temporal::eliminate(numbers.all(), numbers.kept(), links);
  return frontier;
}

}  // namespace skein::supervisor
