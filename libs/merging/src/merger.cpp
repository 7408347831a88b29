// SPDX-License-Identifier: Apache-2.0
#include "skein/merging/merger.hpp"

#include <algorithm>

#include "keeps_from.hpp"
#include "names.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::merging {

namespace {

/// It waits for one out of reach to leave, who may have told the witness since that it has left.
bool waits_beyond_reach(const Waits& waits, const Peers& peers) {
  const auto names = waits.to_leave();
  return std::any_of(names.begin(), names.end(),
                     [&](const auto& name) { return !peers.find(name)->reachable; });
}

}  // namespace

Merger::Merger(const std::vector<std::string>& members, const std::string& self, Limits limits,
               const std::string& witness)
    : self_(self),
      limits_(limits),
      peers_(members, self, !witness.empty()),
      former_life_(!witness.empty()) {
  SKEIN_EXPECTS(!is_among(members, witness));
  if (!witness.empty()) third_ = Third{witness, true, 0, false, {}};
}

Effects Merger::handle(const Input& input, MissionTime now) {
  now_ = now;
  former_life_.lives(now);
  out_.clear();
  std::visit([this](const auto& one) { on(one); }, input);
  advance();
  if (changed_) tell_all();
  tell_again();
  if (request_ != 0 && asked_.is_due(now_)) ask_again();
  if (request_ == 0 && standby_.is_due(now_)) tell_witness(false);
  return std::move(out_);
}

std::optional<MissionTime> Merger::next_wakeup() const {
  std::optional<MissionTime> next;
  for (const auto& [name, peer] : peers_)
    if (peer.reachable) next = earliest(next, peer.exchange.due());
  if (request_ != 0) return earliest(next, std::min(deadline_, asked_.due()));
  if (third_ && third_->reachable) next = earliest(next, standby_.due());
  if (!waits()) return next;
  next = earliest(next, now_ + limits_.beat);  // to look for a circle, or who may be asked again
  if (pause_ > now_) next = earliest(next, pause_);
  if (circle_since_) next = earliest(next, std::max(now_, *circle_since_) + limits_.circle);
  return next;
}

// ---- what comes in ----

void Merger::on(const FirstLife&) {
  former_life_.was_none();
  for (auto& [name, peer] : peers_) peer.known = true;
}

void Merger::hear_witness(const Message& message) {
  if (message.number <= third_->number) return;
  third_->number = message.number;
  if (standby_.request() != 0 && message.answered == standby_.request()) {
    standby_.answered(message.granted, now_);
    if (!message.granted) tell_witness(false);
    return;
  }
  if (request_ == 0 || message.answered != request_) return;
  third_->answered =
      message.granted || !message.claim.waits_for.empty();  // else it promised nothing
  third_->refusers = message.claim.waits_for;
  // Who is in reach knows better what it has.
  const auto& refusers = third_->refusers;
  const bool in_vain = std::any_of(refusers.begin(), refusers.end(), [&](const auto& name) {
    const Peer* peer = peers_.find(name);
    return peer != nullptr && !peer->agreed && !peer->reachable;
  });
  if (in_vain) close(limits_.beat);
}

void Merger::on(const Heard& heard) {
  const bool by_witness = third_ && heard.from == third_->name;
  if (by_witness && heard.message.of.empty()) return hear_witness(heard.message);
  if (by_witness != !heard.message.of.empty()) return;
  const std::string& whose = by_witness ? heard.message.of : heard.from;
  const auto found = peers_.find(whose);
  const Message& message = heard.message;
  if (found == nullptr || found->exchange.is_old(message)) return;
  Peer& peer = *found;
  const bool is_new = !peer.exchange.has_heard();
  if (!peer.exchange.hear(message, now_)) return tell(whose, false);  // by which it hears that
  if (peer.claim().wanted.empty())
    peer.wants_since.reset();
  else if (!peer.wants_since)
    peer.wants_since = now_;
  const bool answers = peer.needed && request_ != 0 && message.answered == request_;
  peer.known = peer.known || answers;
  if (answers && message.granted) peer.agreed = true;
  if (answers && !message.granted) close(limits_.again);
  answer(peer);
  const bool is_said_again = !message.brief && !by_witness;  // until it is known that it arrived
  if (is_new || message.asks || message.lacks || is_said_again) tell(whose, false);
}

