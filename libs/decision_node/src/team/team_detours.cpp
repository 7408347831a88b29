// SPDX-License-Identifier: Apache-2.0
#include "team/team_detours.hpp"

#include <algorithm>

namespace skein::decision_node {

namespace {

using auction::Stopover;
using supervisor::StraightLeg;

bool same(const StraightLeg& one, const StraightLeg& other) {
  const auto near = [](const world::Vector3& a, const world::Vector3& b) {
    return (a - b).norm() < TeamDetours::kSamePlace;
  };
  return near(one.from, other.from) && near(one.to, other.to);
}

}  // namespace

// Those from where it is come first, then those home: every route has one of each.
void TeamDetours::want(const Vantage& at, const auction::Lot& lot) {
  Air air{at.world, {}};
  for (const world::Volume& volume : at.world->volumes)
    air.closed.push_back(volume.when.from <= at.now && at.now < volume.when.until);
  if (air != air_) {
    known_.clear();
    job_.reset();
  }
  air_ = std::move(air);
  missing_.clear();
  const TeamCraft craft(at);
  for (const auction::Task& task : lot.tasks)
    want(at, craft, {Stopover::begin(), Stopover::of(task.number)});
  for (const auction::Task& task : lot.tasks)
    want(at, craft, {Stopover::of(task.number), Stopover::end()});
  for (const auction::Task& from : lot.tasks)
    for (const auction::Task& to : lot.tasks)
      if (from.number != to.number)
        want(at, craft, {Stopover::of(from.number), Stopover::of(to.number)});
}

void TeamDetours::want(const Vantage& at, const TeamCraft& craft, LegEnds ends) {
  const auto leg = craft.straight(ends.first, ends.second);
  if (!leg) return;
  const auto known = known_.find(ends);
  if (known != known_.end() && same(known->second.leg, *leg)) return;
  known_.erase(ends);
  if (goes_through(*at.knowledge, *at.world, at.now, *leg)) {
    missing_.emplace_back(ends, *leg);
  } else {
    known_.emplace(ends, Known{*leg, {}});
  }
}

std::optional<StartDetours> TeamDetours::next_job(const Vantage& at) {
  if (missing_.empty() || job_) return std::nullopt;
  const std::size_t count = std::min(missing_.size(), kLegsOfAJob);
  job_ = Job{++jobs_, {missing_.begin(), missing_.begin() + static_cast<std::ptrdiff_t>(count)}};
  StartDetours start{job_->number, {at.knowledge, at.world, at.now, {}}};
  for (const auto& [ends, leg] : job_->legs) start.request.legs.push_back(leg);
  return start;
}

void TeamDetours::planned(const DetoursPlanned& done) {
  if (!job_ || job_->number != done.job) return;
  const std::size_t count = std::min(done.detours.size(), job_->legs.size());
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [ends, leg] = job_->legs[i];
    known_.insert_or_assign(ends, Known{leg, done.detours[i]});
  }
  job_.reset();
}

Detours TeamDetours::known() const {
  Detours detours;
  for (const auto& [ends, known] : known_)
    if (known.detour != supervisor::Detour()) detours.emplace(ends, known.detour);
  return detours;
}

}  // namespace skein::decision_node
