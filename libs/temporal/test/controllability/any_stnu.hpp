// SPDX-License-Identifier: Apache-2.0
// Networks with uncertainty and numbers for RapidCheck properties, full size from the first case.
#pragma once

#include <rapidcheck/gtest.h>

#include "random_stnu.hpp"

namespace skein::temporal::testing {

/// Any of low .. end - 1.
template <class T>
T between(T low, T end) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<T>(low, end));
}

inline Stnu any_network() {
  Random random(between<std::uint64_t>(0, 1'000'000'000));
  RandomStnuOptions options;
  options.nodes = between(4U, 10U);
  options.contingent = between(1U, 5U);
  options.arcs = between(4U, 18U);
  return random_stnu(options, random);
}

inline std::uint32_t any_arc(const Stnu& network) {
  return between<std::uint32_t>(0, static_cast<std::uint32_t>(network.arcs.size()));
}

}  // namespace skein::temporal::testing
