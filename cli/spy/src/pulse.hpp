// SPDX-License-Identifier: Apache-2.0
// How often, how large and how late the samples of one flow are.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "skein/foundation/time.hpp"

namespace skein::spy_tool {

/// What is looked back on, and its spread.
struct Spread {
  double mean = 0, least = 0, greatest = 0, deviation = 0;
  double late = 0;  ///< 99 of 100 are at most so large
};

/// The last `window` samples. Only values, no clock.
class Pulse {
 public:
  explicit Pulse(std::size_t window) : window_(window) {}

  /// `delay`: from its writing to its coming [s], by the clocks of two machines.
  void beat(Duration at, std::size_t bytes, double delay);
  std::size_t samples() const { return beats_.size(); }
  /// [s] between samples; nothing before the second one.
  std::optional<Spread> intervals() const;
  std::optional<Spread> sizes() const;   ///< [byte]
  std::optional<Spread> delays() const;  ///< [s]
  /// Between the first and the last [s].
  double span() const;
  /// Of all but the first, over the span [byte/s]; 0 before the second one.
  double bytes_per_second() const;

 private:
  struct Beat {
    Duration at;
    std::size_t bytes;
    double delay;
  };
  std::size_t window_;
  std::deque<Beat> beats_;
};

}  // namespace skein::spy_tool
