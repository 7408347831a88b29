// SPDX-License-Identifier: Apache-2.0
#include "session.hpp"

#include <algorithm>
#include <utility>

#include "skein/foundation/contract.hpp"
#include "skein/foundation/fingerprint.hpp"

namespace skein::interaction {

namespace {

using Vow = Entry::Vow;

std::uint64_t fingerprint_of(const Rows& rows) {
  Fingerprint print;
  for (const Row& row : rows) {
    print.put(row.name).put(row.text).put(std::uint64_t{row.numbers.size()});
    for (const double number : row.numbers) print.put(number);
  }
  return print.value();
}

std::string joined_by_commas(const std::vector<std::string>& all) {
  std::string text;
  for (const std::string& one : all) text += (text.empty() ? "" : ", ") + one;
  return text;
}

std::optional<std::string> difference(const Wanted& wanted, const Terms& terms) {
  if (wanted.model != terms.model) {
    return "another version of the model: " + to_text(wanted.model) + ", that of " + terms.opener +
           " is " + to_text(terms.model);
  }
  if (wanted.modality != terms.modality) {
    return "another modality: " + wanted.modality + ", not " + terms.modality;
  }
  if (wanted.members != terms.members) {
    return "other members: " + joined_by_commas(wanted.members) + ", not " +
           joined_by_commas(terms.members);
  }
  return std::nullopt;
}

}  // namespace

Session::Session(Terms terms, std::string self, const NegotiationLimits& limits,
                 std::string told_by)
    : terms_(std::move(terms)),
      self_(member(self)),
      limits_(limits),
      told_by_(std::move(told_by)),
      facts_(terms_),
      told_(terms_.members.size(), 0),
      last_sent_(terms_.opened) {}

std::size_t Session::member(const std::string& uav) const {
  const auto found = std::find(terms_.members.begin(), terms_.members.end(), uav);
  SKEIN_EXPECTS(found != terms_.members.end());
  return static_cast<std::size_t>(found - terms_.members.begin());
}

bool Session::may_refuse() const { return facts_[self_].vow == Vow::kNone && !facts_[self_].lost; }

bool Session::may_be_forgotten(MissionTime now) const {
  return terms_.deadline <= now || (decided() && may_refuse());
}

bool Session::says_more_of_self(const std::vector<Entry>& entries) const {
  const Entry& mine = facts_[self_];
  const Entry& told = entries[self_];
  return (told.offered && !mine.offered) || (told.vow != Vow::kNone && mine.vow == Vow::kNone);
}

void Session::join(const Wanted& wanted, std::shared_ptr<const NegotiationModality> modality,
                   MissionTime now, NegotiationEffects& out) {
  const FactBits before = facts_.bits();
  joined_ = true;
  modality_ = std::move(modality);
  last_sent_ = now;
  if (const auto other = difference(wanted, terms_)) {
    set_refused(*other);
  } else if (now >= terms_.settled_by()) {
    set_refused("too late for it");
  } else if (const auto problem = modality_->problem_of(terms_)) {
    set_refused(*problem);
  }
  if (terms_.opener == terms_.members[self_]) {
    for (std::size_t i = 0; i < facts_.size(); ++i) to_tell_.insert(i);
  }
  if (wants_offer()) out.emplace_back(PrepareOffer{terms_});
  plan_to_tell(before);
  advance(now, out);
}

void Session::offer(const Result<Rows, Failure>& offer, MissionTime now, NegotiationEffects& out) {
  SKEIN_EXPECTS(wants_offer());
  const FactBits before = facts_.bits();
  const auto problem =
      offer ? modality_->problem_of(terms_, *offer) : std::optional<std::string>(offer.error().why);
  if (problem) {
    set_refused(*problem);
  } else {
    facts_[self_].offered = true;
    facts_[self_].offer = *offer;
  }
  plan_to_tell(before);
  advance(now, out);
}

bool Session::wants_result() const {
  return reckons_ && may_refuse() && facts_.refusal() == nullptr && !outcome_;
}

void Session::reckoned(Result<Rows, Failure> result, MissionTime now, NegotiationEffects& out) {
  SKEIN_EXPECTS(wants_result());
  const FactBits before = facts_.bits();
  reckons_ = false;
  know(std::move(result));
  plan_to_tell(before);
  advance(now, out);
}

void Session::refuse(const std::string& why, MissionTime now, NegotiationEffects& out) {
  SKEIN_EXPECTS(may_refuse());
  const FactBits before = facts_.bits();
  set_refused(why);
  plan_to_tell(before);
  advance(now, out);
}

void Session::leave(const std::string& why) {
  SKEIN_EXPECTS(may_refuse());
  moved_ = true;
  set_refused(why);
}

std::string Session::turn_down(const Wanted& wanted, MissionTime now, NegotiationEffects& out) {
  SKEIN_EXPECTS(!joined_);
  const FactBits before = facts_.bits();
  const std::string why = difference(wanted, terms_).value_or("another is under way");
  if (may_refuse()) set_refused(why);
  plan_to_tell(before);
  send(now, out);
  return why;
}

bool Session::is_bound(const std::string& uav) const {
  return facts_[member(uav)].vow == Vow::kPromised;
}

std::optional<std::string> Session::receive(const SessionMessage& message, MissionTime now,
                                            NegotiationEffects& out) {
  if (message.terms != terms_) return "other terms than those of this session";
  if (auto problem = facts_.contradiction_in(message.entries)) return problem;
  const std::size_t from = member(message.from);
  const FactBits before = facts_.bits();
  const FactBits theirs = Facts::bits_of(message.entries);
  if (says_more_of_self(message.entries)) lose();
  facts_.merge(message.entries);
  told_[from] |= theirs;
  const bool news = lacks(before, theirs);
  if (from == 0) unheard_ = 0;
  // The decider's next stage answers what is new to it; if that does not come, they ask again.
  const bool leads = decides() && is_active();
  const bool behind =
      leads ? stage_of(theirs) < stage_of(facts_.bits()) : lacks(theirs, facts_.bits());
  const bool echo = message.wants_echo && !(leads && news);
  if (behind || echo) to_tell_.insert(from);
  plan_to_tell(before);
  advance(now, out);
  return std::nullopt;
}

// 1: somebody has to offer; 2: somebody has to promise; 3: decided.
int Session::stage_of(FactBits bits) const {
  FactBits offers = 0;
  for (std::size_t i = 0; i < facts_.size(); ++i) offers |= FactBits{1} << (3 * i);
  constexpr FactBits kDecision = 2;
  const Entry* refused = facts_.refusal();
  if ((bits & kDecision) != 0) return 3;
  if (refused != nullptr) {
    const std::size_t who = member(refused->uav);
    if ((bits & (FactBits{2} << (3 * who))) != 0) return 3;
  }
  return (bits & offers) == offers ? 2 : 1;
}

void Session::tell(const std::string& uav, NegotiationEffects& out) {
  const std::size_t to = member(uav);
  send_to(to, lags(to), out);
}

void Session::pass(MissionTime now, NegotiationEffects& out) {
  advance(now, out);
  if (!is_active() || now < again_at()) return;
  const std::set<std::size_t> again = who_is_told_again(now);
  for (const std::size_t one : again) send_to(one, lags(one) || asks(now), out);
  if (!again.empty()) ++unheard_;
  last_sent_ = now;
}

void Session::advance(MissionTime now, NegotiationEffects& out) {
  const FactBits before = facts_.bits();
  vow(now, out);
  plan_to_tell(before);
  conclude(now, out);
  send(now, out);
}

void Session::vow(MissionTime now, NegotiationEffects& out) {
  if (!joined_ || !may_refuse() || facts_.refusal() != nullptr) return;
  if (const auto why = objection(now)) return set_refused(*why);
  if (!facts_.all_offered()) return;
  if (!result_) reckon(out);
  if (result_) promise();
}

void Session::reckon(NegotiationEffects& out) {
  if (!modality_->is_long()) return know(modality_->settle(terms_, offers()));
  if (!std::exchange(reckons_, true)) out.emplace_back(ReckonResult{terms_, offers()});
}

void Session::know(Result<Rows, Failure> result) {
  if (!result) return set_refused(result.error().why);
  result_ = std::move(*result);
}

Offers Session::offers() const {
  Offers all;
  for (const Entry& one : facts_.entries()) all[one.uav] = one.offer;
  return all;
}

// Why this member can promise nothing.
std::optional<std::string> Session::objection(MissionTime now) const {
  if (const Entry* lost = facts_.loss()) return lost->uav + " was restarted";
  if (auto bad = bad_offer()) return bad;
  if (now >= terms_.settled_by()) return missing();
  return std::nullopt;
}

std::optional<std::string> Session::bad_offer() const {
  for (const Entry& one : facts_.entries()) {
    if (!one.offered) continue;
    if (auto problem = modality_->problem_of(terms_, one.offer)) {
      return "the offer of " + one.uav + ": " + *problem;
    }
  }
  return std::nullopt;
}

std::string Session::missing() const {
  std::vector<std::string> silent;
  const bool offered = facts_.all_offered();
  for (std::size_t i = 0; i < facts_.size(); ++i) {
    const bool waits = i == 0 && !(decides() && reckons_);  // for the others' promises
    const bool there = offered ? facts_[i].vow != Vow::kNone || waits : facts_[i].offered;
    if (!there) silent.push_back(facts_[i].uav);
  }
  return "half the time is over without " + std::string(offered ? "a promise" : "an offer") +
         " of " + joined_by_commas(silent);
}

// The decider promises last.
void Session::promise() {
  Entry& mine = facts_[self_];
  const std::uint64_t print = fingerprint_of(*result_);
  for (std::size_t i = 1; decides() && i < facts_.size(); ++i) {
    if (facts_[i].vow != Vow::kPromised) return;
    if (facts_[i].result != print) {
      return set_refused(facts_[i].uav + " reckons another result from the same offers");
    }
  }
  mine.vow = Vow::kPromised;
  mine.result = print;
}

void Session::set_refused(const std::string& why) {
  facts_[self_].vow = Vow::kRefused;
  facts_[self_].why = why;
}

void Session::conclude(MissionTime now, NegotiationEffects& out) {
  if (!is_active()) return;
  if (auto outcome = outcome_at(now)) end(std::move(*outcome), out);
}

std::optional<NegotiationOutcome> Session::outcome_at(MissionTime now) const {
  const bool over = now >= terms_.deadline;
  NegotiationOutcome outcome;
  if (const Entry* refused = facts_.refusal()) {
    outcome.why = refused->uav + ": " + refused->why;
    return outcome;
  }
  if (facts_.all_promised()) {
    outcome.kind = Kind::kAgreed;
    outcome.result = result_.value_or(Rows{});
    if (decides()) outcome.unconfirmed = who_lags();
    if (!over && !outcome.unconfirmed.empty()) return std::nullopt;
    return outcome;
  }
  if (!over) return std::nullopt;
  outcome.kind = Kind::kUndecided;
  outcome.result = result_.value_or(Rows{});
  outcome.why = facts_[self_].lost ? "it may have promised before it was restarted"
                                   : "promised, and heard from nobody who knows whether " +
                                         terms_.decider() + " did";
  return outcome;
}

void Session::end(NegotiationOutcome outcome, NegotiationEffects& out) {
  const bool first = !outcome_;
  if (!first && outcome.kind == Kind::kUndecided) return;
  outcome_ = outcome;
  if (first) {
    out.emplace_back(NegotiationEnded{terms_, std::move(outcome)});
  } else {
    out.emplace_back(NegotiationSettled{terms_, std::move(outcome)});
  }
}

std::vector<std::string> Session::who_lags() const {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < facts_.size(); ++i) {
    if (i != self_ && lags(i)) all.push_back(facts_[i].uav);
  }
  return all;
}

