// SPDX-License-Identifier: Apache-2.0
// What a member waits for, and who of a circle gets out of the way.
#include <algorithm>

#include "circle.hpp"
#include "names.hpp"
#include "skein/merging/merger.hpp"

namespace skein::merging {

std::string_view to_text(Awaited what) {
  switch (what) {
    case Awaited::kToLeave:
      return "to leave";
    case Awaited::kToTell:
      return "to tell what it has";
    case Awaited::kToComeIntoReach:
      return "to come into reach";
    case Awaited::kToBeAnswered:
      return "to be answered itself";
    case Awaited::kToGoFirst:
      return "to go first, it has waited long";
  }
  return "?";
}

std::vector<std::string> Waits::to_leave() const {
  std::vector<std::string> names;
  for (const Why& why : whys)
    if (why.what == Awaited::kToLeave) names.push_back(why.peer);
  return names;
}

std::vector<std::string> Waits::in_its_way() const {
  std::vector<std::string> names;
  for (const Why& why : whys)
    if (why.what == Awaited::kToLeave || why.what == Awaited::kToGoFirst) names.push_back(why.peer);
  return names;
}

bool Limits::longer(const std::optional<MissionTime>& since, bool is_earlier,
                    const std::optional<MissionTime>& other, MissionTime now) const {
  if (!presses(since, now)) return false;
  if (!presses(other, now)) return true;
  if (*since + clearly < *other) return true;
  return is_earlier && *since <= *other + clearly;
}

std::vector<Merger::Waiter> Merger::waiters() const {
  std::vector<Waiter> all;
  for (const auto& [name, peer] : peers_) {
    const std::vector<std::string>& for_whom = peer.claim().waits_for;
    if (!is_among(for_whom, self_)) continue;
    if (!overlap(held_, peer.claim().wanted)) continue;
    all.push_back({name, overlap({held_.back()}, peer.claim().wanted), waits_longer(peer)});
  }
  return all;
}

std::vector<Waits::Why> Merger::whys() const {
  std::vector<Waits::Why> result;
  const Volumes& first = choices_.front();
  for (const auto& [name, peer] : peers_) {
    if (has(peer, first)) {
      result.push_back({name, Awaited::kToLeave});
    } else if (!may_agree(peer) || (third_ && !peer.exchange.has_heard() && peer.reachable)) {
      result.push_back({name, peer.reachable ? Awaited::kToTell : Awaited::kToComeIntoReach});
    } else if (third_ && !peer.reachable && is_among(third_->refusers, name)) {
      result.push_back({name, Awaited::kToLeave});
    } else if (asks_for(peer, first)) {
      result.push_back({name, Awaited::kToBeAnswered});
    } else if (yields_to(peer, first)) {
      result.push_back({name, Awaited::kToGoFirst});
    }
  }
  return result;
}

std::vector<Waits::Why> Merger::whys_afterwards() const {
  std::vector<Waits::Why> result;
  for (const auto& [name, peer] : peers_) {
    if (has(peer, afterwards_)) {
      result.push_back({name, Awaited::kToLeave});
    } else if (yields_to(peer, afterwards_)) {
      result.push_back({name, Awaited::kToGoFirst});
    }
  }
  return result;
}

void Merger::say_waits() {
  Waits now{whys(), whys_afterwards()};
  if (now == told_ || now.whys.empty()) return;
  changed_ = changed_ || now.whys != told_.whys;
  told_ = std::move(now);
  out_.push_back(told_);
}

/// Whoever finds no place aside still waits for what it wants afterwards: the next of the circle
/// sees that it stands.
std::vector<std::string> Merger::waits_for() const {
  std::vector<std::string> names = told_.in_its_way();
  for (const Waits::Why& why : whys_afterwards())
    if (!is_among(names, why.peer)) names.push_back(why.peer);
  return names;
}

/// One has to move; when that does not help, the next: whoever presses moves last, and of the
/// others the last of the roster first.
void Merger::look_for_circle() {
  const Names found = circle_from(self_, waits_for(), [this](const std::string& name) {
    const Peer* peer = peers_.find(name);
    return peer == nullptr ? nullptr : &peer->claim().waits_for;
  });
  if (found.empty()) return circle_since_.reset();
  if (!circle_since_) circle_since_ = now_;
  std::int64_t before = 0;
  bool all_hear = true;
  for (const std::string& one : found) {
    const Peer* peer = peers_.find(one);
    if (peer == nullptr) continue;
    const bool press =
        limits_.presses(peer->wants_since, now_) || limits_.presses(wants_since_, now_);
    if (press ? !waits_longer(*peer) : !peer->earlier) ++before;
    all_hear = all_hear && peer->reachable;
  }
  const Duration patience = limits_.circle + Duration::nanoseconds(before * limits_.next.count());
  if (now_ < *circle_since_ + patience || now_ < moved_aside_) return;
  moved_aside_ = now_ + limits_.moves;
  out_.push_back(MoveAside{found, !all_hear});
}

}  // namespace skein::merging
