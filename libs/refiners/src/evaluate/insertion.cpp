// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "skein/refiners/evaluate.hpp"
#include "tour/checks.hpp"
#include "tour/travel.hpp"

namespace skein::refiners {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

Duration minus(Duration whole, Duration part) {
  return whole == Duration::max() ? whole : whole - part;
}

/// The places of a plan, one after another: where each hop begins and ends.
class PlanChain {
 public:
  PlanChain(const InsertionQuery& query, Travel& travel) : travel_(travel) {
    leaves_.push_back(travel.add(query.start));
    for (const PlannedTask& task : query.plan) {
      enters_.push_back(travel.add(task.from));
      leaves_.push_back(travel.add(task.to));
    }
    if (query.end) enters_.push_back(travel.add(*query.end));
    from_ = travel.add(query.task.from);
    to_ = travel.add(query.task.to);
  }

  std::size_t positions() const { return leaves_.size(); }
  bool goes_on(std::size_t position) const { return position < enters_.size(); }
  /// Looks for the way that the plan has there; false when the time is up.
  bool settle_hop(std::size_t position) {
    return !goes_on(position) || travel_.settle(leaves_[position], enters_[position]);
  }
  double hop(std::size_t position) const {
    return goes_on(position) ? travel_.seconds(leaves_[position], enters_[position]) : 0;
  }
  /// Looks for the ways there and on; false when the time is up.
  bool settle_detour(std::size_t position) {
    if (!travel_.settle(leaves_[position], from_)) return false;
    if (there(position) == kNever || !goes_on(position)) return true;
    return travel_.settle(to_, enters_[position]);
  }
  /// By the ways there and on, less the way that falls out; at least that when they are not known.
  double added(std::size_t position) const {
    const double on = goes_on(position) ? travel_.seconds(to_, enters_[position]) : 0;
    return there(position) + on < kNever ? there(position) + on - hop(position) : kNever;
  }
  Way way_there(std::size_t position) const { return travel_.way(leaves_[position], from_); }
  Way way_on(std::size_t position) const {
    return goes_on(position) ? travel_.way(to_, enters_[position]) : Way{};
  }
  Way way_out(std::size_t position) const {
    return goes_on(position) ? travel_.way(leaves_[position], enters_[position]) : Way{};
  }

 private:
  double there(std::size_t position) const { return travel_.seconds(leaves_[position], from_); }

  Travel& travel_;
  std::vector<Travel::Id> leaves_, enters_;
  Travel::Id from_ = 0, to_ = 0;
};

std::string hop_field(const InsertionQuery& query, std::size_t position) {
  return position < query.plan.size() ? "plan." + std::to_string(position) + ".from" : "end";
}

/// What the best place for the task adds; the interval by its bounds, put in order.
Refined<Insertion> refined(const InsertionQuery& query, const Travel& travel,
                           const PlanChain& chain, Insertion insertion) {
  const std::size_t best = insertion.position;
  insertion.to = chain.way_there(best);
  insertion.from = chain.way_on(best);
  const DurationInterval there = travel.flight(insertion.to).duration;
  const DurationInterval on = travel.flight(insertion.from).duration;
  const DurationInterval out = travel.flight(chain.way_out(best)).duration;
  const Duration inside = query.task.duration;
  Refined<Insertion> result;
  result.cost = insertion.added[best];
  result.effort.steps = chain.positions();
  result.effort.cut_short = travel.cut_short();
  const Duration least = minus(there.least + on.least + inside, out.least);
  const Duration most = minus(there.most + on.most + inside, out.most);
  const Duration expected = Duration::seconds(result.cost);
  result.duration = {std::min({least, expected, most}), expected,
                     std::max({least, expected, most})};
  result.task = std::move(insertion);
  return result;
}

/// What the task adds at each position; those that look best first, while there is time.
Insertion tried_everywhere(const InsertionQuery& query, PlanChain& chain) {
  std::vector<std::pair<double, std::size_t>> promising;
  for (std::size_t i = 0; i < chain.positions(); ++i) promising.emplace_back(chain.added(i), i);
  std::sort(promising.begin(), promising.end());
  Insertion insertion;
  insertion.added.assign(chain.positions(), kNever);
  for (const auto& [least, i] : promising)
    if (chain.settle_detour(i))
      insertion.added[i] = chain.added(i) + query.task.duration.to_seconds();
  return insertion;
}

}  // namespace

Outcome<Insertion> refine(const InsertionQuery& query, const Setting& setting) {
  if (auto problem = check(query)) return tl::unexpected(*problem);
  const Traveller who{query.vehicle, query.clearance, query.speed, query.depart};
  auto travel = Travel::over(who, setting, query.start, query.task.from);
  if (!travel) return tl::unexpected(travel.error());

  PlanChain chain(query, *travel);
  for (std::size_t i = 0; i < chain.positions(); ++i) {
    if (!chain.settle_hop(i))
      return refuse(RefusalKind::kBudgetExhausted, hop_field(query, i),
                    "the time was up before the ways of the plan as it is were found");
    if (chain.hop(i) == kNever)
      return refuse(RefusalKind::kUnreachable, hop_field(query, i),
                    "the plan as it is has no open way to there");
  }
  Insertion insertion = tried_everywhere(query, chain);
  const auto best = std::min_element(insertion.added.begin(), insertion.added.end());
  if (*best == kNever)
    return refuse(travel->cut_short() ? RefusalKind::kBudgetExhausted : RefusalKind::kUnreachable,
                  "task", "no place of the plan has open ways to the task and on from it");
  insertion.position = static_cast<std::size_t>(best - insertion.added.begin());
  return refined(query, *travel, chain, std::move(insertion));
}

}  // namespace skein::refiners
