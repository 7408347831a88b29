// SPDX-License-Identifier: Apache-2.0
// `skein allocate`: who does which tasks, by auction, from JSON lines.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>

namespace skein::allocate_tool {

struct AllocateOptions {
  std::string file;      ///< for messages; empty: standard input
  bool longest = false;  ///< of tours: makes the longest small instead of their sum
  std::uint64_t seed = 1;
};

/// Reads instances as JSON lines from `in`, sells the tasks of each in virtual time and writes one
/// line each on `out` (formats: docs/allocation.md). 0: everything is sold; 1: of some instance
/// something is not, and its line says why; 2: something is wrong with the input, all of it said on
/// `err`, and nothing was sold.
int allocate(const AllocateOptions& options, std::istream& in, std::ostream& out,
             std::ostream& err);

}  // namespace skein::allocate_tool
