// SPDX-License-Identifier: Apache-2.0
// From a query to its answer.
#pragma once

#include <variant>

#include "query.hpp"

namespace skein::refine_tool {

using Solution =
    std::variant<refiners::Refined<refiners::Path>, refiners::Refined<refiners::Tour>,
                 refiners::Refined<refiners::Coverage>, refiners::Refined<refiners::Partition>,
                 refiners::Refined<refiners::Patrol>, refiners::Refined<refiners::Viewpoints>,
                 refiners::Refined<refiners::Viewshed>, refiners::Refined<refiners::Relay>,
                 refiners::Refined<refiners::Evaluation>, refiners::Refined<refiners::Insertion>>;

using Answer = Result<Solution, refiners::Refusal>;

/// Runs the service. `time_is_up` may be empty. Adds the gates of areas to the query, so that it
/// afterwards has the complete question.
Answer answer(Query& query, std::function<bool()> time_is_up);

}  // namespace skein::refine_tool