/// Between this and a later one: yes to what this one neither has nor asks for; to an earlier one,
/// where there is a witness, to what it does not have, and what this one asks for it gives up. Said
/// once for each request, since who is refused gives the request up.
void Merger::answer(Peer& peer) {
  const std::uint64_t request = peer.claim().request;
  if ((peer.earlier && !third_) || request == 0 || request == peer.answered) return;
  if (former_life_.may_have_granted(request)) return;
  const bool has = keeps_from(held_, peer.claim().wanted, peer.claim().held);
  const bool asks = request_ != 0 && overlap(choices_[choice_], peer.claim().wanted);
  peer.answered = request;
  peer.granted = !has && (!asks || peer.earlier);
  if (peer.granted && asks) close(limits_.again);
}

void Merger::on(const InReach& reach) {
  if (third_ && reach.peer == third_->name) {
    const bool back = reach.reachable && !third_->reachable;
    third_->reachable = reach.reachable;
    if (back) changed_ = true;
    return;
  }
  Peer* peer = peers_.find(reach.peer);
  if (peer == nullptr) return;
  const bool back = reach.reachable && !peer->reachable;
  const bool lost = !reach.reachable && peer->reachable;
  peer->reachable = reach.reachable;
  if (lost) peer->exchange.is_cut();
  if (third_ && lost && is_among(told_.to_leave(), reach.peer)) changed_ = true;
  if (back || (reach.reachable && !peer->exchange.has_heard())) tell(reach.peer, true);
}

void Merger::on(const Want& want) {
  const auto since = wants_since_.value_or(now_);
  on(Withdraw{});
  wants_since_ = since;
  choices_ = want.choices;
  afterwards_ = want.afterwards;
  leaves_ = want.leaves;
  pause_ = now_;
  changed_ = true;
}

void Merger::on(const Withdraw&) {
  if (request_ != 0) close(Duration());
  if (waits() || !afterwards_.empty()) changed_ = true;
  choices_.clear();
  afterwards_.clear();
  told_ = {};
  wants_since_.reset();
  circle_since_.reset();
}

void Merger::on(const Hold& hold) {
  if (held_ == hold.volumes) return;
  held_ = hold.volumes;
  changed_ = true;
}

void Merger::on(const Need& need) {
  if (!third_ || need.choices == standby_.choices()) return;
  standby_.need(need.choices, now_);
  tell_witness(false);
}

// ---- what it wants ----

bool Merger::has(const Peer& peer, const Volumes& volumes) const {
  if (keeps_from(peer.claim().held, volumes, held_)) return true;
  if (peer.claim().request == 0) return false;
  const bool granted =
      (!peer.earlier || third_) && peer.granted && peer.answered == peer.claim().request;
  const bool may_have = granted || former_life_.may_have_granted(peer.claim().request);
  return may_have && overlap(volumes, peer.claim().wanted);
}

/// With a witness, what one out of reach asked for is had if it was granted, and else refused.
bool Merger::asks_for(const Peer& peer, const Volumes& volumes) const {
  if (third_ && !peer.reachable) return false;
  return peer.earlier && peer.claim().request != 0 && overlap(volumes, peer.claim().wanted);
}

/// One of the two others can be asked whether this one may have air between it and the peer.
bool Merger::may_agree(const Peer& peer) const {
  if (!third_) return peer.exchange.has_heard() && (!peer.earlier || peer.reachable);
  return peer.reachable || (third_->reachable && peer.known);
}

bool Merger::can_ask() const {
  return std::all_of(peers_.begin(), peers_.end(),
                     [&](const auto& one) { return may_agree(one.second); });
}

bool Merger::waits_longer(const Peer& peer) const {
  return limits_.longer(peer.wants_since, peer.earlier, wants_since_, now_);
}

/// It would stay where one wants to go that has waited long, and for somebody to leave: who waits
/// for one out of reach, or who cannot ask, gains nothing by it.
bool Merger::yields_to(const Peer& peer, const Volumes& volumes) const {
  const bool waits = !peer.claim().waits_for.empty() || peer.claim().request != 0;
  const bool gains = waits && !peer.claim().cannot_ask;
  return !leaves_ && !volumes.empty() && peer.reachable && gains && waits_longer(peer) &&
         overlap({volumes.back()}, peer.claim().wanted);
}

void Merger::advance() {
  if (!waits()) return;
  if (request_ != 0) {
    const bool all = std::all_of(peers_.begin(), peers_.end(), [&](const auto& one) {
      const Peer& peer = one.second;
      return !peer.needed || peer.agreed || (peer.known && third_ && third_->agrees(one.first));
    });
    if (all) return grant();
    if (now_ < deadline_) return;
    close(limits_.patience);
  }
  const bool asks = can_ask();
  if (!asks && take_what_is_kept()) return;
  if (asks && now_ >= pause_ && ask()) return;
  say_waits();
  look_for_circle();
}

