// SPDX-License-Identifier: Apache-2.0
// Bytes come out of compression as they went in, or not at all.
#include "compression.hpp"

#include <gtest/gtest.h>

#include "recorded.hpp"

namespace skein::mcap {
namespace {

RC_GTEST_PROP(Compressed, ComesOutAsItWentIn, (const std::string& bytes)) {
  const auto compression = *any_compression();
  const auto back = uncompressed(compression, compressed(compression, bytes), bytes.size());

  RC_ASSERT(back.has_value());
  RC_ASSERT(*back == bytes);
}

RC_GTEST_PROP(Compressed, OfAnotherSizeDoesNotComeOut, (const std::string& bytes)) {
  const auto compression = *any_compression();
  const std::string small = compressed(compression, bytes);

  RC_ASSERT(!uncompressed(compression, small, bytes.size() + 1).has_value());
  if (!bytes.empty()) RC_ASSERT(!uncompressed(compression, small, bytes.size() - 1).has_value());
}

TEST(Compressed, SavesWhatRepeats) {
  const std::string bytes(100'000, 'x');

  EXPECT_LT(compressed(Compression::kLz4, bytes).size(), 1000U);
  EXPECT_LT(compressed(Compression::kZstd, bytes).size(), 1000U);
}

TEST(Compressed, CutOffDoesNotComeOut) {
  std::string bytes;
  for (int i = 0; i < 5000; ++i) bytes += std::to_string(i * i);
  for (const Compression one : {Compression::kLz4, Compression::kZstd}) {
    const std::string small = compressed(one, bytes);
    for (const std::size_t size : {small.size() - 1, small.size() / 2, std::size_t{0}})
      EXPECT_FALSE(uncompressed(one, std::string_view(small).substr(0, size), bytes.size()));
  }
}

TEST(Compression, HasTheNamesOfTheFormat) {
  EXPECT_EQ(name_of(Compression::kNone), "");
  EXPECT_EQ(compression_named("lz4"), Compression::kLz4);
  EXPECT_EQ(compression_named("zstd"), Compression::kZstd);
  EXPECT_EQ(compression_named("bz2"), std::nullopt);
}

}  // namespace
}  // namespace skein::mcap
