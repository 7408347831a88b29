// SPDX-License-Identifier: Apache-2.0
// A palette image as a PNG data URI, written without a compression library.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace skein::report {

struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
};

/// At most 256 colours and one byte a pixel, rows from the top.
struct PaletteImage {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<Colour> palette;
  std::vector<std::uint8_t> pixels;  ///< width × height indices into the palette
};

/// The bytes of a PNG file whose zlib stream has only stored blocks: as large as the pixels.
/// Precondition: the sizes agree, neither is 0, the palette has 1 to 256 colours.
/// Source: PNG specification (ISO/IEC 15948), RFC 1950, RFC 1951.
std::string encode_png(const PaletteImage& image);

std::string base64(std::string_view bytes);

std::uint32_t crc32(std::string_view bytes);
std::uint32_t adler32(std::string_view bytes);

}  // namespace skein::report
