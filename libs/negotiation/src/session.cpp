// SPDX-License-Identifier: Apache-2.0
#include "session.hpp"

#include <algorithm>
#include <utility>

#include "skein/foundation/contract.hpp"

namespace skein::interaction {

namespace {

using Vow = Entry::Vow;

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

// However late a cut heals, there is time to hear of it before half the time is over, or all.
Duration share_of_what_is_left(const Terms& terms, MissionTime now) {
  constexpr double kShare = 0.25;
  const MissionTime until = now < terms.settled_by() ? terms.settled_by() : terms.deadline;
  return Duration::seconds(kShare * (until - now).to_seconds());
}

}  // namespace

Session::Session(Terms terms, std::string self, const NegotiationLimits& limits,
                 std::string told_by, const AnswerTimes& answers_in)
    : terms_(std::move(terms)),
      self_(member(self)),
      limits_(limits),
      told_by_(std::move(told_by)),
      facts_(terms_),
      telling_(terms_.members.size(), self_, terms_.opened, limits.again, limits.again_most) {
  for (std::size_t i = 0; i < terms_.members.size(); ++i) {
    const auto known = answers_in.find(terms_.members[i]);
    if (known != answers_in.end()) telling_.expect_answers_in(i, known->second);
  }
}

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
  reckoning_.begin(std::move(modality));
  telling_.begin(now);
  if (const auto other = difference(wanted, terms_)) {
    set_refused(*other);
  } else if (now >= terms_.settled_by()) {
    set_refused("too late for it");
  } else if (const auto problem = reckoning_.modality().problem_of(terms_)) {
    set_refused(*problem);
  }
  if (terms_.opener == terms_.members[self_]) telling_.owe_all();
  if (wants_offer()) out.emplace_back(PrepareOffer{terms_});
  plan_to_tell(before);
  advance(now, out);
}

void Session::offer(const Result<Rows, Failure>& offer, MissionTime now, NegotiationEffects& out) {
  SKEIN_EXPECTS(wants_offer());
  const FactBits before = facts_.bits();
  const auto problem = offer ? reckoning_.modality().problem_of(terms_, *offer)
                             : std::optional<std::string>(offer.error().why);
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
  return reckoning_.is_under_way() && may_refuse() && facts_.refusal() == nullptr && !outcome_;
}

void Session::reckoned(Result<Rows, Failure> result, MissionTime now, NegotiationEffects& out) {
  SKEIN_EXPECTS(wants_result());
  const FactBits before = facts_.bits();
  if (const auto why = reckoning_.know(std::move(result))) set_refused(*why);
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
  telling_.heard(from, theirs, now);
  const bool news = lacks(before, theirs);
  // The decider's next stage answers what is new to it; if that does not come, they ask again.
  const bool leads = decides() && is_active();
  const bool behind = leads ? facts_.stage_of(theirs) < facts_.stage_of(facts_.bits())
                            : lacks(theirs, facts_.bits());
  const bool echo = message.wants_echo && !(leads && news);
  if (behind || echo) telling_.owe(from);
  plan_to_tell(before);
  advance(now, out);
  return std::nullopt;
}

void Session::tell(const std::string& uav, MissionTime now, NegotiationEffects& out) {
  send_to(member(uav), false, now, out);
}

void Session::pass(MissionTime now, NegotiationEffects& out) {
  advance(now, out);
  if (!is_active() || now < telling_.due()) return;
  // Who ought to have heard more asks everybody: half the time is over, or the decider is silent.
  const bool late = now >= terms_.settled_by() || telling_.decider_is_silent();
  const bool asks = late && !facts_.all_promised();
  const bool invites = terms_.opener == terms_.members[self_];
  const auto again =
      telling_.repeat(facts_.bits(), asks, invites, now, share_of_what_is_left(terms_, now));
  for (const std::size_t one : again) send_to(one, asks, now, out);
}

void Session::advance(MissionTime now, NegotiationEffects& out) {
  const FactBits before = facts_.bits();
  vow(now, out);
  plan_to_tell(before);
  if (auto outcome = is_active() ? outcome_at(now) : std::nullopt) end(std::move(*outcome), out);
  send(now, out);
}

void Session::vow(MissionTime now, NegotiationEffects& out) {
  if (!joined_ || !may_refuse() || facts_.refusal() != nullptr) return;
  if (const auto why = objection(now)) return set_refused(*why);
  if (!facts_.all_offered()) return;
  if (const auto why = reckoning_.reckon(terms_, facts_, out)) return set_refused(*why);
  if (reckoning_.result()) promise();
}

// Why this member can promise nothing.
std::optional<std::string> Session::objection(MissionTime now) const {
  if (const Entry* lost = facts_.loss()) return lost->uav + " was restarted";
  if (auto bad = reckoning_.bad_offer(terms_, facts_)) return bad;
  if (now >= terms_.settled_by()) return missing();
  return std::nullopt;
}

