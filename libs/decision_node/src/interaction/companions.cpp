// SPDX-License-Identifier: Apache-2.0
#include "interaction/companions.hpp"

#include <algorithm>

namespace skein::decision_node {

namespace {

constexpr const char* kSilent = "silent";

}  // namespace

std::vector<std::string> Companions::counted_on() const {
  std::vector<std::string> all;
  for (const auto& [uav, role] : my_.holders)
    if (uav != self_ && !ended_.contains(uav)) all.push_back(uav);
  return all;
}

bool Companions::counts_on(const std::string& uav) const {
  return std::ranges::count(counted_on(), uav) > 0;
}

bool Companions::all_have_ended() const { return counted_on().empty(); }

void Companions::begin_anew() {
  ended_.clear();
  begun_.clear();
  hears_.clear();
}

void Companions::begin_anew(const std::string& uav) {
  ended_.erase(uav);
  begun_.erase(uav);
  hears_.erase(uav);
}

void Companions::told(const interaction::JointTaskStatus& status) {
  using interaction::JointPhase;
  if (status.phase != JointPhase::kLoading && status.phase != JointPhase::kLoaded)
    begun_.insert(status.uav);
  std::set<std::string>& heard = hears_[status.uav];
  heard.clear();
  if (status.phase != JointPhase::kRunning) return;
  for (const auto& [uav, role] : status.holders) heard.insert(uav);
  for (const interaction::Row& row : status.left)
    if (row.name == kSilent) heard.erase(row.text);
}

bool Companions::all_have_begun() const {
  return std::ranges::all_of(counted_on(),
                             [this](const auto& uav) { return begun_.contains(uav); });
}

bool Companions::some_have_begun() const {
  return std::ranges::any_of(counted_on(),
                             [this](const auto& uav) { return begun_.contains(uav); });
}

interaction::Rows Companions::silent(MissionTime now) const {
  interaction::Rows rows;
  for (const std::string& uav : counted_on())
    if (is_silent_for(uav, kToldAfter, now)) rows.push_back({kSilent, uav, {}});
  return rows;
}

bool Companions::is_silent_for(const std::string& uav, Duration time, MissionTime now) const {
  const auto since = partners_.silent_since(uav);
  return since && *since + time <= now;
}

// What it said last of itself holds while it is in reach.
bool Companions::is_heard_by_another(const std::string& uav, MissionTime now) const {
  const std::vector<std::string> others = counted_on();
  return std::ranges::any_of(others, [&](const std::string& other) {
    const auto said = hears_.find(other);
    return said != hears_.end() && said->second.contains(uav) && other != uav &&
           !is_silent_for(other, kLostAfter, now) && !partners_.is_declared_lost(other);
  });
}

std::vector<Companions::Lost> Companions::lost(MissionTime now) const {
  std::vector<Lost> all;
  for (const std::string& uav : counted_on()) {
    const Duration patience =
        is_heard_by_another(uav, now) ? std::max(kLostAfter, partners_.lease()) : kLostAfter;
    if (partners_.is_declared_lost(uav)) {
      all.push_back({uav, "'" + uav + "' is declared lost"});
    } else if (is_silent_for(uav, patience, now)) {
      all.push_back({uav, partners_.silence_of(uav)});
    }
  }
  return all;
}

std::optional<MissionTime> Companions::next_loss(MissionTime now) const {
  if (!lost(now).empty()) return now;
  std::optional<MissionTime> next;
  for (const std::string& uav : counted_on()) {
    const auto since = partners_.silent_since(uav);
    for (const Duration after : {kToldAfter, kLostAfter, partners_.lease()})
      if (since && *since + after > now) next = earliest(next, *since + after);
  }
  return next;
}

std::optional<MissionTime> Companions::next_given_up(MissionTime waits_since) const {
  std::optional<MissionTime> next;
  for (const std::string& uav : my_.joint.members)
    if (uav != self_) next = earliest(next, partners_.gives_up_at(uav, waits_since));
  return next;
}

}  // namespace skein::decision_node
