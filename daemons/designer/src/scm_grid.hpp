// SPDX-License-Identifier: Apache-2.0
// The region in which a spatial constraint model holds, as a raster for a picture.
#pragma once

#include <string>
#include <vector>

#include "json.hpp"
#include "skein/interaction/read_library.hpp"

namespace skein::designer {

/// Of `asked`: `scm`, its name; `places`, for each of its places a list of positions [m, ENU];
/// `numbers`; and a grid: `west`, `south`, `step` [m], `columns`, `rows` (to kMostCells in all),
/// `altitude` [m]. A text for each row from the south, with 1 where it holds, by the code that
/// watches it in flight.
inline constexpr std::size_t kMostCells = 40'000;
Result<std::vector<std::string>, Failure> scm_grid(const Json& asked,
                                                   const std::vector<std::string>& files,
                                                   const interaction::ReadFile& read);

}  // namespace skein::designer