std::string Session::missing() const {
  std::vector<std::string> silent;
  const bool offered = facts_.all_offered();
  for (std::size_t i = 0; i < facts_.size(); ++i) {
    const bool waits =
        i == 0 && !(decides() && reckoning_.is_under_way());  // for the others' promises
    const bool there = offered ? facts_[i].vow != Vow::kNone || waits : facts_[i].offered;
    if (!there) silent.push_back(facts_[i].uav);
  }
  return "half the time is over without " + std::string(offered ? "a promise" : "an offer") +
         " of " + joined_by_commas(silent);
}

// The decider promises last.
void Session::promise() {
  Entry& mine = facts_[self_];
  const std::uint64_t print = reckoning_.fingerprint();
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

std::optional<NegotiationOutcome> Session::outcome_at(MissionTime now) const {
  const bool over = now >= terms_.deadline;
  NegotiationOutcome outcome;
  if (const Entry* refused = facts_.refusal()) {
    outcome.why = refused->uav + ": " + refused->why;
    return outcome;
  }
  if (facts_.all_promised()) {
    outcome.kind = Kind::kAgreed;
    outcome.result = reckoning_.result().value_or(Rows{});
    const auto lagging = decides() ? telling_.who_lags(facts_.bits()) : std::vector<std::size_t>();
    for (const std::size_t one : lagging) outcome.unconfirmed.push_back(terms_.members[one]);
    if (!over && !outcome.unconfirmed.empty()) return std::nullopt;
    return outcome;
  }
  if (!over) return std::nullopt;
  outcome.kind = Kind::kUndecided;
  outcome.result = reckoning_.result().value_or(Rows{});
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
    telling_.ask_every(limits_.ask);
    out.emplace_back(NegotiationEnded{terms_, std::move(outcome)});
  } else {
    out.emplace_back(NegotiationSettled{terms_, std::move(outcome)});
  }
}

// Who has to hear at once of what has become known since `before`: of a refusal of one's own
// everybody, of anything else the decider, and of a further stage everybody from the decider.
void Session::plan_to_tell(FactBits before) {
  const FactBits now = facts_.bits();
  const FactBits own = FactBits{7} << (3 * self_);
  const bool refused = lacks(before & own, now & own) && facts_[self_].vow == Vow::kRefused;
  const bool further = decides() && joined_ && facts_.stage_of(now) > facts_.stage_of(before);
  if (refused || further || lacks(before, now)) telling_.owe_news(now, refused || further);
}

bool Session::is_active() const {
  return joined_ && !moved_ && (!outcome_ || outcome_->kind == Kind::kUndecided);
}

// Who opens it invites the others with its offer, which it prepares at once: without, each would
// be told twice.
void Session::send(MissionTime now, NegotiationEffects& out) {
  if (terms_.opener == terms_.members[self_] && wants_offer()) return;
  const auto owed = telling_.take_owed(facts_.bits(), now);
  for (const std::size_t one : owed) send_to(one, false, now, out);
}

void Session::send_to(std::size_t member, bool asks, MissionTime now, NegotiationEffects& out) {
  telling_.tells(member, facts_.bits(), now);
  const bool wants_echo = asks || telling_.lags(member, facts_.bits());
  out.emplace_back(SendSessionMessage{
      terms_.members[member],
      SessionMessage{terms_.members[self_], terms_, facts_.entries(), wants_echo}});
}

std::optional<MissionTime> Session::next_wakeup() const {
  if (!is_active()) return std::nullopt;
  const MissionTime again = telling_.due();
  if (outcome_) return again;
  std::optional<MissionTime> next = earliest(terms_.deadline, again);
  if (may_refuse() && facts_.refusal() == nullptr) next = earliest(next, terms_.settled_by());
  return next;
}

std::string Session::state_text() const {
  std::string text = to_text(terms_.id()) + (joined_ ? " joined" : " invited");
  text += ", told by " + told_by_;
  if (moved_) text += " moved";
  if (reckoning_.is_under_way()) text += " reckons";
  if (reckoning_.result()) text += " knows the result";
  for (std::size_t i = 0; i < facts_.size(); ++i) {
    const Entry& one = facts_[i];
    text += "; " + one.uav + (one.offered ? " offered" : "") + (one.lost ? " lost" : "");
    if (one.vow == Vow::kPromised) text += " promised " + std::to_string(one.result);
    if (one.vow == Vow::kRefused) text += " refused: " + one.why;
  }
  if (outcome_) text += "; " + std::string(to_text(outcome_->kind));
  return text + "; " + telling_.state_text();
}

}  // namespace skein::interaction
