// SPDX-License-Identifier: Apache-2.0
#include "skein/drawing/pixels.hpp"

#include <png.h>

#include <string_view>

#include "skein/foundation/contract.hpp"

namespace skein::drawing {

Colour Pixels::at(std::size_t x, std::size_t y) const {
  SKEIN_EXPECTS(x < width_ && y < height());
  const std::size_t at = (y * width_ + x) * 4;
  return {bytes_[at], bytes_[at + 1], bytes_[at + 2], bytes_[at + 3]};
}

void Pixels::set(std::size_t x, std::size_t y, Colour colour) {
  SKEIN_EXPECTS(x < width_ && y < height());
  const std::size_t at = (y * width_ + x) * 4;
  bytes_[at] = colour.red;
  bytes_[at + 1] = colour.green;
  bytes_[at + 2] = colour.blue;
  bytes_[at + 3] = colour.alpha;
}

std::string base64(const std::vector<std::uint8_t>& bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = bytes.size() - i;
    const std::uint32_t three = static_cast<std::uint32_t>(bytes[i]) << 16U |
                                (left > 1 ? static_cast<std::uint32_t>(bytes[i + 1]) << 8U : 0U) |
                                (left > 2 ? static_cast<std::uint32_t>(bytes[i + 2]) : 0U);
    text += digits[three >> 18U & 63U];
    text += digits[three >> 12U & 63U];
    text += left > 1 ? digits[three >> 6U & 63U] : '=';
    text += left > 2 ? digits[three & 63U] : '=';
  }
  return text;
}

std::string png_uri(const Pixels& pixels) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(pixels.width());
  image.height = static_cast<png_uint_32>(pixels.height());
  image.format = PNG_FORMAT_RGBA;
  png_alloc_size_t size = 0;
  const auto write = [&](void* to) {
    return png_image_write_to_memory(&image, to, &size, 0, pixels.bytes().data(), 0, nullptr);
  };
  SKEIN_ENSURES(write(nullptr) != 0);
  std::vector<std::uint8_t> png(size);
  SKEIN_ENSURES(write(png.data()) != 0);
  png.resize(size);
  return "data:image/png;base64," + base64(png);
}

}  // namespace skein::drawing
