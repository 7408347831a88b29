// SPDX-License-Identifier: Apache-2.0
#include "sessions/lives.hpp"

#include <utility>

namespace skein::blackboard {

bool Lives::is_former(std::uint64_t incarnation) const {
  return rival_ && rival_->life.incarnation == incarnation && incarnation < present_.incarnation;
}

bool Lives::was_refused(std::uint64_t incarnation) const {
  return rival_ && rival_->is_refused && incarnation > present_.incarnation;
}

void Lives::forget_silent_rival(Duration silence, Duration now) {
  if (rival_ && now - rival_->life.last_heard >= silence) rival_.reset();
}

void Lives::consider_older(std::uint64_t incarnation, Duration silence, Duration now) {
  forget_silent_rival(silence, now);
  if (rival_) return;
  rival_ =
      std::make_unique<Rival>(Rival{.life = Life(config_->self, self_incarnation_), .since = now});
  rival_->life.incarnation = incarnation;
  rival_->life.last_heard = now;
}

Life* Lives::with(std::uint64_t incarnation, bool reachable, Duration now) {
  const bool is_later = incarnation > present_.incarnation;
  if (is_former(incarnation)) return &rival_->life;
  if (!is_later || !reachable || present_.incarnation == 0) return &present_;
  if (!rival_) {
    rival_ = std::make_unique<Rival>(Rival{Life(config_->self, self_incarnation_)});
    rival_->life.incarnation = incarnation;
    rival_->life.last_heard = now;
  }
  return rival_->life.incarnation == incarnation ? &rival_->life : nullptr;
}

Novelty Lives::note(const wire::Heartbeat& heartbeat) {
  const std::uint64_t incarnation = heartbeat.header.incarnation;
  const std::uint64_t sequence = heartbeat.header.sequence_number;
  if (incarnation > present_.incarnation) return Novelty::kNew;
  if (incarnation < present_.incarnation && !is_former(incarnation)) return Novelty::kKnown;
  Life& life = incarnation == present_.incarnation ? present_ : rival_->life;
  if (sequence < life.newest_heartbeat) return Novelty::kReplayed;
  return std::exchange(life.newest_heartbeat, sequence) == sequence ? Novelty::kKnown
                                                                    : Novelty::kNew;
}

void Lives::follow(std::uint64_t incarnation, bool reachable, Duration now) {
  if (present_.incarnation == 0) {
    present_.incarnation = incarnation;
    return;
  }
  Life next(config_->self, self_incarnation_);
  const bool is_known = rival_ && rival_->life.incarnation == incarnation;
  if (is_known) {
    next = std::move(rival_->life);
  } else if (!reachable) {
    next.incoming = std::move(present_.incoming);  // which may have its first events
    next.parts = std::move(present_.parts);
    next.state_parts = std::move(present_.state_parts);
  }
  next.incarnation = incarnation;
  const bool first_is_alive = rival_ && is_former(rival_->life.incarnation) && rival_->words > 0;
  if (!reachable) {
    rival_.reset();
  } else if (!first_is_alive) {
    rival_ = std::make_unique<Rival>(Rival{.life = std::move(present_), .since = now});
  }
  present_ = std::move(next);
}

bool Lives::former_goes_on(Duration silence, Duration now) {
  forget_silent_rival(silence, now);
  if (!rival_) return false;
  rival_->life.last_heard = now;
  ++rival_->words;
  const Duration alive_for = config_->heartbeat_period + config_->heartbeat_period;
  if (rival_->words < Rival::kWords || now - rival_->since < alive_for) return false;
  std::swap(present_, rival_->life);
  rival_->life.last_heard = now;
  rival_->words = 0;
  rival_->is_refused = true;
  return true;
}

void Lives::heard_present(bool restarted) {
  if (restarted) turns_ = 0;
  heard_present_ = true;
}

void Lives::heard_older() {
  if (std::exchange(heard_present_, false)) ++turns_;
}

void Lives::become(std::uint64_t self_incarnation) {
  self_incarnation_ = self_incarnation;
  present_.incoming.become(self_incarnation);
  if (rival_) rival_->life.incoming.become(self_incarnation);
}

void Lives::commit() {
  present_.commit();
  if (rival_) rival_->life.commit();
}

}  // namespace skein::blackboard
