// SPDX-License-Identifier: Apache-2.0
#include "png.hpp"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

namespace skein::report {
namespace {

std::uint32_t big_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

struct Chunk {
  std::string type;
  std::string data;
};

// An independent reader: checks signature, lengths and CRCs on the way.
std::vector<Chunk> chunks_of(const std::string& png) {
  std::vector<Chunk> chunks;
  EXPECT_EQ(png.substr(0, 8), std::string("\x89PNG\r\n\x1a\n"));
  for (std::size_t i = 8; i < png.size();) {
    const std::uint32_t length = big_endian(png, i);
    const std::string body = png.substr(i + 4, 4 + length);
    EXPECT_EQ(big_endian(png, i + 8 + length), crc32(body));
    chunks.push_back({body.substr(0, 4), body.substr(4)});
    i += 12 + length;
  }
  return chunks;
}

std::string inflate_stored(const std::string& zlib) {
  std::string data;
  std::size_t i = 2;
  for (bool last = false; !last;) {
    last = zlib[i] == 1;
    const auto low = static_cast<unsigned char>(zlib[i + 1]);
    const auto high = static_cast<unsigned char>(zlib[i + 2]);
    const std::size_t size = low + 256U * high;
    data += zlib.substr(i + 5, size);
    i += 5 + size;
  }
  EXPECT_EQ(big_endian(zlib, i), adler32(data));
  EXPECT_EQ(zlib.size(), i + 4);
  return data;
}

TEST(Checksums, AgreeWithThePublishedExamples) {
  EXPECT_EQ(crc32("123456789"), 0xCBF43926U);
  EXPECT_EQ(adler32("Wikipedia"), 0x11E60398U);
  EXPECT_EQ(crc32(""), 0U);
  EXPECT_EQ(adler32(""), 1U);
}

TEST(Png, AnIndependentReaderFindsTheSamePixels) {
  const PaletteImage image{3, 2, {{255, 0, 0}, {0, 0, 255}}, {0, 1, 0, 1, 0, 1}};

  const std::vector<Chunk> chunks = chunks_of(encode_png(image));

  ASSERT_EQ(chunks.size(), 4U);
  EXPECT_EQ(chunks[0].type, "IHDR");
  EXPECT_EQ(big_endian(chunks[0].data, 0), 3U);
  EXPECT_EQ(big_endian(chunks[0].data, 4), 2U);
  EXPECT_EQ(chunks[1].data, std::string("\xff\0\0\0\0\xff", 6));
  EXPECT_EQ(inflate_stored(chunks[2].data), std::string("\0\0\1\0\0\1\0\1", 8));
  EXPECT_EQ(chunks[3].type, "IEND");
}

TEST(Png, LargeImagesAreCutIntoStoredBlocks) {
  PaletteImage image{400, 400, {{1, 2, 3}}, std::vector<std::uint8_t>(160'000, 0)};

  const std::vector<Chunk> chunks = chunks_of(encode_png(image));

  EXPECT_EQ(inflate_stored(chunks[2].data).size(), 401U * 400U);
}

TEST(PngDeathTest, SizesMustAgree) {
  EXPECT_DEATH(encode_png({2, 2, {{0, 0, 0}}, {0}}), "pixels.size");
}

TEST(Base64, AgreesWithTheExamplesOfRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

RC_GTEST_PROP(Base64, LengthIsFourForEveryThree, (const std::string& bytes)) {
  RC_ASSERT(base64(bytes).size() == (bytes.size() + 2) / 3 * 4);
}

}  // namespace
}  // namespace skein::report
