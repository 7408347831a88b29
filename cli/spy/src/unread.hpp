// SPDX-License-Identifier: Apache-2.0
// What is written and read by nobody.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "skein/blackboard/observer.hpp"

namespace skein::spy_tool {

/// A sample without a reader is not sent, so whoever looks at what passes cannot see it.
class Unread {
 public:
  void see(const blackboard::Sighting& sighting);
  /// Of which every writer that was there met no reader, by name.
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
