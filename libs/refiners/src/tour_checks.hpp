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

/// The refusal of what would use more than the vehicle holds above its reserve; `what` begins the
/// sentence.
std::optional<Refusal> check_energy(double energy, const world::VehicleModel& vehicle,
                                    const std::string& what);

/// "12.3"
std::string rounded(double figure);

}  // namespace skein::refiners
