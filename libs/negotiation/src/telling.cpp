// SPDX-License-Identifier: Apache-2.0
#include "telling.hpp"

#include <algorithm>
#include <utility>

namespace skein::interaction {

Telling::Telling(std::size_t members, std::size_t self, MissionTime opened, Duration first,
                 Duration most)
    : self_(self), members_(members), first_(first), most_(most), again_{opened, first} {}

void Telling::heard(std::size_t from, FactBits theirs, MissionTime now) {
  Member& member = members_[from];
  member.knows |= theirs;
  if (member.has_to_say && !lacks(theirs, member.told)) {
    member.has_to_say = false;
    member.round_trip = now - member.since;
  }
  if (from == 0) unheard_ = 0;
}

void Telling::tells(std::size_t to, FactBits known, MissionTime now) {
  Member& member = members_[to];
  if (!member.was_told || member.told != known) {
    member.has_to_say = lacks(member.knows, known);
    member.since = now;
  }
  member.was_told = true;
  member.told = known;
  member.last = now;
}

std::vector<std::size_t> Telling::who_lags(FactBits known) const {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < members_.size(); ++i) {
    if (i != self_ && lags(i, known)) all.push_back(i);
  }
  return all;
}

void Telling::owe_all() {
  for (std::size_t i = 0; i < members_.size(); ++i) owe(i);
}

void Telling::owe_news(FactBits known, bool all) {
  for (std::size_t i = 0; i < members_.size(); ++i) {
    if ((all || i == 0) && lags(i, known)) owe(i);
  }
}

Duration Telling::pause(const std::set<std::size_t>& to) const {
  Duration slowest = first_;
  for (const std::size_t one : to) slowest = std::max(slowest, members_[one].round_trip);
  return std::min(slowest, most_);
}

// If it was lost on its way, the other asks once more.
bool Telling::is_on_its_way(std::size_t to, FactBits known, MissionTime now) const {
  const Member& member = members_[to];
  return member.was_told && member.told == known && now < member.last + pause({to});
}

std::set<std::size_t> Telling::take_owed(FactBits known, MissionTime now) {
  owed_.erase(self_);
  std::erase_if(owed_, [&](std::size_t one) { return is_on_its_way(one, known, now); });
  if (!owed_.empty()) again_ = {now, pause(owed_)};
  return std::exchange(owed_, {});
}

std::set<std::size_t> Telling::repeat(FactBits known, bool asks, bool invites, MissionTime now,
                                      Duration within) {
  std::set<std::size_t> all;
  const bool decides = self_ == 0;
  for (std::size_t i = 0; i < members_.size(); ++i) {
    if (i == self_) continue;
    const bool uninvited = invites && members_[i].knows == 0;
    if (asks || (lags(i, known) && (i == 0 || decides || uninvited))) all.insert(i);
  }
  if (!all.empty()) ++unheard_;
  again_.repeated(now, std::clamp(within, pause(all), most_));
  return all;
}

std::string Telling::state_text() const {
  std::string text = std::to_string(unheard_) + " unheard since " + to_text(again_.last) +
                     ", again at " + to_text(again_.due());
  for (const Member& one : members_) {
    text += "; knows " + std::to_string(one.knows);
    if (one.was_told) text += " told " + std::to_string(one.told) + " at " + to_text(one.last);
    if (one.has_to_say) text += " since " + to_text(one.since);
    if (one.round_trip > Duration()) text += " answers in " + to_text(one.round_trip);
  }
  return text;
}

}  // namespace skein::interaction
