// SPDX-License-Identifier: Apache-2.0
#include "png.hpp"

#include <algorithm>

#include "skein/foundation/contract.hpp"

namespace skein::report {

namespace {

constexpr std::size_t kLargestStoredBlock = 65535;

constexpr std::array<std::uint32_t, 256> make_crc_table() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t n = 0; n < 256; ++n) {
    std::uint32_t c = n;
    for (int k = 0; k < 8; ++k) c = (c & 1U) != 0 ? 0xEDB88320U ^ (c >> 1U) : c >> 1U;
    table[n] = c;
  }
  return table;
}

constexpr std::array<std::uint32_t, 256> kCrcTable = make_crc_table();

char to_char(std::uint32_t byte) { return static_cast<char>(static_cast<unsigned char>(byte)); }

std::string big_endian(std::uint32_t value) {
  return {to_char(value >> 24U), to_char(value >> 16U & 0xFFU), to_char(value >> 8U & 0xFFU),
          to_char(value & 0xFFU)};
}

std::string chunk(std::string_view type, std::string_view data) {
  const std::string body = std::string(type) + std::string(data);
  return big_endian(static_cast<std::uint32_t>(data.size())) + body + big_endian(crc32(body));
}

std::string zlib_stored(std::string_view data) {
  std::string out = "\x78\x01";
  for (std::size_t i = 0; i < data.size(); i += kLargestStoredBlock) {
    const std::string_view block = data.substr(i, kLargestStoredBlock);
    const auto size = static_cast<std::uint32_t>(block.size());
    out += i + block.size() == data.size() ? '\x01' : '\x00';
    for (const std::uint32_t word : {size, ~size & 0xFFFFU}) {
      out += to_char(word & 0xFFU);
      out += to_char(word >> 8U);
    }
    out += block;
  }
  return out + big_endian(adler32(data));
}

}  // namespace

std::uint32_t crc32(std::string_view bytes) {
  std::uint32_t c = 0xFFFFFFFFU;
  for (const char byte : bytes) {
    c = kCrcTable[(c ^ static_cast<unsigned char>(byte)) & 0xFFU] ^ (c >> 8U);
  }
  return ~c;
}

std::uint32_t adler32(std::string_view bytes) {
  std::uint32_t a = 1, b = 0;
  for (const char byte : bytes) {
    a = (a + static_cast<unsigned char>(byte)) % 65521U;
    b = (b + a) % 65521U;
  }
  return b << 16U | a;
}

std::string encode_png(const PaletteImage& image) {
  SKEIN_EXPECTS(image.width > 0 && image.height > 0);
  SKEIN_EXPECTS(image.pixels.size() == image.width * image.height);
  SKEIN_EXPECTS(!image.palette.empty() && image.palette.size() <= 256);
  const std::string header = big_endian(static_cast<std::uint32_t>(image.width)) +
                             big_endian(static_cast<std::uint32_t>(image.height)) +
                             std::string("\x08\x03\x00\x00\x00", 5);
  std::string palette;
  for (const Colour& c : image.palette) {
    palette += {to_char(c.red), to_char(c.green), to_char(c.blue)};
  }
  std::string rows;
  rows.reserve((image.width + 1) * image.height);
  for (std::size_t y = 0; y < image.height; ++y) {
    rows += '\0';  // no filter
    const std::uint8_t* row = image.pixels.data() + y * image.width;
    std::transform(row, row + image.width, std::back_inserter(rows),
                   [](std::uint8_t p) { return to_char(p); });
  }
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("PLTE", palette) +
         chunk("IDAT", zlib_stored(rows)) + chunk("IEND", "");
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      out += i + k <= bytes.size() ? kDigits[group >> (18U - 6U * k) & 0x3FU] : '=';
    }
  }
  return out;
}

}  // namespace skein::report
