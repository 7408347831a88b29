// SPDX-License-Identifier: Apache-2.0
#include "skein/negotiation/negotiation_manager.hpp"

#include <algorithm>
#include <tuple>

#include "session.hpp"
#include "skein/foundation/overloaded.hpp"

namespace skein::interaction {

namespace {

std::string listed(const std::vector<std::string>& problems) {
  std::string text;
  for (const std::string& one : problems) text += (text.empty() ? "" : "; ") + one;
  return text;
}

bool is_in(const std::string& uav, const std::vector<std::string>& members) {
  return std::find(members.begin(), members.end(), uav) != members.end();
}

bool earlier(const Terms& one, const Terms& other) {
  return std::tie(one.opened, one.opener) < std::tie(other.opened, other.opener);
}

}  // namespace

class NegotiationManager::Core {
 public:
  Core(std::string self, std::uint32_t mission, Modalities modalities, NegotiationLimits limits,
       MissionTime born)
      : self_(std::move(self)),
        mission_(mission),
        modalities_(std::move(modalities)),
        limits_(limits),
        born_(born),
        now_(born) {}

  Result<NegotiationEffects, Failure> handle(const NegotiationInput& input, MissionTime now) {
    if (now < now_) return failure("time goes back");
    NegotiationEffects out;
    pass_until(now, out);
    const auto done = std::visit([&](const auto& what) { return take(what, out); }, input);
    if (done) return out;
    // What time did has happened whatever becomes of the input.
    kept_.insert(kept_.end(), out.begin(), out.end());
    return tl::unexpected<Failure>(done.error());
  }

  std::string state_text() const {
    std::string text;
    for (const auto& [id, session] : sessions_) text += session.state_text() + "\n";
    for (const auto& [subject, id] : current_) text += subject + " -> " + to_text(id) + "\n";
    for (const auto& [uav, time] : answers_in_) text += uav + " in " + to_text(time) + "\n";
    return text;
  }

  std::optional<MissionTime> next_wakeup() const {
    if (!kept_.empty()) return now_;
    std::optional<MissionTime> next;
    for (const auto& [id, session] : sessions_) next = earliest(next, session.next_wakeup());
    return next;
  }

 private:
  using Done = Result<void, Failure>;

  void pass_until(MissionTime now, NegotiationEffects& out) {
    out.swap(kept_);
    while (Session* next = first_awake(now)) {
      now_ = *next->next_wakeup();
      next->pass(now_, out);
    }
    now_ = now;
    for (auto it = sessions_.begin(); it != sessions_.end();) {
      it = it->second.terms().deadline + limits_.keep < now ? sessions_.erase(it) : std::next(it);
    }
  }

  Session* first_awake(MissionTime until) {
    Session* first = nullptr;
    for (auto& [id, session] : sessions_) {
      const auto wakeup = session.next_wakeup();
      if (!wakeup || *wakeup > until) continue;
      if (first == nullptr || *wakeup < *first->next_wakeup()) first = &session;
    }
    return first;
  }

  Done take(const NegotiationTick&, NegotiationEffects&) { return {}; }

  Done take(const BeginNegotiation& begin, NegotiationEffects& out) {
    const Session* now = under_way(begin.subject);
    if (now != nullptr) return failure("'" + begin.subject + "' is being negotiated");
    Terms terms = terms_of(begin);
    if (const auto problems = problems_with(terms); !problems.empty()) {
      return failure(listed(problems));
    }
    wanted_[begin.subject] = {begin.modality, terms.members, begin.model};
    over_by_[begin.subject] = terms.deadline + begin.within;
    turn_down_others(begin.subject, out);
    Session* invited = invitation_to(begin.subject);
    join(invited != nullptr ? *invited : open(std::move(terms)), out);
    return {};
  }

  Terms terms_of(const BeginNegotiation& begin) const {
    Terms terms{begin.subject,    mission_, begin.modality, begin.members,      begin.model,
                begin.parameters, self_,    now_,           now_ + begin.within};
    std::sort(terms.members.begin(), terms.members.end());
    // Two of one opener at one instant would be one.
    while (sessions_.count(terms.id()) > 0) terms.opened = terms.opened + Duration::nanoseconds(1);
    return terms;
  }

  std::vector<std::string> problems_with(const Terms& terms) const {
    std::vector<std::string> problems = problems_of(terms);
    const auto modality = modalities_.find(terms.modality);
    if (modality == modalities_.end()) {
      problems.push_back("unknown modality '" + terms.modality + "'");
    } else if (problems.empty()) {
      if (auto problem = modality->second->problem_of(terms)) problems.push_back(*problem);
    }
    return problems;
  }

  Session& open(Terms terms) {
    const SessionId id = terms.id();
    return sessions_.emplace(id, Session(std::move(terms), self_, limits_, self_, answers_in_))
        .first->second;
  }

