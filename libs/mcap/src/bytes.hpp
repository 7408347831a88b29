// SPDX-License-Identifier: Apache-2.0
// Bytes of MCAP records, little-endian.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "skein/mcap/format.hpp"

namespace skein::mcap {

static_assert(std::endian::native == std::endian::little);

inline constexpr std::string_view kMagic{"\x89MCAP0\r\n", 8};

enum class Op : std::uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kStatistics = 0x0B,
  kMetadata = 0x0C,
  kMetadataIndex = 0x0D,
  kSummaryOffset = 0x0E,
  kDataEnd = 0x0F
};

inline constexpr std::size_t kRecordHead = 9;  ///< opcode and length

/// Appends to a text.
class Bytes {
 public:
  template <std::unsigned_integral N>
  Bytes& put(N number) {
    out_.append(reinterpret_cast<const char*>(&number), sizeof number);
    return *this;
  }
  /// With its length before it.
  Bytes& put(std::string_view text) {
    put(static_cast<std::uint32_t>(text.size()));
    return raw(text);
  }
  Bytes& put(const std::map<std::string, std::string>& map);
  Bytes& raw(std::string_view text) {
    out_.append(text);
    return *this;
  }
  const std::string& text() const { return out_; }

 private:
  std::string out_;
};

/// A whole record.
std::string record(Op op, std::string_view content);
std::string record_of(SchemaId id, const Schema& schema);
std::string record_of(ChannelId id, const Channel& channel);

/// Takes from the beginning of a text; once something is not there, nothing is.
class Taker {
 public:
  explicit Taker(std::string_view text) : left_(text) {}

  template <std::unsigned_integral N>
  N take() {
    N number{};
    const std::string_view from = take(sizeof number);
    if (good_) std::memcpy(&number, from.data(), sizeof number);
    return number;
  }
  std::string_view take(std::uint64_t size) {
    good_ = good_ && size <= left_.size();
    if (!good_) return {};
    const std::string_view taken = left_.substr(0, size);
    left_.remove_prefix(size);
    return taken;
  }
  std::string_view text() { return take(take<std::uint32_t>()); }
  std::map<std::string, std::string> map();

  bool good() const { return good_; }
  std::string_view left() const { return left_; }

 private:
  std::string_view left_;
  bool good_ = true;
};

/// Nothing for records that are too short.
std::optional<std::pair<SchemaId, Schema>> schema_from(std::string_view content);
std::optional<std::pair<ChannelId, Channel>> channel_from(std::string_view content);
std::optional<Message> message_from(std::string_view content);

/// CRC-32 as zlib and Ethernet have it, going on from `before` (0 at first).
std::uint32_t crc32_of(std::string_view bytes, std::uint32_t before = 0);

}  // namespace skein::mcap
