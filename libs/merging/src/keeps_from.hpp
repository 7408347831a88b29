// SPDX-License-Identifier: Apache-2.0
// Whether what one holds is in the way of what another wants.
#pragma once

#include "skein/merging/volume.hpp"

namespace skein::merging {

/// What one holds keeps another, which holds `own`, from what it wants. Air in which both are
/// already, since one of them flew there unasked, keeps nobody from leaving at the height where it
/// is, by a way that comes no nearer to the middle of that air than where it begins. Cost:
/// O(product).
bool keeps_from(const Volumes& held, const Volumes& wanted, const Volumes& own);

}  // namespace skein::merging
