// SPDX-License-Identifier: Apache-2.0
#include "skein/merging/merger.hpp"

#include <algorithm>

#include "keeps_from.hpp"
#include "names.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::merging {

namespace {

constexpr Duration kClocksApart = Duration::milliseconds(1'000);  ///< of two members, at the most

}  // namespace

Merger::Merger(std::vector<std::string> members, const std::string& self, Limits limits,
               const std::string& witness)
    : members_(std::move(members)), self_(self), limits_(limits) {
  const auto at = std::find(members_.begin(), members_.end(), self_);
  SKEIN_EXPECTS(at != members_.end());
  place_ = static_cast<std::size_t>(at - members_.begin());
  for (std::size_t i = 0; i < members_.size(); ++i) {
    if (i != place_) peers_[members_[i]].earlier = i < place_;
  }
  SKEIN_EXPECTS(std::find(members_.begin(), members_.end(), witness) == members_.end());
  if (!witness.empty()) third_ = Third{witness, true, 0, false, {}};
}

Effects Merger::handle(const Input& input, MissionTime now) {
  now_ = now;
  if (!begun_) begun_ = now;
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
    if (peer.reachable && !peer.told.arrived) next = earliest(next, peer.told.again.due());
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
  first_life_ = true;
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
  third_->agreed = message.granted;
  third_->refusers = message.claim.waits_for;
  // Who is in reach knows better what it has.
  const bool nobody_else = std::any_of(peers_.begin(), peers_.end(), [](const auto& one) {
    return !one.second.agreed && !one.second.reachable;
  });
  if (!message.granted && nobody_else) close(limits_.beat);
}

void Merger::on(const Heard& heard) {
  const bool by_witness = third_ && heard.from == third_->name;
  if (by_witness && heard.message.of.empty()) return hear_witness(heard.message);
  if (by_witness != !heard.message.of.empty()) return;
  const std::string& whose = by_witness ? heard.message.of : heard.from;
  const auto found = peers_.find(whose);
  if (found == peers_.end()) return;
  Peer& peer = found->second;
  const Message& message = heard.message;
  if (message.number <= peer.number) return;
  if (!by_witness) peer.told.arrived = message.known == peer.told.version;
  const bool is_new = !peer.heard;
  if (!peer.take(message)) return tell(whose, false);  // by which it hears that
  if (peer.claim.wanted.empty())
    peer.wants_since.reset();
  else if (!peer.wants_since)
    peer.wants_since = now_;
  const bool answers = needs(peer) && request_ != 0 && message.answered == request_;
  peer.known = peer.known || answers;
  if (answers && message.granted) peer.agreed = true;
  if (answers && !message.granted) close(limits_.again);
  answer(peer);
  const bool is_said_again = !message.brief && !by_witness;  // until it is known that it arrived
  if (is_new || message.asks || is_said_again) tell(whose, false);
}

bool Merger::Peer::take(const Message& message) {
  if (message.brief && message.version != version) return false;
  number = message.number;
  heard = true;
  if (message.brief) return true;
  claim = message.claim;
  version = message.version;
  return true;
}

/// Between this and a later one: yes to what this one neither has nor asks for; to an earlier one,
/// where there is a witness, to what it does not have, and what this one asks for it gives up. Said
/// once for each request, since who is refused gives the request up.
void Merger::answer(Peer& peer) {
  const std::uint64_t request = peer.claim.request;
  if ((peer.earlier && !third_) || request == 0 || request == peer.answered) return;
  if (may_have_been_promised(request)) return;
  const bool has = keeps_from(held_, peer.claim.wanted, peer.claim.held);
  const bool asks = request_ != 0 && overlap(choices_[choice_], peer.claim.wanted);
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
  const auto found = peers_.find(reach.peer);
  if (found == peers_.end()) return;
  const bool back = reach.reachable && !found->second.reachable;
  const bool lost = !reach.reachable && found->second.reachable;
  found->second.reachable = reach.reachable;
  if (third_ && lost && is_among(awaited(), reach.peer)) changed_ = true;
  if (back || (reach.reachable && !found->second.heard)) tell(reach.peer, true);
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
  told_.clear();
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
  if (keeps_from(peer.claim.held, volumes, held_)) return true;
  if (peer.claim.request == 0) return false;
  const bool granted =
      (!peer.earlier || third_) && peer.granted && peer.answered == peer.claim.request;
  const bool may_have = granted || may_have_been_promised(peer.claim.request);
  return may_have && overlap(volumes, peer.claim.wanted);
}

/// With a witness, what one out of reach asked for is had if it was granted, and else refused.
bool Merger::asks_for(const Peer& peer, const Volumes& volumes) const {
  if (third_ && !peer.reachable) return false;
  return peer.earlier && peer.claim.request != 0 && overlap(volumes, peer.claim.wanted);
}

/// One of the two others can be asked whether this one may have air between it and the peer.
bool Merger::may_agree(const Peer& peer) const {
  if (!third_) return peer.heard && (!peer.earlier || peer.reachable);
  return peer.reachable || (third_->reachable && peer.known);
}

bool Merger::can_ask() const {
  return std::all_of(peers_.begin(), peers_.end(),
                     [&](const auto& one) { return may_agree(one.second); });
}

/// In a life before this: requests have the time at which they were opened.
bool Merger::may_have_been_promised(std::uint64_t request) const {
  return third_ && !first_life_ && request < Rising::least(*begun_ + kClocksApart);
}

/// Of two that press, it has waited longer; where that is not clear to both, the earlier has.
bool Merger::waits_longer(const Peer& peer) const {
  if (!limits_.presses(peer.wants_since, now_)) return false;
  if (!limits_.presses(wants_since_, now_)) return true;
  if (*peer.wants_since + limits_.clearly < *wants_since_) return true;
  return peer.earlier && *peer.wants_since <= *wants_since_ + limits_.clearly;
}

/// It would stay where one wants to go that has waited long, and for somebody to leave: who waits
/// for one out of reach gains nothing by it.
bool Merger::yields_to(const Peer& peer, const Volumes& volumes) const {
  const bool gains = !peer.claim.waits_for.empty() || peer.claim.request != 0;
  return !leaves_ && !volumes.empty() && peer.reachable && gains && waits_longer(peer) &&
         overlap({volumes.back()}, peer.claim.wanted);
}

Volumes Merger::others() const {
  Volumes all;
  for (const auto& [name, peer] : peers_) {
    all.insert(all.end(), peer.claim.held.begin(), peer.claim.held.end());
    all.insert(all.end(), peer.claim.wanted.begin(), peer.claim.wanted.end());
  }
  return all;
}

Volumes Merger::taken(const std::vector<std::string>& wanting) const {
  Volumes all;
  for (const auto& [name, peer] : peers_) {
    all.insert(all.end(), peer.claim.held.begin(), peer.claim.held.end());
    if (peer.claim.request != 0 || is_among(wanting, name))
      all.insert(all.end(), peer.claim.wanted.begin(), peer.claim.wanted.end());
  }
  return all;
}

Volumes Merger::ends() const {
  Volumes all;
  for (const auto& [name, peer] : peers_) {
    const bool stays = peer.claim.wanted.empty() || !peer.reachable;
    const Volumes& last = stays ? peer.claim.held : peer.claim.wanted;
    if (!last.empty()) all.push_back(last.back());
  }
  return all;
}

void Merger::advance() {
  if (!waits()) return;
  if (request_ != 0) {
    const bool all = std::all_of(peers_.begin(), peers_.end(), [&](const auto& one) {
      const Peer& peer = one.second;
      return !needs(peer) || peer.agreed || (third_ && third_->agreed && peer.known);
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
                   [&](const auto& one) { return needs(one.second); })) {
    grant();
    return true;
  }
  request_ = requests_.next(now_);
  deadline_ = now_ + limits_.patience;
  asked_.pause = limits_.repeat;
  for (auto& [name, peer] : peers_) peer.agreed = false;
  if (third_) third_->agreed = false;
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
  told_.clear();
  if (afterwards_.empty()) wants_since_.reset();
  circle_since_.reset();
  changed_ = true;
  out_.push_back(Granted{choice_});
}

// ---- what it says ----

Claim Merger::claim() const {
  Claim claim{held_, request_, afterwards_, {}};
  if (!waits()) return claim;
  claim.wanted = choices_[request_ != 0 ? choice_ : 0];
  claim.waits_for = waits_for();
  return claim;
}

void Merger::tell(const std::string& name, bool asks) {
  Peer& peer = peers_.at(name);
  if (!peer.reachable) return;
  Message message{numbers_.next(now_), claim(), peer.answered, peer.granted, asks};
  if (peer.told.version == 0 || peer.told.claim != message.claim)
    peer.told = {message.claim, message.number, false, {now_, limits_.beat}};
  peer.told.again.last = now_;
  message.version = peer.told.version;
  message.known = peer.version;
  message.brief = peer.told.arrived;
  if (message.brief) message.claim = {};
  out_.push_back(Tell{name, std::move(message)});
}

/// It waits for one out of reach to leave, who may have told the witness since that it has left.
bool Merger::follows() const {
  const auto names = awaited();
  return std::any_of(names.begin(), names.end(),
                     [&](const auto& name) { return !peers_.at(name).reachable; });
}

/// One request at a time: what is asked for now, or else what is to be kept.
void Merger::tell_witness(bool asks) {
  if (!third_ || !third_->reachable) return;
  Claim told = claim();
  if (request_ != 0) {
    standby_.replace(now_);
  } else {
    if (standby_.is_due(now_)) standby_.ask(requests_.next(now_), now_);
    asks = asks || follows();
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

/// What is not known to have arrived, ever more rarely: perhaps the channel carries no more. Whom
/// this one waits for may have changed by what others said.
void Merger::tell_again() {
  const Claim current = claim();
  for (auto& [name, peer] : peers_) {
    Told& told = peer.told;
    if (!peer.reachable) continue;
    if (told.claim != current) {
      told.arrived = false;
      told.again.pause = limits_.beat;
    }
    if (told.arrived || !told.again.is_due(now_)) continue;
    tell(name, false);
    told.again.repeated(now_, limits_.pause);
  }
}

void Merger::ask_again() {
  asked_.repeated(now_, limits_.patience);
  for (const auto& [name, peer] : peers_) {
    if (needs(peer) && !peer.agreed) tell(name, true);
  }
  if (third_ && !third_->agreed) tell_witness(true);
}

}  // namespace skein::merging
