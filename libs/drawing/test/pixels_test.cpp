// SPDX-License-Identifier: Apache-2.0
#include "skein/drawing/pixels.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <cstring>

namespace skein::drawing {
namespace {

std::vector<std::uint8_t> bytes(const std::string& text) { return {text.begin(), text.end()}; }

TEST(Base64, IsThatOfTheStandard) {  // RFC 4648, section 10
  EXPECT_EQ(base64(bytes("")), "");
  EXPECT_EQ(base64(bytes("f")), "Zg==");
  EXPECT_EQ(base64(bytes("fo")), "Zm8=");
  EXPECT_EQ(base64(bytes("foo")), "Zm9v");
  EXPECT_EQ(base64(bytes("foob")), "Zm9vYg==");
  EXPECT_EQ(base64(bytes("fooba")), "Zm9vYmE=");
  EXPECT_EQ(base64(bytes("foobar")), "Zm9vYmFy");
}

TEST(Base64, HoldsBytesOfEveryValue) { EXPECT_EQ(base64({0xff, 0xfe, 0x00, 0x80}), "//4AgA=="); }

std::vector<std::uint8_t> from_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::uint8_t> out;
  std::uint32_t bits = 0;
  int held = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6U | static_cast<std::uint32_t>(digits.find(c));
    held += 6;
    if (held < 8) continue;
    held -= 8;
    out.push_back(static_cast<std::uint8_t>(bits >> static_cast<unsigned>(held) & 0xffU));
  }
  return out;
}

TEST(Pixels, ComeBackFromTheImageAsTheyWereSet) {
  Pixels pixels(3, 2);
  pixels.set(0, 0, {255, 0, 0, 255});
  pixels.set(2, 1, {1, 2, 3, 128});

  const std::string uri = png_uri(pixels);
  const std::string head = "data:image/png;base64,";
  ASSERT_EQ(uri.compare(0, head.size(), head), 0);
  const std::vector<std::uint8_t> png = from_base64(uri.substr(head.size()));
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_memory(&image, png.data(), png.size()), 0);
  image.format = PNG_FORMAT_RGBA;
  std::vector<std::uint8_t> read(PNG_IMAGE_SIZE(image));
  ASSERT_NE(png_image_finish_read(&image, nullptr, read.data(), 0, nullptr), 0);

  EXPECT_EQ(image.width, 3U);
  EXPECT_EQ(image.height, 2U);
  EXPECT_EQ(read, pixels.bytes());
}

}  // namespace
}  // namespace skein::drawing