// Who has to hear at once of what has become known since `before`: of a refusal of one's own
// everybody, of anything else the decider, and of a further stage everybody from the decider.
void Session::plan_to_tell(FactBits before) {
  const FactBits now = facts_.bits();
  const FactBits own = FactBits{7} << (3 * self_);
  const bool refused = lacks(before & own, now & own) && facts_[self_].vow == Vow::kRefused;
  const bool further = decides() && joined_ && stage_of(now) > stage_of(before);
  for (std::size_t i = 0; i < facts_.size(); ++i) {
    const bool hears = refused || further || (i == 0 && lacks(before, now));
    if (hears && lags(i)) to_tell_.insert(i);
  }
}

// Who ought to have heard more asks everybody: half the time is over, or the decider is silent.
bool Session::asks(MissionTime now) const {
  if (!is_active() || facts_.all_promised()) return false;
  return now >= terms_.settled_by() || (unheard_ >= 2 && !decides());
}

bool Session::is_active() const {
  return joined_ && !moved_ && (!outcome_ || outcome_->kind == Kind::kUndecided);
}

MissionTime Session::again_at() const {
  return last_sent_ + (outcome_ ? limits_.ask : limits_.again);
}

std::set<std::size_t> Session::who_is_told_again(MissionTime now) const {
  std::set<std::size_t> all;
  const bool opener = terms_.opener == terms_.members[self_];
  for (std::size_t i = 0; i < facts_.size(); ++i) {
    if (i == self_) continue;
    const bool uninvited = opener && told_[i] == 0;
    if (asks(now) || (lags(i) && (i == 0 || decides() || uninvited))) all.insert(i);
  }
  return all;
}

