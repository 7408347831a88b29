// SPDX-License-Identifier: Apache-2.0
// Whether what joint tasks are to follow was followed, by truth, for as long as asked.
#pragma once

#include <string>

#include "skein/interaction/model.hpp"
#include "skein/laws/history.hpp"

namespace skein::laws {

/// What is wrong with how the members of an achieved joint task followed its targets: none of them
/// for as long as asked, or one for longer. Empty: nothing, or it is not asked for a time.
/// `reaction`: how much of the time may be missing since targets moved, were told, agreed on [s].
std::string not_followed(const History& history, const std::string& joint,
                         const interaction::Variant& variant, double reaction);

}  // namespace skein::laws
