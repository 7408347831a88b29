// SPDX-License-Identifier: Apache-2.0
// The number of a node's next incarnation.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "skein/foundation/result.hpp"

namespace skein::store {

struct Incarnation {
  std::uint64_t number = 0;
  bool first = false;  ///< the folder knew of none before
};

/// Returns an incarnation whose number is greater than all that this function has returned for this
/// node and folder, whatever the clock says: peers ignore a lower incarnation as an older one, and
/// the clock of a board without a battery starts in 1970. At least `clock` [ns since 1970], so that
/// peers accept the node even if its folder is lost, provided that its clock is right. The number
/// is on disk (NODE.incarnation) before it is returned. The failure says what cannot be read or
/// written; a file without a number in it is a failure, and is not changed. Thread rule: one
/// process at a time for a node.
Result<Incarnation, Failure> next_incarnation(const std::filesystem::path& folder,
                                              const std::string& node, std::uint64_t clock);

}  // namespace skein::store