void Session::send(MissionTime now, NegotiationEffects& out) {
  to_tell_.erase(self_);
  if (to_tell_.empty()) return;
  for (const std::size_t one : to_tell_) send_to(one, lags(one), out);
  to_tell_.clear();
  last_sent_ = now;
}

void Session::send_to(std::size_t member, bool wants_echo, NegotiationEffects& out) const {
  out.emplace_back(SendSessionMessage{
      terms_.members[member],
      SessionMessage{terms_.members[self_], terms_, facts_.entries(), wants_echo}});
}

std::optional<MissionTime> Session::next_wakeup() const {
  if (!is_active()) return std::nullopt;
  if (outcome_) return again_at();
  std::optional<MissionTime> next = earliest(terms_.deadline, again_at());
  if (may_refuse() && facts_.refusal() == nullptr) next = earliest(next, terms_.settled_by());
  return next;
}

std::string Session::state_text() const {
  std::string text = to_text(terms_.id()) + (joined_ ? " joined" : " invited");
  text += ", told by " + told_by_;
  if (moved_) text += " moved";
  if (reckons_) text += " reckons";
  if (result_) text += " knows the result";
  for (std::size_t i = 0; i < facts_.size(); ++i) {
    const Entry& one = facts_[i];
    text += "; " + one.uav + (one.offered ? " offered" : "") + (one.lost ? " lost" : "");
    if (one.vow == Vow::kPromised) text += " promised " + std::to_string(one.result);
    if (one.vow == Vow::kRefused) text += " refused: " + one.why;
    if (i != self_) text += " knows " + std::to_string(told_[i]);
  }
  if (outcome_) text += "; " + std::string(to_text(outcome_->kind));
  return text + "; " + std::to_string(unheard_) + " unheard since " + to_text(last_sent_);
}

}  // namespace skein::interaction
