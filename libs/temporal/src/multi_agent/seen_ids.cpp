// SPDX-License-Identifier: Apache-2.0
// Ids as disjoint intervals.
#include "skein/temporal/seen_ids.hpp"

#include <algorithm>
#include <iterator>

namespace skein::temporal {

bool SeenIds::contains(std::uint64_t id) const {
  const auto after = intervals_.upper_bound(id);
  return after != intervals_.begin() && std::prev(after)->second >= id;
}

void SeenIds::insert(std::uint64_t id) {
  if (contains(id)) return;
  auto place = intervals_.emplace(id, id).first;
  if (place != intervals_.begin() && std::prev(place)->second + 1 == id) {
    const auto before = std::prev(place);
    before->second = id;
    intervals_.erase(place);
    place = before;
  }
  const auto after = std::next(place);
  if (after != intervals_.end() && after->first == id + 1) {
    place->second = after->second;
    intervals_.erase(after);
  }
}

}  // namespace skein::temporal
