// SPDX-License-Identifier: Apache-2.0
// Which life is taken for the peer, if two are heard at the same time.
#include <utility>

#include "peer.hpp"

namespace skein::blackboard {

bool Peer::is_former(std::uint64_t incarnation) const {
  return rival_ && rival_->life.incarnation == incarnation && incarnation < life_.incarnation;
}

bool Peer::was_refused(std::uint64_t incarnation) const {
  return rival_ && rival_->is_refused && incarnation > life_.incarnation;
}

bool Peer::refuses(std::uint64_t incarnation, Duration steady) {
  if (!reachable_ || !was_refused(incarnation)) return false;
  rival_->life.last_heard = steady;
  return true;
}

void Peer::forget_silent_rival(Duration steady) {
  if (rival_ && steady - rival_->life.last_heard >= silence_limit()) rival_.reset();
}

Life* Peer::life_of(std::uint64_t incarnation, Duration steady) {
  const bool is_later = incarnation > life_.incarnation;
  if (is_former(incarnation)) return &rival_->life;
  if (!is_later || !reachable_ || life_.incarnation == 0) return &life_;
  if (!rival_) {
    rival_ = std::make_unique<Rival>(Rival{Life(config_->self, self_incarnation_)});
    rival_->life.incarnation = incarnation;
    rival_->life.last_heard = steady;
  }
  return rival_->life.incarnation == incarnation ? &rival_->life : nullptr;
}

Novelty Peer::note(const wire::Heartbeat& heartbeat) {
  const std::uint64_t incarnation = heartbeat.header.incarnation;
  const std::uint64_t sequence = heartbeat.header.sequence_number;
  if (incarnation > life_.incarnation) return Novelty::kNew;
  if (incarnation < life_.incarnation && !is_former(incarnation)) return Novelty::kKnown;
  Life& life = incarnation == life_.incarnation ? life_ : rival_->life;
  if (sequence < life.newest_heartbeat) return Novelty::kReplayed;
  return std::exchange(life.newest_heartbeat, sequence) == sequence ? Novelty::kKnown
                                                                    : Novelty::kNew;
}

void Peer::follow(std::uint64_t incarnation, Duration steady) {
  if (life_.incarnation == 0) {
    life_.incarnation = incarnation;
    return;
  }
  Life next(config_->self, self_incarnation_);
  const bool is_known = rival_ && rival_->life.incarnation == incarnation;
  if (is_known) {
    next = std::move(rival_->life);
  } else if (!reachable_) {
    next.incoming = std::move(life_.incoming);  // which may have its first events
    next.parts = std::move(life_.parts);
  }
  next.incarnation = incarnation;
  const bool first_is_alive = rival_ && is_former(rival_->life.incarnation) && rival_->words > 0;
  if (!reachable_) {
    rival_.reset();
  } else if (!first_is_alive) {
    rival_ = std::make_unique<Rival>(Rival{.life = std::move(life_), .since = steady});
  }
  life_ = std::move(next);
}

bool Peer::former_goes_on(Duration steady) {
  forget_silent_rival(steady);
  if (!rival_) return false;
  rival_->life.last_heard = steady;
  ++rival_->words;
  if (rival_->words < Rival::kWords || steady - rival_->since < period_ + period_) return false;
  std::swap(life_, rival_->life);
  rival_->life.last_heard = steady;
  rival_->words = 0;
  rival_->is_refused = true;
  return true;
}

}  // namespace skein::blackboard
