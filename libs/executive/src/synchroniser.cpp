// SPDX-License-Identifier: Apache-2.0
#include "synchroniser.hpp"

#include <algorithm>

namespace skein::executive {

namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

std::vector<std::string> Synchroniser::targets(const Synchronisation& synchronisation) const {
  std::vector<std::string> names;
  if (!contains(synchronisation.senders, own_)) return names;
  std::set<std::string> met{own_};
  for (const std::string& receiver : synchronisation.receivers) {
    if (met.insert(receiver).second) names.push_back(receiver);
  }
  return names;
}

bool Synchroniser::counts(const Heard& heard, MissionTime now) const {
  if (heard.word == SyncWord::kWithdrawn) return false;
  return heard.word == SyncWord::kDone || !validity_ || now - heard.said <= *validity_;
}

const Synchroniser::Heard* Synchroniser::last_of(std::uint64_t id,
                                                 const std::string& sender) const {
  const auto heard = heard_.find(id);
  if (heard == heard_.end()) return nullptr;
  const auto one = heard->second.find(sender);
  return one == heard->second.end() ? nullptr : &one->second;
}

bool Synchroniser::is_there(std::uint64_t id, const std::string& sender, MissionTime now) const {
  const Heard* last = last_of(id, sender);
  return last != nullptr && counts(*last, now);
}

bool Synchroniser::all_there(std::uint64_t id, const std::set<std::string>& senders,
                             MissionTime now) const {
  return std::all_of(senders.begin(), senders.end(),
                     [&](const std::string& name) { return is_there(id, name, now); });
}

std::vector<Wait> Synchroniser::waits(MissionTime now) const {
  std::vector<Wait> all;
  for (const auto& [id, tasks] : waiting_) {
    for (const auto& [task, awaited] : tasks) {
      Wait& wait = all.emplace_back(Wait{task, id, awaited.since, {}});
      for (const std::string& sender : awaited.senders)
        if (!is_there(id, sender, now)) wait.awaited.push_back(sender);
    }
  }
  return all;
}

bool Synchroniser::begin(TaskId task, const Synchronisation& synchronisation, MissionTime now) {
  for (const std::string& name : targets(synchronisation)) {
    sent_[name].emplace(task, Sent{synchronisation.id, false});
    withdrawn_[name].erase(synchronisation.id);
  }
  if (!contains(synchronisation.receivers, own_)) return true;
  std::set<std::string> senders(synchronisation.senders.begin(), synchronisation.senders.end());
  senders.erase(own_);
  if (all_there(synchronisation.id, senders, now)) return true;
  waiting_[synchronisation.id].emplace(task, Awaited{std::move(senders), now});
  return false;
}

bool Synchroniser::met_before(const Synchronisation& synchronisation) const {
  const auto& senders = synchronisation.senders;
  return heard_.contains(synchronisation.id) &&
         std::all_of(senders.begin(), senders.end(), [&](const std::string& sender) {
           const Heard* last = last_of(synchronisation.id, sender);
           return sender == own_ || (last != nullptr && last->word == SyncWord::kDone);
         });
}

// A late message is older than what is known; of one instant the later arrival counts.
std::vector<TaskId> Synchroniser::received(const SyncReceived& message, MissionTime now) {
  std::vector<TaskId> complete;
  const Heard heard{message.word, message.said.value_or(now)};
  const auto [known, is_new] = heard_[message.id].try_emplace(message.from, heard);
  if (!is_new && heard.said < known->second.said) return complete;
  known->second = heard;
  const auto waiting = waiting_.find(message.id);
  if (waiting == waiting_.end()) return complete;
  for (const auto& [task, awaited] : waiting->second) {
    if (all_there(message.id, awaited.senders, now)) complete.push_back(task);
  }
  return complete;
}

std::vector<std::pair<std::uint64_t, SyncWord>> Synchroniser::missed_by(
    const std::string& name) const {
  std::vector<std::pair<std::uint64_t, SyncWord>> words;
  std::map<std::uint64_t, std::size_t> place;
  if (const auto sent = sent_.find(name); sent != sent_.end()) {
    for (const auto& [task, one] : sent->second) {
      const auto [at, is_new] = place.emplace(one.id, words.size());
      if (is_new) words.emplace_back(one.id, SyncWord::kThere);
      if (validity_ && one.done) words[at->second].second = SyncWord::kDone;
    }
  }
  if (const auto withdrawn = withdrawn_.find(name); withdrawn != withdrawn_.end()) {
    for (const std::uint64_t id : withdrawn->second) words.emplace_back(id, SyncWord::kWithdrawn);
  }
  return words;
}

void Synchroniser::finish(TaskId task, const Synchronisation& synchronisation) {
  for (const std::string& name : targets(synchronisation)) {
    const auto sent = sent_.find(name);
    if (sent == sent_.end()) continue;
    if (const auto one = sent->second.find(task); one != sent->second.end())
      one->second.done = true;
  }
  const auto waiting = waiting_.find(synchronisation.id);
  if (waiting == waiting_.end()) return;
  waiting->second.erase(task);
  if (waiting->second.empty()) waiting_.erase(waiting);
}

void Synchroniser::forget(TaskId task, const Synchronisation& synchronisation) {
  finish(task, synchronisation);
  for (const std::string& name : targets(synchronisation)) {
    const auto sent = sent_.find(name);
    if (sent == sent_.end()) continue;
    sent->second.erase(task);
    if (sent->second.empty()) sent_.erase(sent);
  }
}

bool Synchroniser::tells(const std::string& name, std::uint64_t id) const {
  const auto sent = sent_.find(name);
  return sent != sent_.end() && std::any_of(sent->second.begin(), sent->second.end(),
                                            [id](const auto& one) { return one.second.id == id; });
}

std::vector<std::string> Synchroniser::withdraw(TaskId task,
                                                const Synchronisation& synchronisation) {
  std::vector<std::string> told;
  for (const std::string& name : targets(synchronisation)) {
    const auto sent = sent_.find(name);
    if (sent != sent_.end() && sent->second.contains(task)) told.push_back(name);
  }
  forget(task, synchronisation);
  if (!validity_) return {};
  std::erase_if(told, [&](const auto& name) { return tells(name, synchronisation.id); });
  for (const std::string& name : told) withdrawn_[name].insert(synchronisation.id);
  return told;
}

}  // namespace skein::executive
