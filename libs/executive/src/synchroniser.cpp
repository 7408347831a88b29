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

bool Synchroniser::begin(TaskId task, const Synchronisation& synchronisation) {
  for (const std::string& name : targets(synchronisation)) {
    sent_[name].emplace(task, synchronisation.id);
  }
  if (!contains(synchronisation.receivers, own_)) return true;
  std::set<std::string> missing(synchronisation.senders.begin(), synchronisation.senders.end());
  missing.erase(own_);
  if (const auto kept = received_.find(synchronisation.id); kept != received_.end()) {
    for (const std::string& name : kept->second) missing.erase(name);
  }
  if (missing.empty()) return true;
  waiting_[synchronisation.id].emplace(task, std::move(missing));
  return false;
}

std::vector<TaskId> Synchroniser::received(std::uint64_t id, const std::string& from) {
  std::vector<TaskId> complete;
  if (!received_[id].insert(from).second) return complete;
  const auto waiting = waiting_.find(id);
  if (waiting == waiting_.end()) return complete;
  for (auto& [task, missing] : waiting->second) {
    if (missing.erase(from) > 0 && missing.empty()) complete.push_back(task);
  }
  return complete;
}

std::vector<std::uint64_t> Synchroniser::missed_by(const std::string& name) const {
  std::vector<std::uint64_t> ids;
  const auto sent = sent_.find(name);
  if (sent == sent_.end()) return ids;
  std::set<std::uint64_t> met;
  for (const auto& [task, id] : sent->second) {
    if (met.insert(id).second) ids.push_back(id);
  }
  return ids;
}

void Synchroniser::finish(TaskId task, const Synchronisation& synchronisation) {
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

}  // namespace skein::executive
