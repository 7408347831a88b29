// SPDX-License-Identifier: Apache-2.0
// Seeds of a series, as options give them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace skein::workers {

/// "3..17" or "3"; nothing for what is no range.
std::optional<std::pair<std::uint64_t, std::uint64_t>> seeds_of(const std::string& text);

}  // namespace skein::workers
