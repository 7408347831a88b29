// SPDX-License-Identifier: Apache-2.0
// Raster images inside an SVG.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace skein::cartography {

struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0, alpha = 255;
  bool operator==(const Colour&) const = default;
};

/// Rows from north to south, as images have them.
class Pixels {
 public:
  Pixels(std::size_t width, std::size_t height) : width_(width), bytes_(width * height * 4) {}

  std::size_t width() const { return width_; }
  std::size_t height() const { return bytes_.size() / 4 / width_; }
  void set(std::size_t x, std::size_t y, Colour colour);
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  std::size_t width_;
  std::vector<std::uint8_t> bytes_;  // red, green, blue, alpha
};

/// "data:image/png;base64,…", for the href of an <image>.
std::string png_uri(const Pixels& pixels);

std::string base64(const std::vector<std::uint8_t>& bytes);

}  // namespace skein::cartography
