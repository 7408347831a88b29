// SPDX-License-Identifier: Apache-2.0
#include "skein/merging/witness.hpp"

#include <algorithm>

#include "keeps_from.hpp"
#include "names.hpp"

namespace skein::merging {

namespace {

/// Longer than any message is under way: one that comes later was said in this life.
constexpr Duration kUnderWay = Duration::milliseconds(2'500);

}  // namespace

Witness::Witness(const std::vector<std::string>& members) {
  for (const std::string& name : members) records_[name];
}

void Witness::begin(bool first, MissionTime now) {
  first_life_ = first;
  begun_ = now;
}

std::vector<Witness::Answer> Witness::hear(const std::string& from, const Message& message,
                                           MissionTime now) {
  const auto found = records_.find(from);
  if (found == records_.end()) return {};
  if (!first_life_ && now < begun_ + kUnderWay) return {};
  Record& record = found->second;
  if (message.number <= record.number) return {};
  take(record, message);
  answer(from, record);
  std::vector<Answer> answers;
  if (message.asks) answers = replies_to(from, record, now);
  if (record.follows)
    for (const std::string& name : record.claim.waits_for) pass_on(name, from, answers);
  for (const auto& [name, other] : records_)
    if (other.follows && is_among(other.claim.waits_for, from)) pass_on(from, name, answers);
  return answers;
}

std::vector<Witness::Answer> Witness::replies_to(const std::string& from, const Record& record,
                                                 MissionTime now) {
  const std::uint64_t request = record.claim.request;
  if (request == 0 || record.answered != request) return {};
  std::vector<Answer> answers{answer_to(from, request, record.refusers.empty(), now)};
  answers.front().message.claim.waits_for = record.refusers;
  if (record.claim.keeps) return answers;
  for (const std::string& name : record.refusers) {
    const Record& other = records_.at(name);
    if (is_kept_for(other, record.claim.wanted))
      answers.push_back(answer_to(name, other.claim.request, false, now));
  }
  return answers;
}

/// As if `of` had told it `to` itself. What it wants to be kept is between the two of them.
void Witness::pass_on(const std::string& of, const std::string& to,
                      std::vector<Answer>& answers) const {
  const auto found = records_.find(of);
  if (found == records_.end() || !found->second.heard || of == to) return;
  Claim claim = found->second.claim;
  if (claim.keeps) {
    claim.request = 0;
    claim.wanted.clear();
    claim.keeps = false;
  }
  answers.push_back({to, Message{found->second.number, std::move(claim), 0, false, false, of}});
}

Witness::Answer Witness::answer_to(const std::string& to, std::uint64_t request, bool granted,
                                   MissionTime now) {
  return {to, Message{numbers_.next(now), {}, request, granted, false}};
}

/// It does not fly there now, as far as is known here, and may do without. Until it says so it is
/// kept all the same.
bool Witness::is_kept_for(const Record& record, const Volumes& volumes) const {
  const std::uint64_t request = record.claim.request;
  const bool promised = request != 0 && record.answered == request && record.refusers.empty();
  return record.claim.keeps && promised && overlap(volumes, record.claim.wanted);
}

void Witness::take(Record& record, const Message& message) {
  if (!record.heard && !first_life_) record.unsure = message.claim.request;
  record.heard = true;
  record.number = message.number;
  record.claim = message.claim;
  record.follows = message.asks && (record.claim.request == 0 || record.claim.keeps);
}

/// One that was refused is given up by who asked, and may be looked at again until then: whoever
/// has nothing of it any more refuses it no longer. What was granted stays granted.
void Witness::answer(const std::string& from, Record& record) {
  const std::uint64_t request = record.claim.request;
  if (request == 0 || request == record.unsure || !remembers()) return;
  std::vector<std::string> refusers;
  for (const auto& [name, other] : records_) {
    const bool granted = record.answered == request && !is_among(record.refusers, name);
    if (name != from && !granted && may_have(other, from, record.claim)) refusers.push_back(name);
  }
  record.answered = request;
  record.refusers = std::move(refusers);
}

bool Witness::may_have(const Record& record, const std::string& asker, const Claim& asks) const {
  if (keeps_from(record.claim.held, asks.wanted, asks.held)) return true;
  const std::uint64_t request = record.claim.request;
  const bool granted = record.answered == request && !is_among(record.refusers, asker);
  return request != 0 && (granted || request == record.unsure) &&
         overlap(asks.wanted, record.claim.wanted);
}

/// All have told it what they have in this life, or there was none before.
bool Witness::remembers() const {
  return first_life_ || std::all_of(records_.begin(), records_.end(),
                                    [](const auto& one) { return one.second.heard; });
}

}  // namespace skein::merging
