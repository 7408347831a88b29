// SPDX-License-Identifier: Apache-2.0
// What the radio of a scenario takes, delays and loses at the most.
#pragma once

#include <algorithm>
#include <cmath>

#include "skein/foundation/time.hpp"
#include "skein/scenario/narrowest.hpp"

namespace skein::laws {

/// Time on the narrowest link of an event, and as much again of what shares it; 0: all are
/// unlimited.
inline Duration airtime_of_an_event(const scenario::RadioSpec& radio) {
  constexpr double kEvent = 8.0 * 2 * 300;  // [bit] with its frame
  const auto least = scenario::narrowest(radio);
  return least ? Duration::seconds(kEvent / *least) : Duration();
}

/// Time on the narrowest link of three words on the air of ways, one after the other, and as much
/// again of what shares it [s]; 0: all are unlimited.
inline double airtime_of_words_on_air(const scenario::RadioSpec& radio) {
  constexpr double kWords = 3;
  constexpr double kWord = 8.0 * 2 * 450;  // [bit] with its frame
  const auto least = scenario::narrowest(radio);
  const double links = radio.relays.empty() ? 1 : 2;
  return least ? kWords * links * kWord / *least : 0;
}

/// So often may a healthy radio break a law.
constexpr double kHardlyEver = 1e-6;

/// The greatest share of what is not repeated that a link may lose, in [0, 1].
inline double greatest_loss(const scenario::Scenario& scenario) {
  double loss = scenario.radio.model.loss;
  for (const scenario::LinkSpec& link : scenario.radio.links)
    loss = std::max(loss, link.loss.value_or(0));
  return scenario.variations.loss ? std::max(loss, scenario.variations.loss->high) : loss;
}

/// The greatest latency of a link.
inline Duration greatest_latency(const scenario::Scenario& scenario) {
  Duration latency = scenario.radio.model.latency;
  for (const scenario::LinkSpec& link : scenario.radio.links)
    latency = std::max(latency, link.latency.value_or(Duration()));
  if (!scenario.variations.latency) return latency;
  return std::max(latency, Duration::seconds(scenario.variations.latency->high));
}

/// So many tries, each lost with this probability in [0, 1), that all are lost hardly ever.
inline double tries(double loss) { return loss > 0 ? std::log(kHardlyEver) / std::log(loss) : 0; }

}  // namespace skein::laws
