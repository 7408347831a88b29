// SPDX-License-Identifier: Apache-2.0
// Who holds the token, and what a majority has of its ledger. Source: [Ongaro, Ousterhout 2014].
#include <algorithm>

#include "skein/foundation/overloaded.hpp"
#include "team_core.hpp"

namespace skein::auction {

namespace {

bool newer(std::uint64_t term, std::uint64_t revision, const Ledger& than) {
  return std::pair(term, revision) > std::pair(than.term, than.revision);
}

/// What another was given is as if it had been given here. True if any was not known.
bool keep(const std::vector<GivenMission>& missions, const Ledger& ledger,
          std::vector<GivenMission>& known) {
  const std::size_t before = known.size();
  for (const GivenMission& mission : missions) {
    const auto same = std::ranges::find(known, mission.number, &GivenMission::number);
    if (!ledger.missions.contains(mission.number) && same == known.end()) known.push_back(mission);
  }
  return known.size() > before;
}

}  // namespace

TeamMember::Core::Core(TeamSetup setup)
    : setup_(std::move(setup)),
      disk_(std::move(setup_.disk)),
      own_(setup_.self, setup_.limits, disk_),
      others_(setup_.roster),
      names_{setup_.names},
      random_(setup_.seed, "auction/team/" + to_text(setup_.self)) {
  if (!disk_.ledger) disk_.ledger = std::make_shared<const Ledger>();
  std::erase(others_, setup_.self);
  bids_ = setup_.craft != nullptr;
  // What ran when it crashed has stopped.
  for (const auto& [task, sale] : disk_.started) {
    const auto done = disk_.done.find(task);
    if (done == disk_.done.end() || done->second < sale) disk_.stopped[task] = sale;
  }
}

TeamEffects TeamMember::Core::handle(const TeamInput& input, MissionTime now) {
  now_ = now;
  effects_.clear();
  if (!started_) follow();
  started_ = true;
  const auto declare = [this](MemberNumber member, bool lost) {
    losses_.learn(ledger().losses);
    losses_.declare(member, lost);
  };
  std::visit(Overloaded{
                 [this](const Heard& heard) {
                   std::visit([&](const auto& message) { on(message, heard.from); }, heard.message);
                 },
                 [this](const MissionGiven& given) {
                   disk_.missions.push_back(given.mission);
                   stored_ = true;
                 },
                 [this](const TaskDone& done) { stored_ |= own_.done(done.task, now_); },
                 [this](const TaskPutBack& back) { stored_ |= own_.put_back(back); },
                 [this](const Bids& bids) { bids_ = bids.bids && setup_.craft != nullptr; },
                 [&](const DeclaredLost& lost) { declare(lost.member, true); },
                 [&](const DeclaredFound& found) { declare(found.member, false); },
                 [](const Tick&) {},
             },
             input);
  if (role_ != Role::kHolder && now_ >= stand_at_) stand(true);
  if (role_ == Role::kHolder) keep_ledger();
  answer_calls();
  stored_ |= own_.give_up_claims();
  if (const auto begun = own_.begin_next(committed_, now_)) {
    stored_ = true;
    effects_.emplace_back(BeginTask{*begun});
  }
  if (stored_) effects_.insert(effects_.begin(), Store{disk_});
  stored_ = false;
  return std::move(effects_);
}

std::optional<MissionTime> TeamMember::Core::next_wakeup() const {
  if (role_ != Role::kHolder) return stand_at_;
  return earliest(beat_at_, sale_ ? sale_->auctioneer.next_wakeup() : std::nullopt);
}

// Of those that are not declared lost; it counts itself in.
bool TeamMember::Core::majority(const std::set<MemberNumber>& members) const {
  std::size_t all = 0, with = 0;
  for (const MemberNumber member : setup_.roster) {
    if (losses_.is_lost(member, ledger().losses)) continue;
    ++all;
    with += member == setup_.self || members.contains(member) ? 1 : 0;
  }
  return 2 * with > all;
}

void TeamMember::Core::tell(MemberNumber to, TeamMessage message) {
  effects_.emplace_back(Tell{to, std::move(message)});
}

void TeamMember::Core::adopt_term(std::uint64_t term) {
  if (term <= disk_.term) return;
  disk_.term = term;
  disk_.voted = false;
  stored_ = true;
  follow();
}

void TeamMember::Core::follow() {
  if (role_ == Role::kHolder) effects_.emplace_back(TokenLost{});
  role_ = Role::kFollower;
  sale_.reset();
  const double part = random_.uniform();
  const auto chance = static_cast<double>(setup_.limits.patience.count()) * part;
  stand_at_ =
      now_ + setup_.limits.patience + Duration::nanoseconds(static_cast<std::int64_t>(chance));
}

// First on trial: who was cut off comes back without making everybody vote.
void TeamMember::Core::stand(bool trial) {
  follow();
  role_ = Role::kCandidate;
  trial_ = trial;
  votes_.clear();
  if (!trial) {
    ++disk_.term;
    disk_.voted = true;
    stored_ = true;
  }
  const VoteRequest request{disk_.term + (trial ? 1 : 0), trial, ledger().term, ledger().revision};
  for (const MemberNumber member : others_) tell(member, request);
  // Whom it hears may hear the holder, which it does not.
  const Status mine = status();
  if (trial && !mine.missions.empty())
    for (const MemberNumber member : others_) tell(member, mine);
  if (majority({})) trial ? stand(false) : hold();
}

void TeamMember::Core::on(const VoteRequest& request, MemberNumber from) {
  const bool content =
      !newer(ledger().term, ledger().revision,
             Ledger{request.ledger_term, request.ledger_revision, {}, {}, {}, {}, {}});
  // On trial it asks for the term after its own.
  if (request.term < disk_.term + (request.trial ? 1 : 0)) {
    return tell(from, NewerTerm{disk_.term});
  }
  if (request.trial) {
    const bool alone =
        role_ != Role::kHolder && (!last_beat_ || now_ - *last_beat_ >= setup_.limits.patience);
    if (alone && content) tell(from, Vote{request.term, true});
    return;
  }
  adopt_term(request.term);
  if (disk_.voted || !content) return;
  disk_.voted = true;
  stored_ = true;
  follow();
  tell(from, Vote{request.term, false});
}

void TeamMember::Core::on(const Vote& vote, MemberNumber from) {
  if (role_ != Role::kCandidate || vote.trial != trial_) return;
  if (vote.term != disk_.term + (trial_ ? 1 : 0)) return;
  votes_.insert(from);
  if (majority(votes_)) trial_ ? stand(false) : hold();
}

void TeamMember::Core::on(const NewerTerm& newer, MemberNumber) { adopt_term(newer.term); }

// The first thing it writes is its term: what older holders wrote is committed with it.
void TeamMember::Core::hold() {
  role_ = Role::kHolder;
  followers_ = {};
  wants_.clear();
  task_ends_ = {};
  kept_back_.clear();
  held_since_ = now_;
  committed_ = 0;
  took_part_.clear();
  effects_.emplace_back(TokenTaken{disk_.term});
  draft();
}

void TeamMember::Core::beat() {
  beat_at_ = now_ + setup_.limits.beat;
  for (const MemberNumber member : others_) {
    const bool is_told = followers_.is_told(member, ledger().revision, now_, setup_.limits.beat);
    tell(member, Beat{disk_.term, committed_, is_told ? disk_.ledger : nullptr});
  }
}

void TeamMember::Core::on(const Beat& beat, MemberNumber from) {
  if (beat.term < disk_.term) return tell(from, NewerTerm{disk_.term});
  adopt_term(beat.term);
  follow();
  last_beat_ = now_;
  if (beat.ledger && newer(beat.ledger->term, beat.ledger->revision, ledger())) {
    disk_.ledger = beat.ledger;
    stored_ = true;
  }
  committed_ = beat.committed;
  stored_ |= own_.give_up_claims();
  tell(from, status());
}

void TeamMember::Core::on(const Status& status, MemberNumber from) {
  adopt_term(status.term);
  if (role_ != Role::kHolder) stored_ |= keep(status.missions, ledger(), disk_.missions);
  if (role_ != Role::kHolder || status.term < disk_.term) return;
  followers_.hear(from, status, now_);
}

// The greatest revision that a majority has.
void TeamMember::Core::commit() {
  std::vector<std::uint64_t> revisions = followers_.revisions();
  revisions.insert(revisions.begin(), ledger().revision);
  for (const std::uint64_t revision : revisions) {
    if (revision > committed_ && majority(followers_.with(revision))) {
      committed_ = revision;
      changed_ = true;
    }
  }
}

// One after the other: of two auctioneers the later is answered, and the other asks again.
void TeamMember::Core::on(const ToMember& call, MemberNumber from) { kept_call_ = {from, call}; }

// Nobody bids for another.
void TeamMember::Core::on(const ToAuctioneer& answer, MemberNumber from) {
  ToAuctioneer said = answer;
  std::visit([from](auto& one) { one.member = from; }, said);
  if (sale_) take(sale_->auctioneer.handle(said, now_));
}

}  // namespace skein::auction