/// It can ask nobody. None can have that air but by its own word, and so as it knows.
bool Merger::take_what_is_kept() {
  if (!standby_.kept() || third_->reachable) return false;
  for (choice_ = 0; choice_ < choices_.size(); ++choice_) {
    const Volumes& volumes = choices_[choice_];
    const bool free = std::all_of(peers_.begin(), peers_.end(), [&](const auto& one) {
      return one.second.known && !has(one.second, volumes);
    });
    if (!free || !standby_.keeps(volumes)) continue;
    grant();
    return true;
  }
  return false;
}

/// Asks for the first choice that nobody it knows of has; at once granted where nobody is earlier.
bool Merger::ask() {
  for (choice_ = 0; choice_ < choices_.size(); ++choice_) {
    const Volumes& volumes = choices_[choice_];
    const bool free = std::none_of(peers_.begin(), peers_.end(), [&](const auto& one) {
      return has(one.second, volumes) || asks_for(one.second, volumes) ||
             yields_to(one.second, volumes);
    });
    if (free) break;
  }
  if (choice_ == choices_.size()) return false;
  if (std::none_of(peers_.begin(), peers_.end(),
                   [&](const auto& one) { return one.second.needed; })) {
    grant();
    return true;
  }
  request_ = requests_.next(now_);
  for (auto& [name, peer] : peers_) peer.agreed = false;
  const Duration round_trip = peers_.slowest();
  deadline_ = now_ + limits_.patience + round_trip;
  asked_.pause = limits_.repeat + round_trip;
  if (third_) third_->answered = false;
  changed_ = true;
  return true;
}

/// The request is given up, by all who have granted it too: they hear that there is none.
void Merger::close(Duration pause) {
  request_ = 0;
  pause_ = now_ + pause;
  changed_ = true;
}

void Merger::grant() {
  const Volumes& volumes = choices_[choice_];
  held_.insert(held_.end(), volumes.begin(), volumes.end());
  request_ = 0;
  choices_.clear();
  told_ = {};
  if (afterwards_.empty()) wants_since_.reset();
  circle_since_.reset();
  changed_ = true;
  out_.push_back(Granted{choice_});
}

// ---- what it says ----

Claim Merger::claim() const {
  Claim claim{held_, request_, afterwards_, {}};
  if (!waits()) return claim;
  const bool only_intends = request_ == 0 && !afterwards_.empty();
  claim.wanted = only_intends ? afterwards_ : choices_[request_ != 0 ? choice_ : 0];
  claim.waits_for = waits_for();
  claim.cannot_ask = limits_.presses(wants_since_, now_) && !can_ask();
  return claim;
}

void Merger::tell(const std::string& name, bool asks) {
  Peer& peer = *peers_.find(name);
  if (!peer.reachable) return;
  Message message = peer.exchange.tell(claim(), numbers_.next(now_), now_, limits_.beat);
  message.answered = peer.answered;
  message.granted = peer.granted;
  message.asks = asks;
  out_.push_back(Tell{name, std::move(message)});
}

/// One request at a time: what is asked for now, or else what is to be kept.
void Merger::tell_witness(bool asks) {
  if (!third_ || !third_->reachable) return;
  Claim told = claim();
  if (request_ != 0) {
    standby_.replace(now_);
  } else {
    if (standby_.is_due(now_)) standby_.ask(requests_.next(now_), now_);
    asks = asks || waits_beyond_reach(told_, peers_);
    told.keeps = standby_.request() != 0;
    if (told.keeps) {
      told.request = standby_.request();
      told.wanted = standby_.volumes();
      asks = asks || !standby_.kept();
    }
  }
  out_.push_back(Tell{third_->name, Message{numbers_.next(now_), std::move(told), 0, false, asks}});
}

/// The witness is told what changes, and asked; it needs no beat.
void Merger::tell_all() {
  if (changed_ || request_ != 0) tell_witness(request_ != 0);
  changed_ = false;
  asked_.last = now_;
  for (const auto& [name, peer] : peers_) tell(name, false);
}

/// Whom this one waits for may have changed by what others said.
void Merger::tell_again() {
  const Claim current = claim();
  for (auto& [name, peer] : peers_) {
    if (!peer.reachable) continue;
    peer.exchange.claims(current, limits_.beat);
    if (!peer.exchange.is_due(now_)) continue;
    tell(name, false);
    peer.exchange.told_again(now_, limits_.pause);
  }
}

void Merger::ask_again() {
  asked_.repeated(now_, limits_.patience + peers_.slowest());
  for (const auto& [name, peer] : peers_) {
    if (peer.needed && !peer.agreed) tell(name, true);
  }
  if (third_ && !third_->answered) tell_witness(true);
}

}  // namespace skein::merging