  void join(Session& session, NegotiationEffects& out) {
    const std::string& subject = session.terms().subject;
    current_[subject] = session.terms().id();
    const Wanted& wanted = wanted_.at(subject);
    session.join(wanted, modalities_.at(wanted.modality), now_, out);
  }

  /// That this UAV takes part in and that has not ended.
  Session* under_way(const std::string& subject) {
    const auto id = current_.find(subject);
    if (id == current_.end()) return nullptr;
    const auto session = sessions_.find(id->second);
    if (session == sessions_.end() || session->second.ended()) return nullptr;
    return &session->second;
  }

  Session* invitation_to(const std::string& subject) {
    Session* first = nullptr;
    for (auto& [id, session] : sessions_) {
      if (id.subject != subject || session.takes_part() || !session.may_refuse()) continue;
      if (session.decided() || session.terms().deadline <= now_) continue;
      if (session.terms().deadline > over_by_.at(subject)) continue;
      if (first == nullptr || earlier(session.terms(), first->terms())) first = &session;
    }
    return first;
  }

  Done take(const OfferPrepared& prepared, NegotiationEffects& out) {
    const auto session = sessions_.find(prepared.session);
    if (session == sessions_.end() || !session->second.wants_offer()) {
      return failure("no offer is wanted for " + to_text(prepared.session));
    }
    session->second.offer(prepared.offer, now_, out);
    return {};
  }

  Done take(const ResultReckoned& reckoned, NegotiationEffects& out) {
    const auto session = sessions_.find(reckoned.session);
    if (session == sessions_.end() || !session->second.wants_result()) {
      return failure("no result is wanted for " + to_text(reckoned.session));
    }
    session->second.reckoned(reckoned.result, now_, out);
    return {};
  }

  Done take(const WithdrawNegotiation& withdraw, NegotiationEffects& out) {
    Session* session = under_way(withdraw.subject);
    if (session == nullptr) return failure("'" + withdraw.subject + "' is not being negotiated");
    if (!session->may_refuse()) return failure("'" + withdraw.subject + "' has been promised");
    session->refuse(withdraw.why, now_, out);
    return {};
  }

  Done take(const SessionMessageReceived& received, NegotiationEffects& out) {
    const SessionMessage& message = received.message;
    auto problem = problem_of(message);
    if (!problem) problem = deliver(message, out);
    if (problem) out.emplace_back(MessageRejected{message.from, message.terms.subject, *problem});
    return {};
  }

  std::optional<std::string> problem_of(const SessionMessage& message) const {
    const Terms& terms = message.terms;
    if (const auto problems = problems_of(terms); !problems.empty()) return listed(problems);
    if (terms.mission != mission_) {
      return "of mission " + std::to_string(terms.mission) + ", not " + std::to_string(mission_);
    }
    if (!is_in(self_, terms.members)) return "of a session without " + self_;
    if (message.from == self_) return "from itself";
    if (!is_in(message.from, terms.members)) return "from '" + message.from + "', who is no member";
    return Facts(terms).contradiction_in(message.entries);
  }

  std::optional<std::string> deliver(const SessionMessage& message, NegotiationEffects& out) {
    Session* current = under_way(message.terms.subject);
    const auto known = sessions_.find(message.terms.id());
    if (known != sessions_.end()) {
      // Who still can come after us hears where we are; others, and who promised, hear that we
      // refuse.
      const bool moved = known->second.moved() && shares(current, message.from) &&
                         earlier(current->terms(), message.terms);
      if (moved && !known->second.is_bound(message.from)) {
        current->tell(message.from, now_, out);
        return std::nullopt;
      }
      return receive(known->second, message, out);
    }
    Session fresh(message.terms, self_, limits_, message.from, answers_in_);
    const bool forgotten = message.terms.opened < born_ || fresh.says_more_of_self(message.entries);
    if (!forgotten && message.terms.deadline <= now_) return "of a session that is over";
    if (forgotten) {
      fresh.lose();
    } else if (current != nullptr && current->terms().members != message.terms.members) {
      return turn_down(std::move(fresh), message, out);
    } else if (current != nullptr && !earlier(message.terms, current->terms())) {
      current->tell(message.from, now_, out);  // who sent it will come after us
      return std::nullopt;
    }
    if (!forgotten && current != nullptr &&
        message.terms.deadline > over_by_.at(message.terms.subject)) {
      return "of a session that is over too late";
    }
    if (!has_room_for(message.from)) return too_many();
    const bool moves = !forgotten && current != nullptr && moves_to(message.terms, *current);
    const bool invites = !forgotten && current == nullptr;
    if (moves) leave(*current, message, out);
    Session& session = sessions_.emplace(message.terms.id(), std::move(fresh)).first->second;
    auto problem = receive(session, message, out);
    if (moves && !problem) join(session, out);
    if (invites && !problem && !session.decided()) {
      out.emplace_back(InvitedToNegotiate{session.terms()});
    }
    return problem;
  }

