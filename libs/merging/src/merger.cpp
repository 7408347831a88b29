// SPDX-License-Identifier: Apache-2.0
#include "skein/merging/merger.hpp"

#include <algorithm>

#include "skein/foundation/contract.hpp"

namespace skein::merging {

namespace {

constexpr const char* kToLeave = "to leave";
constexpr const char* kToGoFirst = "to go first, it has waited long";
constexpr const char* kToBeAnswered = "to be answered itself";

constexpr Duration kClocksApart = Duration::milliseconds(1'000);  ///< of two members, at the most

/// Numbers go on rising in the life after one that is forgotten.
std::uint64_t milliseconds(MissionTime now) {
  return static_cast<std::uint64_t>(std::max<std::int64_t>(now.count(), 0)) / 1'000'000;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

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
  const bool says = !held_.empty() || waits();
  if (changed_ || (says && now_ >= said_ + limits_.beat)) tell_all();
  if (request_ != 0 && now_ >= asked_ + limits_.repeat) ask_again();
  return std::move(out_);
}

std::optional<MissionTime> Merger::next_wakeup() const {
  std::optional<MissionTime> next;
  if (!held_.empty() || waits()) next = said_ + limits_.beat;
  if (request_ != 0) return earliest(next, std::min(deadline_, asked_ + limits_.repeat));
  if (!waits()) return next;
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
  if (third_ && heard.from == third_->name) return hear_witness(heard.message);
  const auto found = peers_.find(heard.from);
  if (found == peers_.end()) return;
  Peer& peer = found->second;
  const Message& message = heard.message;
  if (message.number <= peer.number) return;
  const bool is_new = !peer.heard;
  peer.number = message.number;
  peer.heard = true;
  peer.claim = message.claim;
  if (peer.claim.wanted.empty())
    peer.wants_since.reset();
  else if (!peer.wants_since)
    peer.wants_since = now_;
  const bool answers = needs(peer) && request_ != 0 && message.answered == request_;
  peer.known = peer.known || answers;
  if (answers && message.granted) peer.agreed = true;
  if (answers && !message.granted) close(limits_.again);
  answer(peer);
  if (is_new || message.asks) tell(heard.from, false);
}

/// Between this and a later one: yes to what this one neither has nor asks for; to an earlier one,
/// where there is a witness, to what it does not have, and what this one asks for it gives up. Said
/// once for each request, since who is refused gives the request up.
void Merger::answer(Peer& peer) {
  const std::uint64_t request = peer.claim.request;
  if ((peer.earlier && !third_) || request == 0 || request == peer.answered) return;
  if (may_have_been_promised(request)) return;
  const bool has = overlap(held_, peer.claim.wanted);
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
  found->second.reachable = reach.reachable;
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

// ---- what it wants ----

bool Merger::has(const Peer& peer, const Volumes& volumes) const {
  if (overlap(volumes, peer.claim.held)) return true;
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

/// In a life before this: requests have the time at which they were opened.
bool Merger::may_have_been_promised(std::uint64_t request) const {
  return third_ && !first_life_ && request < milliseconds(*begun_ + kClocksApart);
}

bool Merger::has_agreed(const Peer& peer) const {
  return !needs(peer) || peer.agreed || (third_ && third_->agreed && peer.known);
}

bool Merger::presses(const std::optional<MissionTime>& since) const {
  return since && now_ >= *since + limits_.pressing;
}

/// Of two that press, it has waited longer; where that is not clear to both, the earlier has.
bool Merger::waits_longer(const Peer& peer) const {
  if (!presses(peer.wants_since)) return false;
  if (!presses(wants_since_)) return true;
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
    if (peer.claim.request != 0 || contains(wanting, name))
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

std::vector<std::string> Merger::awaited() const {
  std::vector<std::string> names;
  for (const Waits::Why& why : told_)
    if (why.why == kToLeave) names.push_back(why.peer);
  return names;
}

std::vector<std::string> Merger::in_its_way() const {
  std::vector<std::string> names;
  for (const Waits::Why& why : told_)
    if (why.why == kToLeave || why.why == kToGoFirst) names.push_back(why.peer);
  return names;
}

std::vector<Merger::Waiter> Merger::waiters() const {
  std::vector<Waiter> all;
  for (const auto& [name, peer] : peers_) {
    const std::vector<std::string>& for_whom = peer.claim.waits_for;
    if (std::find(for_whom.begin(), for_whom.end(), self_) == for_whom.end()) continue;
    if (!overlap(held_, peer.claim.wanted)) continue;
    all.push_back({name, overlap({held_.back()}, peer.claim.wanted)});
  }
  return all;
}

void Merger::advance() {
  if (!waits()) return;
  if (request_ != 0) {
    const bool all = std::all_of(peers_.begin(), peers_.end(),
                                 [&](const auto& one) { return has_agreed(one.second); });
    if (all) return grant();
    if (now_ < deadline_) return;
    close(limits_.patience);
  }
  if (now_ >= pause_ && ask()) return;
  say_waits();
  look_for_circle();
}

/// Asks for the first choice that nobody it knows of has; at once granted where nobody is earlier.
bool Merger::ask() {
  const bool possible = std::all_of(peers_.begin(), peers_.end(),
                                    [&](const auto& one) { return may_agree(one.second); });
  if (!possible) return false;
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
  request_ = last_request_ = std::max(last_request_ + 1, milliseconds(now_));
  deadline_ = now_ + limits_.patience;
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

// ---- what it waits for ----

std::vector<Waits::Why> Merger::whys() const {
  std::vector<Waits::Why> result;
  const Volumes& first = choices_.front();
  for (const auto& [name, peer] : peers_) {
    if (has(peer, first)) {
      result.push_back({name, kToLeave});
    } else if (!may_agree(peer) || (third_ && !peer.heard && peer.reachable)) {
      result.push_back({name, peer.reachable ? "to tell what it has" : "to come into reach"});
    } else if (third_ && contains(third_->refusers, name)) {
      result.push_back({name, kToLeave});
    } else if (asks_for(peer, first)) {
      result.push_back({name, kToBeAnswered});
    } else if (yields_to(peer, first)) {
      result.push_back({name, kToGoFirst});
    }
  }
  return result;
}

void Merger::say_waits() {
  const std::vector<Waits::Why> now = whys();
  if (now == told_ || now.empty()) return;
  told_ = now;
  changed_ = true;
  out_.push_back(Waits{now});
}

/// Whoever finds no place aside still waits for what it wants afterwards: the next of the circle
/// sees that it stands.
std::vector<std::string> Merger::waits_for() const {
  std::vector<std::string> names = in_its_way();
  for (const auto& [name, peer] : peers_) {
    const bool stands = has(peer, afterwards_) || yields_to(peer, afterwards_);
    if (stands && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

/// From itself along who waits for whom, back to itself; empty: there is none.
std::vector<std::string> Merger::circle() const {
  std::vector<std::string> way;
  std::map<std::string, bool> seen;
  const auto walk = [&](const auto& self, const std::string& name,
                        const std::vector<std::string>& next) -> bool {
    way.push_back(name);
    for (const std::string& one : next) {
      if (one == self_) return true;
      const auto peer = peers_.find(one);
      if (peer == peers_.end() || seen[one]) continue;
      seen[one] = true;
      if (self(self, one, peer->second.claim.waits_for)) return true;
    }
    way.pop_back();
    return false;
  };
  walk(walk, self_, waits_for());
  return way;
}

/// Whoever presses moves last, and of the others the last of the roster first.
bool Merger::moves_before_this(const Peer& peer) const {
  if (presses(peer.wants_since) || presses(wants_since_)) return !waits_longer(peer);
  return !peer.earlier;
}

/// One has to move; when that does not help, the next.
void Merger::look_for_circle() {
  const std::vector<std::string> found = circle();
  if (found.empty()) return circle_since_.reset();
  if (!circle_since_) circle_since_ = now_;
  std::int64_t before = 0;
  bool all_hear = true;
  for (const std::string& one : found) {
    const auto peer = peers_.find(one);
    if (peer == peers_.end()) continue;
    if (moves_before_this(peer->second)) ++before;
    all_hear = all_hear && peer->second.reachable;
  }
  const Duration patience = limits_.circle + Duration::nanoseconds(before * limits_.next.count());
  if (now_ < *circle_since_ + patience || now_ < moved_aside_) return;
  moved_aside_ = now_ + limits_.moves;
  out_.push_back(MoveAside{found, !all_hear});
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
  const Peer& peer = peers_.at(name);
  if (!peer.reachable) return;
  number_ = std::max(number_ + 1, milliseconds(now_));
  out_.push_back(Tell{name, Message{number_, claim(), peer.answered, peer.granted, asks}});
}

void Merger::tell_witness(bool asks) {
  if (!third_ || !third_->reachable) return;
  number_ = std::max(number_ + 1, milliseconds(now_));
  out_.push_back(Tell{third_->name, Message{number_, claim(), 0, false, asks}});
}

/// The witness is told what changes, and asked; it needs no beat.
void Merger::tell_all() {
  if (changed_ || request_ != 0) tell_witness(request_ != 0);
  changed_ = false;
  said_ = asked_ = now_;
  // Whoever has left may have said so when it was not heard, and says no more.
  for (const auto& [name, peer] : peers_) tell(name, waits());
}

void Merger::ask_again() {
  asked_ = now_;
  for (const auto& [name, peer] : peers_) {
    if (needs(peer) && !peer.agreed) tell(name, true);
  }
  if (third_ && !third_->agreed) tell_witness(true);
}

}  // namespace skein::merging
