// SPDX-License-Identifier: Apache-2.0
// The UAVs beside a decision node's own.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "skein/foundation/shared_list.hpp"

namespace skein::decision_node {

/// All UAVs of a system but one. Copies share the names, and so may all nodes of a process: those
/// of a large team would else hold as many names as there are pairs.
class OtherUavs {
 public:
  OtherUavs() = default;
  OtherUavs(std::initializer_list<std::string> others) : uavs_(others) {}
  /// `uavs`: of the whole system; `self` is left out.
  OtherUavs(SharedList<std::string> uavs, std::string self)
      : uavs_(std::move(uavs)), self_(std::move(self)) {}

  bool contains(std::string_view uav) const {
    return uav != self_ && std::find(uavs_.begin(), uavs_.end(), uav) != uavs_.end();
  }
  /// In the order of the system. Cost: a copy of all names.
  std::vector<std::string> names() const {
    std::vector<std::string> others = uavs_.values();
    std::erase(others, self_);
    return others;
  }

 private:
  SharedList<std::string> uavs_;
  std::string self_;
};

}  // namespace skein::decision_node
