// SPDX-License-Identifier: Apache-2.0
// The number of a node's next incarnation.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "skein/foundation/result.hpp"

namespace skein::store {

/// Greater than each that it gave for this node in this folder before, whatever the clock says: the
/// others take a lower incarnation for an older one and do not hear it, and a board without a
/// battery boots into 1970. At least `clock` [ns since 1970], so that a node whose folder is lost
/// is heard too if its clock is right. It is on disk (NODE.incarnation) before it is given. The
/// failure says what cannot be read or written; a file that holds no number is one and stays as it
/// is. Thread rule: one process at a time for a node.
Result<std::uint64_t, Failure> next_incarnation(const std::filesystem::path& folder,
                                                const std::string& node, std::uint64_t clock);

}  // namespace skein::store
