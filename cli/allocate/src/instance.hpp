// SPDX-License-Identifier: Apache-2.0
// An allocation instance, read from a line.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "skein/auction/task.hpp"
#include "skein/auction_lab/flat_craft.hpp"
#include "skein/foundation/diagnostics.hpp"

namespace skein::allocate_tool {

struct Instance {
  auction::Lot lot;  ///< tasks by their numbers in the line
  std::vector<auction::FlatVehicle> vehicles;
  bool tours = false;  ///< of vehicles and tasks; else of robots with skills
};

/// Source: issue 17; the README of the allocation instances. Everything wrong with the line goes to
/// `problems`, with `file` and `line`.
std::optional<Instance> read_instance(std::string_view text, const std::string& file, int line,
                                      Diagnostics& problems);

}  // namespace skein::allocate_tool
