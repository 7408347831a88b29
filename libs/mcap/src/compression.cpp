// SPDX-License-Identifier: Apache-2.0
#include "compression.hpp"

#include <lz4frame.h>
#include <zstd.h>

#include <memory>

#include "skein/foundation/contract.hpp"

namespace skein::mcap {

namespace {

constexpr int kLevel = 1;  // of zstd: half the time of its default for a twentieth more bytes

std::string lz4(std::string_view bytes) {
  std::string out(LZ4F_compressFrameBound(bytes.size(), nullptr), '\0');
  const std::size_t size =
      LZ4F_compressFrame(out.data(), out.size(), bytes.data(), bytes.size(), nullptr);
  SKEIN_ENSURES(LZ4F_isError(size) == 0);
  out.resize(size);
  return out;
}

std::string zstd(std::string_view bytes) {
  std::string out(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size =
      ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), kLevel);
  SKEIN_ENSURES(ZSTD_isError(size) == 0);
  out.resize(size);
  return out;
}

bool un_lz4(std::string_view bytes, std::string& out) {
  LZ4F_dctx* made = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&made, LZ4F_VERSION)) != 0) return false;
  const std::unique_ptr<LZ4F_dctx, decltype(&LZ4F_freeDecompressionContext)> context(
      made, &LZ4F_freeDecompressionContext);
  std::size_t from = 0, to = 0;
  for (;;) {
    std::size_t room = out.size() - to, left = bytes.size() - from;
    const std::size_t hint =
        LZ4F_decompress(context.get(), out.data() + to, &room, bytes.data() + from, &left, nullptr);
    if (LZ4F_isError(hint) != 0) return false;
    from += left;
    to += room;
    if (hint == 0) return to == out.size();  // the frame is whole
    if (left == 0 && room == 0) return false;
  }
}

bool un_zstd(std::string_view bytes, std::string& out) {
  const std::size_t size = ZSTD_decompress(out.data(), out.size(), bytes.data(), bytes.size());
  return ZSTD_isError(size) == 0 && size == out.size();
}

}  // namespace

std::string_view name_of(Compression compression) {
  switch (compression) {
    case Compression::kLz4:
      return "lz4";
    case Compression::kZstd:
      return "zstd";
    case Compression::kNone:
      break;
  }
  return "";
}

std::optional<Compression> compression_named(std::string_view name) {
  for (const Compression one : {Compression::kNone, Compression::kLz4, Compression::kZstd})
    if (name == name_of(one)) return one;
  return std::nullopt;
}

std::string compressed(Compression compression, std::string_view bytes) {
  if (compression == Compression::kLz4) return lz4(bytes);
  if (compression == Compression::kZstd) return zstd(bytes);
  return std::string(bytes);
}

std::optional<std::string> uncompressed(Compression compression, std::string_view bytes,
                                        std::size_t size) {
  if (compression == Compression::kNone) {
    if (bytes.size() != size) return std::nullopt;
    return std::string(bytes);
  }
  std::string out(size, '\0');
  const bool good = compression == Compression::kLz4 ? un_lz4(bytes, out) : un_zstd(bytes, out);
  if (!good) return std::nullopt;
  return out;
}

}  // namespace skein::mcap
