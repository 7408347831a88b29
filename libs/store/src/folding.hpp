// SPDX-License-Identifier: Apache-2.0
// Many rows as one: what a state file holds of inputs that are not the last ones.
#pragma once

#include <cstdint>
#include <vector>

#include "row.hpp"

namespace skein::store {

/// Rows, unpacked, as one Zstandard frame with a checksum, written by columns: instants as changes
/// of their steps, numbers as changes within a kind, bodies of one kind, peer and slot after each
/// other. What is in it needs nothing outside it. Source: RFC 8878.
std::vector<std::uint8_t> fold(const std::vector<Row>& rows);
/// Throws std::runtime_error at what fold() did not make.
std::vector<Row> unfold(const std::vector<std::uint8_t>& folded);

}  // namespace skein::store
