// SPDX-License-Identifier: Apache-2.0
// What may be wrong with the queries of tour, insertion and evaluate; private.
#pragma once

#include <optional>

#include "skein/refiners/evaluate.hpp"
#include "skein/refiners/tour.hpp"

namespace skein::refiners {

std::optional<Refusal> check(const TourQuery& query);
std::optional<Refusal> check(const InsertionQuery& query);
std::optional<Refusal> check(const EvaluateQuery& query);

}  // namespace skein::refiners
