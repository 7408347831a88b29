// SPDX-License-Identifier: Apache-2.0
// Compression of chunks.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "skein/mcap/format.hpp"

namespace skein::mcap {

/// As files have it: "", "lz4", "zstd".
std::string_view name_of(Compression compression);
std::optional<Compression> compression_named(std::string_view name);

std::string compressed(Compression compression, std::string_view bytes);

/// Nothing if it is not exactly `size` bytes that come out, or the bytes are damaged. No more than
/// `size` bytes of memory are taken for them.
std::optional<std::string> uncompressed(Compression compression, std::string_view bytes,
                                        std::size_t size);

}  // namespace skein::mcap
