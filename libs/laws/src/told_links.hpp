// SPDX-License-Identifier: Apache-2.0
// The links of the radio as `link` lines tell them.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "skein/foundation/time.hpp"

namespace skein::laws {

/// As both ends of a `link` line: all links that no other line is about.
inline constexpr const char* kEveryLink = "*";

/// When each link was up. A link that nothing was told of is up; of any other the first line says
/// how it began.
class ToldLinks {
 public:
  void tell(const std::string& from, const std::string& to, bool up, MissionTime at) {
    told_ = true;
    if (from == kEveryLink) {
      others_are_up_ = up;
    } else {
      changes_[{from, to}].push_back({at, up});
    }
  }

  bool are_told() const { return told_; }

  /// At some instant from `since` to `until`.
  bool were_up(const std::string& from, const std::string& to, MissionTime since,
               MissionTime until) const {
    const auto found = changes_.find({from, to});
    if (found == changes_.end()) return others_are_up_;
    const std::vector<Change>& changes = found->second;
    bool up = false;
    for (const Change& change : changes) {
      if (change.at > until) break;
      up = change.at <= since ? change.up : up || change.up;
    }
    return up;
  }

 private:
  struct Change {
    MissionTime at;
    bool up = false;
  };
  std::map<std::pair<std::string, std::string>, std::vector<Change>> changes_;
  bool others_are_up_ = true;
  bool told_ = false;
};

}  // namespace skein::laws
