// SPDX-License-Identifier: Apache-2.0
// Routes of samples: over one link, or past relays.
#pragma once

#include <cstddef>
#include <functional>
#include <set>
#include <string>

namespace skein::laws {

/// Whether the link from one node to another carries samples.
using Carries = std::function<bool(const std::string& from, const std::string& to)>;

/// Whether there is a route of at most `links` links that carry, with only relays between the ends.
inline bool has_way(const std::string& from, const std::string& to,
                    const std::set<std::string>& relays, std::size_t links,
                    const Carries& carries) {
  std::set<std::string> ends{from}, met{from};
  for (; links > 0 && !ends.empty(); --links) {
    std::set<std::string> next;
    for (const std::string& end : ends) {
      if (carries(end, to)) return true;
      for (const std::string& relay : relays)
        if (!met.contains(relay) && carries(end, relay)) next.insert(relay);
    }
    met.insert(next.begin(), next.end());
    ends = std::move(next);
  }
  return false;
}

}  // namespace skein::laws
