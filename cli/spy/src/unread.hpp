// SPDX-License-Identifier: Apache-2.0
// Topics with writers but without readers.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "skein/blackboard/observer.hpp"

namespace skein::spy_tool {

/// Finds topics without readers, whose samples are not sent and so cannot be seen in the traffic.
class Unread {
 public:
  void see(const blackboard::Sighting& sighting);
  /// Topics of which no writer ever had a matching reader, by name.
  std::vector<std::string> topics() const;

 private:
  struct Place {
    std::string topic;
    std::vector<std::string> partitions;
    auto operator<=>(const Place&) const = default;
  };
  std::set<Place> writers_, readers_;
};

}  // namespace skein::spy_tool
