// SPDX-License-Identifier: Apache-2.0
#include "palette.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace skein::cartography {
namespace {

using Stop = std::array<double, 4>;  // where, red, green, blue

template <std::size_t N>
Colour between(const std::array<Stop, N>& stops, double value, double light) {
  const double at = std::clamp(value, 0.0, 1.0);
  std::size_t i = 1;
  while (i + 1 < N && stops[i][0] < at) ++i;
  const Stop& low = stops[i - 1];
  const Stop& high = stops[i];
  const double part = std::clamp((at - low[0]) / (high[0] - low[0]), 0.0, 1.0);
  const auto channel = [&](std::size_t c) {
    const double mixed = (low[c] + (high[c] - low[c]) * part) * light;
    return static_cast<std::uint8_t>(std::lround(std::clamp(mixed, 0.0, 255.0)));
  };
  return {channel(1), channel(2), channel(3)};
}

}  // namespace

Colour ground_tint(double height, double light) {
  constexpr std::array<Stop, 5> stops = {{{0.0, 214, 224, 203},
                                          {0.35, 231, 230, 205},
                                          {0.65, 222, 205, 173},
                                          {0.85, 203, 184, 158},
                                          {1.0, 240, 236, 230}}};
  return between(stops, height, 0.55 + 0.64 * light);
}

Colour heat_tint(double value) {
  constexpr std::array<Stop, 5> stops = {{{0.0, 42, 24, 96},
                                          {0.25, 50, 88, 140},
                                          {0.5, 30, 145, 140},
                                          {0.75, 110, 200, 95},
                                          {1.0, 250, 230, 60}}};
  return between(stops, value, 1);
}

std::string line_colour(std::size_t index) {
  constexpr std::array<const char*, 8> colours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                  "#e69f00", "#56b4e9", "#7a5195", "#5a5a5a"};
  return colours[index % colours.size()];
}

std::string hex(Colour colour) {
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", colour.red, colour.green, colour.blue);
  return text.data();
}

}  // namespace skein::cartography
