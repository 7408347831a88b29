// SPDX-License-Identifier: Apache-2.0
// Folding: compression of many rows of a state file, all but the last ones, into one.
#pragma once

#include <cstdint>
#include <vector>

#include "row.hpp"

namespace skein::store {

/// Compresses unpacked rows into one self-contained Zstandard frame with a checksum, column by
/// column: instants as second differences, numbers as differences within a kind, bodies of the same
/// kind, peer and slot next to each other. Source: RFC 8878.
std::vector<std::uint8_t> fold(const std::vector<Row>& rows);
/// Inverse of fold(). Throws std::runtime_error if the bytes are not a result of fold().
std::vector<Row> unfold(const std::vector<std::uint8_t>& folded);

}  // namespace skein::store
