// SPDX-License-Identifier: Apache-2.0
#include "svg_text.hpp"
#include "skein/foundation/markup.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace skein::cartography {

std::string px(double value) {
  std::string out = fmt::format("{:.1f}", value);
  return out == "-0.0" ? "0.0" : out;
}

std::string points(const std::vector<Spot>& spots) {
  std::string out;
  for (const Spot& spot : spots) out += (out.empty() ? "" : " ") + px(spot.x) + "," + px(spot.y);
  return out;
}

std::string text(const Spot& at, std::string_view words, const TextStyle& style) {
  return fmt::format(
      R"(<text x="{}" y="{}" font-size="{}" text-anchor="{}" fill="{}"{}{}>{}</text>)"
      "\n",
      px(at.x), px(at.y), px(style.size), style.anchor, style.colour,
      style.bold ? R"( font-weight="bold")" : "",
      style.halo
          ? R"( stroke="#ffffff" stroke-width="3" stroke-linejoin="round" paint-order="stroke")"
          : "",
      escaped_markup(words));
}

double width_of(std::string_view words, double size) {
  const auto characters = std::count_if(words.begin(), words.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  });
  return 0.6 * size * static_cast<double>(characters);
}

}  // namespace skein::cartography
