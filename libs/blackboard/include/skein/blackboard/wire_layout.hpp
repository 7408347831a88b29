// SPDX-License-Identifier: Apache-2.0
// The layout of all samples, as one text: two programs with the same text read each other's bytes.
#pragma once

#include <string>

namespace skein::wire {

/// Slots in their order, fields in the order of their IDL definitions, names of enumerators:
/// "Clock {header {origin u32; …} time i64; …}", a line a slot.
std::string layout();

/// Sixteen hexadecimal digits that differ when the layout does.
const std::string& layout_mark();

}  // namespace skein::wire
