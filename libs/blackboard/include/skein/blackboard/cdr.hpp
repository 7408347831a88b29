// SPDX-License-Identifier: Apache-2.0
// The bytes of a sample on the wire.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "skein/blackboard/transport.hpp"
#include "skein/blackboard/wire.hpp"

namespace skein::blackboard {

/// Bytes that encode() will write, encapsulation header included.
std::size_t encoded_size(const wire::Sample& sample);

/// Writes the sample as OMG CDR version 1, little-endian, behind its 4-byte encapsulation header:
/// what any DDS implementation makes of the IDL type. `out` must hold encoded_size(); gives the
/// bytes used.
std::size_t encode(const wire::Sample& sample, std::span<std::uint8_t> out);

/// The same in a buffer of its own.
std::vector<std::uint8_t> in_cdr(const wire::Sample& sample);

/// Reads what a peer wrote, of either byte order. Never reads past `bytes`, never allocates more
/// than a small multiple of them, and says which field is wrong. What it gives may still break the
/// rules that wire::find_violation checks.
std::variant<wire::Sample, Malformed> decode(wire::Slot slot, std::span<const std::uint8_t> bytes);

}  // namespace skein::blackboard
