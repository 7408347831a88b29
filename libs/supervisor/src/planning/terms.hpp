// SPDX-License-Identifier: Apache-2.0
// Conversions between values of the host and terms of the planner. Locations: (loc X Y Z) [m].
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "skein/htn/term_store.hpp"
#include "skein/world/geometry.hpp"

namespace skein::supervisor {

/// The text of a symbol, a string or a number; empty for lists.
std::string text_of(const htn::TermStore& store, htn::Term term);
std::optional<double> number_of(const htn::TermStore& store, htn::Term term);
std::optional<world::Vector3> location_of(const htn::TermStore& store, htn::Term term);
/// ((num LEAST) (num MOST)), [s]; `unlimited` is infinite.
struct Seconds {
  double least = 0, most = 0;
};
std::optional<Seconds> seconds_of(const htn::TermStore& store, htn::Term term);
/// The elements of a list that are locations.
std::vector<world::Vector3> locations_of(const htn::TermStore& store, htn::Term list);
/// x for the quoted term 'x; other terms unchanged.
htn::Term unquoted(const htn::TermStore& store, htn::Term term);

htn::Term number_term(htn::TermStore& store, double value);
htn::Term location_term(htn::TermStore& store, const world::Vector3& at);
/// (HEAD item…).
htn::Term headed(htn::TermStore& store, std::string_view head, std::vector<htn::Term> items);

/// Equality regardless of case, as symbols of the planner are equal.
bool same_name(std::string_view a, std::string_view b);
/// ((target LOC)).
htn::Term target_term(htn::TermStore& store, const world::Vector3& at);

}  // namespace skein::supervisor
