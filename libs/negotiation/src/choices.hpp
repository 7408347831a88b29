// SPDX-License-Identifier: Apache-2.0
// Offers that state costs of some of several numbered choices.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skein/negotiation/terms.hpp"

namespace skein::interaction {

/// Why the offer is invalid; absent: each row has the name `name`, a choice from 0 to `choices` -
/// 1, each at most once, and a cost >= 0.
std::optional<std::string> problem_of_choices(const Rows& offer, const std::string& name,
                                              std::size_t choices);
/// The cost of each choice; absent: not offered. Precondition: problem_of_choices() is absent.
std::vector<std::optional<double>> costs_of_choices(const Rows& offer, std::size_t choices);

}  // namespace skein::interaction