  /// For the earlier session that the message is of. Who sent it does not come after us: it hears
  /// that we left, and does not take the one left for an invitation once this one is over.
  void leave(Session& session, const SessionMessage& message, NegotiationEffects& out) {
    session.leave("it moved to an earlier session");
    if (is_in(message.from, session.terms().members)) session.tell(message.from, now_, out);
  }

  std::optional<std::string> receive(Session& session, const SessionMessage& message,
                                     NegotiationEffects& out) {
    if (auto problem = session.receive(message, now_, out)) return problem;
    const Duration answered_in = session.answered_in(message.from);
    if (answered_in > Duration()) answers_in_[message.from] = answered_in;
    return std::nullopt;
  }

  /// Invitations of other members than those with whom it is to be negotiated.
  void turn_down_others(const std::string& subject, NegotiationEffects& out) {
    const Wanted& wanted = wanted_.at(subject);
    for (auto& [id, session] : sessions_) {
      if (id.subject != subject || session.takes_part() || session.decided()) continue;
      if (session.terms().members == wanted.members || session.terms().deadline <= now_) continue;
      const std::string why = session.turn_down(wanted, now_, out);
      out.emplace_back(MessageRejected{id.opener, subject, why});
    }
  }

  /// Of other members than those with whom the subject is being negotiated.
  std::string turn_down(Session fresh, const SessionMessage& message, NegotiationEffects& out) {
    const std::string& subject = message.terms.subject;
    if (!has_room_for(message.from)) return too_many();
    Session& session = sessions_.emplace(message.terms.id(), std::move(fresh)).first->second;
    if (const auto problem = receive(session, message, out)) return *problem;
    return session.turn_down(wanted_.at(subject), now_, out);
  }

  /// For one more session that `uav` tells of: if need be one is forgotten.
  bool has_room_for(const std::string& uav) {
    std::size_t known = 0;
    auto forgettable = sessions_.end();
    for (auto it = sessions_.begin(); it != sessions_.end(); ++it) {
      const Session& session = it->second;
      const bool counts = session.told_by() == uav && (!session.takes_part() || session.moved());
      if (!counts) continue;
      ++known;
      if (session.may_be_forgotten(now_)) forgettable = it;
    }
    if (known < limits_.sessions_of_one) return true;
    if (forgettable == sessions_.end()) return false;
    sessions_.erase(forgettable);
    return true;
  }

  std::string too_many() const {
    return "it tells of more than " + std::to_string(limits_.sessions_of_one) +
           " sessions in which " + self_ + " takes no part";
  }

  static bool shares(const Session* current, const std::string& uav) {
    return current != nullptr && is_in(uav, current->terms().members);
  }

  bool moves_to(const Terms& terms, const Session& current) const {
    return current.may_refuse() && !current.decided() && now_ < terms.settled_by();
  }

  std::string self_;
  std::uint32_t mission_;
  Modalities modalities_;
  NegotiationLimits limits_;
  MissionTime born_, now_;
  std::map<SessionId, Session> sessions_;
  std::map<std::string, SessionId> current_;  ///< by subject, the last taken part in
  std::map<std::string, Wanted> wanted_;      ///< by subject
  /// By subject: who begins takes part in no session with a later deadline. Twice as long as it is
  /// begun for, since clocks differ.
  std::map<std::string, MissionTime> over_by_;
  AnswerTimes answers_in_;   ///< of the last answer of each
  NegotiationEffects kept_;  ///< of time that passed before a refused input
};

NegotiationManager::NegotiationManager(std::string self, std::uint32_t mission,
                                       Modalities modalities, NegotiationLimits limits,
                                       MissionTime born)
    : core_(std::make_unique<Core>(std::move(self), mission, std::move(modalities), limits, born)) {
}
NegotiationManager::~NegotiationManager() = default;
NegotiationManager::NegotiationManager(const NegotiationManager& other)
    : core_(std::make_unique<Core>(*other.core_)) {}
NegotiationManager& NegotiationManager::operator=(const NegotiationManager& other) {
  core_ = std::make_unique<Core>(*other.core_);
  return *this;
}
NegotiationManager::NegotiationManager(NegotiationManager&&) noexcept = default;
NegotiationManager& NegotiationManager::operator=(NegotiationManager&&) noexcept = default;

Result<NegotiationEffects, Failure> NegotiationManager::handle(const NegotiationInput& input,
                                                               MissionTime now) {
  return core_->handle(input, now);
}

std::optional<MissionTime> NegotiationManager::next_wakeup() const { return core_->next_wakeup(); }

std::string NegotiationManager::state_text() const { return core_->state_text(); }

}  // namespace skein::interaction
