// SPDX-License-Identifier: Apache-2.0
// The ids of the ways by which operators steer UAVs.
#pragma once

#include "skein/functional/task.hpp"

namespace skein::functional {

/// From here on, up to kFirstPlayedId: ways by which an operator steers a UAV. It goes on with them
/// on board when it is given back, so that they are none of the ids that decision nodes refuse; and
/// numbers its own tasks as if there were none, so that the next one finds its id free.
inline constexpr TaskId kFirstSteeringId{390'000'000};

inline bool is_of_steering(TaskId id) { return id >= kFirstSteeringId && id < kFirstPlayedId; }

}  // namespace skein::functional
