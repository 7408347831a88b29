// SPDX-License-Identifier: Apache-2.0
// Dates in the network of a plan: what it allows, and what will come of earliest starts.
#pragma once

#include <optional>
#include <vector>

#include "rebuilt_network.hpp"

namespace skein::supervisor {

/// By node; `latest` may be temporal::kInfinite.
struct NodeDates {
  std::vector<temporal::Ticks> earliest, latest;
};

/// What follows from contingent links whatever nature does, by another way than that of the
/// library: from the dispatchable form. Empty unless controllable.
std::vector<temporal::Arc> implied_by(const temporal::Stnu& network);

/// With durations of one's choice. Absent: inconsistent.
std::optional<NodeDates> dates_by_choice(const RebuiltNetwork& plan);

/// Earliest with all durations least, latest with all greatest. Absent when one of the two is
/// inconsistent; a controllable network never is.
std::optional<NodeDates> dates_in_every_course(const RebuiltNetwork& plan);

/// What comes of starting each task as early as it may be, with all durations least and greatest.
/// Tasks with a start_after or end_after are held back to their date in `allowed`, as the executive
/// does, if given. Bounds from above play no part. Absent: tasks wait for each other in a ring.
std::optional<NodeDates> foresee(const RebuiltNetwork& plan, const NodeDates* allowed);

}  // namespace skein::supervisor
