// SPDX-License-Identifier: Apache-2.0
// A way past those for whom a motion waits.
#pragma once

#include <cstdint>
#include <optional>

#include "merging/airways.hpp"
#include "skein/decision_node/messages.hpp"

namespace skein::decision_node {

class Core;

/// Has ways around the air of others searched in jobs, one at a time, since a search among many
/// volumes takes up to about a second. Source: spec 6.4;
/// docs/decisions/0106-ways-around-are-jobs.md.
class WayAround {
 public:
  explicit WayAround(Core& core) : core_(core) {}

  /// To where the motion leads, out of `taken`. No effect while a search runs, or if the motion is
  /// no flight.
  void search(const functional::Request& request, const merging::Volumes& taken,
              const AirwaySituation& situation);
  /// The motion that the search was for which is over now; nothing: it was none of this life.
  std::optional<functional::TaskId> over(const WaySearched& done);
  /// The motion along the path that was found for it. Nothing: the vehicle is elsewhere by now, the
  /// way is not free any more, or it takes more energy than is left besides that for the way home.
  std::optional<Airway> along(const refiners::Path& path, const functional::Request& request,
                              const merging::Volumes& taken,
                              const AirwaySituation& situation) const;

 private:
  Core& core_;
  std::uint64_t searches_ = 0;
  std::optional<functional::TaskId> for_;  ///< the motion, while a search runs
};

}  // namespace skein::decision_node
