// SPDX-License-Identifier: Apache-2.0
#include "skein/blackboard/handshakes.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <set>

namespace skein::blackboard {

class Handshakes::Impl {
 public:
  struct Begun {
    std::string name;
    Duration at;
  };
  std::mutex mutex;
  std::map<std::string, Begun> begun;  ///< by GUID
  std::set<std::string> ended;
};

Handshakes::Handshakes() : impl_(std::make_unique<Impl>()) {}
Handshakes::~Handshakes() = default;

void Handshakes::begun(const std::string& guid, const std::string& name, Duration steady) {
  const std::lock_guard lock(impl_->mutex);
  if (!impl_->ended.contains(guid)) impl_->begun.try_emplace(guid, Impl::Begun{name, steady});
}

void Handshakes::ended(const std::string& guid) {
  const std::lock_guard lock(impl_->mutex);
  impl_->begun.erase(guid);
  impl_->ended.insert(guid);
}

void Handshakes::gone(const std::string& guid) {
  const std::lock_guard lock(impl_->mutex);
  impl_->begun.erase(guid);
  impl_->ended.erase(guid);
}

std::vector<Handshakes::Open> Handshakes::open(Duration steady) const {
  std::vector<Open> open;
  const std::lock_guard lock(impl_->mutex);
  for (const auto& [guid, one] : impl_->begun) open.push_back({one.name, steady - one.at});
  std::stable_sort(open.begin(), open.end(),
                   [](const Open& a, const Open& b) { return a.lasts > b.lasts; });
  return open;
}

}  // namespace skein::blackboard
