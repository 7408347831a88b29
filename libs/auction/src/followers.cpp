// SPDX-License-Identifier: Apache-2.0
#include "followers.hpp"

#include <algorithm>

namespace skein::auction {

void Followers::hear(MemberNumber member, const Status& status, MissionTime now) {
  Known& known = known_[member];
  known.heard = now;
  known.last = status.revision;
  known.bids = status.bids;
  known.revision = std::max(known.revision, status.revision);
  known.news = status;
  const auto told = told_.find(member);
  if (told != told_.end() && status.revision >= told->second.revision) told_.erase(told);
}

std::optional<MissionTime> Followers::heard(MemberNumber member) const {
  const auto known = known_.find(member);
  return known == known_.end() ? std::nullopt : std::optional(known->second.heard);
}

std::set<MemberNumber> Followers::heard_since(MissionTime since) const {
  std::set<MemberNumber> members;
  for (const auto& [member, known] : known_)
    if (known.heard >= since) members.insert(member);
  return members;
}

std::set<MemberNumber> Followers::bidding_since(MissionTime since) const {
  std::set<MemberNumber> members;
  for (const auto& [member, known] : known_)
    if (known.heard >= since && known.bids) members.insert(member);
  return members;
}

bool Followers::has(MemberNumber member, std::uint64_t revision) const {
  const auto known = known_.find(member);
  return known != known_.end() && known->second.revision >= revision;
}

std::set<MemberNumber> Followers::with(std::uint64_t revision) const {
  std::set<MemberNumber> members;
  for (const auto& [member, known] : known_)
    if (known.revision >= revision) members.insert(member);
  return members;
}

std::vector<std::uint64_t> Followers::revisions() const {
  std::vector<std::uint64_t> all;
  for (const auto& [member, known] : known_) all.push_back(known.revision);
  return all;
}

std::vector<std::pair<MemberNumber, Status>> Followers::take_news() {
  std::vector<std::pair<MemberNumber, Status>> all;
  for (auto& [member, known] : known_) {
    if (!known.news) continue;
    all.emplace_back(member, std::move(*known.news));
    known.news.reset();
  }
  return all;
}

bool Followers::is_told(MemberNumber member, std::uint64_t revision, MissionTime now,
                        Duration beat) {
  constexpr int kDoublings = 3;
  const auto known = known_.find(member);
  if (known != known_.end() && known->second.last == revision) return false;
  Telling& told = told_[member];
  if (told.again.is_due(now)) {
    told.again.repeated(now, doubled(beat, kDoublings, Duration::max()));
    told.again.pause = std::max(told.again.pause, beat);
  } else if (told.again.pause > beat) {
    return false;
  }
  told.revision = revision;
  return true;
}

}  // namespace skein::auction
