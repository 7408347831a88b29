// SPDX-License-Identifier: Apache-2.0
// Raster images inside SVG and HTML.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace skein::drawing {

struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0, alpha = 255;
  bool operator==(const Colour&) const = default;
};

/// Rows from the top, as images have them.
class Pixels {
 public:
  Pixels(std::size_t width, std::size_t height) : width_(width), bytes_(width * height * 4) {}

  std::size_t width() const { return width_; }
  std::size_t height() const { return bytes_.size() / 4 / width_; }
  /// Precondition of both: inside.
  void set(std::size_t x, std::size_t y, Colour colour);
  Colour at(std::size_t x, std::size_t y) const;
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  std::size_t width_;
  std::vector<std::uint8_t> bytes_;  // red, green, blue, alpha
};

/// "data:image/png;base64,…", for the href of an <image>. Precondition: not empty.
std::string png_uri(const Pixels& pixels);

/// Source: RFC 4648.
std::string base64(const std::vector<std::uint8_t>& bytes);

}  // namespace skein::drawing
