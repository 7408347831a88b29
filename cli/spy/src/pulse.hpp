// SPDX-License-Identifier: Apache-2.0
// Rate, size and delay of the samples of one flow.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "skein/foundation/time.hpp"

namespace skein::spy_tool {

/// Statistics over the window.
struct Spread {
  double mean = 0, least = 0, greatest = 0, deviation = 0;
  double late = 0;  ///< 99th percentile
};

/// Statistics of the last `window` samples. A value type without a clock.
class Pulse {
 public:
  explicit Pulse(std::size_t window) : window_(window) {}

  /// Adds a sample. `delay`: from writing to arrival [s], by the clocks of two machines.
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
