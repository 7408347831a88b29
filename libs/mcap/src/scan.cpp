// SPDX-License-Identifier: Apache-2.0
#include "skein/mcap/scan.hpp"

#include <optional>

#include "bytes.hpp"
#include "compression.hpp"

namespace skein::mcap {

namespace {

using Use = std::function<void(const Channel&, const Message&)>;

class Scan {
 public:
  Scan(std::string_view file, const Use& use, const ScanLimits& limits)
      : file_(file), use_(use), limits_(limits) {}

  Contents run() {
    contents_.begun = file_.substr(0, kMagic.size()) == kMagic;
    if (!contents_.begun) {
      problem(0, "this does not begin as an MCAP file does");
      return std::move(contents_);
    }
    read(file_.substr(kMagic.size()), kMagic.size(), false);
    check_statistics();
    return std::move(contents_);
  }

 private:
  void problem(std::uint64_t at, const std::string& what) {
    if (contents_.problems.size() < limits_.problems) {
      contents_.problems.push_back("byte " + std::to_string(at) + ": " + what);
    } else {
      ++contents_.more_problems;
    }
  }

  /// The records of a text that begins at `base` in the file; those of a chunk may be fewer.
  void read(std::string_view text, std::uint64_t base, bool in_chunk) {
    Taker taker(text);
    while (!taker.left().empty() && !over_) {
      const std::uint64_t at = base + text.size() - taker.left().size();
      const auto op = taker.take<std::uint8_t>();
      const auto size = taker.take<std::uint64_t>();
      const std::string_view content = taker.take(size);
      if (!taker.good()) {
        problem(at, "it was cut off within a record");
        if (op == static_cast<std::uint8_t>(Op::kChunk) && !in_chunk) salvage(taker.left(), at);
        return;
      }
      take(static_cast<Op>(op), content, at, in_chunk);
    }
  }

  void take(Op op, std::string_view content, std::uint64_t at, bool in_chunk) {
    if (op == Op::kMessage && !in_summary_) return take_message(content, at);
    if (op == Op::kSchema) return take_schema(content, at);
    if (op == Op::kChannel) return take_channel(content, at);
    if (in_chunk) return;  // nothing else belongs there
    if (op == Op::kHeader) return take_header(content, at);
    if (op == Op::kChunk && !in_summary_) return take_chunk(content, at);
    if (op == Op::kMetadata) return take_metadata(content, at);
    if (op == Op::kStatistics) statistics_ = content;
    if (op == Op::kDataEnd) take_data_end(content, at);
    if (op == Op::kFooter) take_footer(content, at);
  }

  void take_header(std::string_view content, std::uint64_t at) {
    Taker taker(content);
    const std::string_view profile = taker.text(), library = taker.text();
    if (!taker.good()) return problem(at, "a header that is too short");
    contents_.profile = profile;
    contents_.library = library;
  }

  template <class Id, class Thing>
  void keep(std::map<Id, Thing>& all, std::optional<std::pair<Id, Thing>> one, const char* what,
            std::uint64_t at) {
    if (!one) return problem(at, std::string("a ") + what + " that is too short");
    const auto [place, fresh] = all.emplace(*one);
    if (!fresh && place->second != one->second)
      problem(at, std::string(what) + " " + std::to_string(one->first) + " again, and another");
  }

  void take_schema(std::string_view content, std::uint64_t at) {
    keep(contents_.schemas, schema_from(content), "schema", at);
  }

  void take_channel(std::string_view content, std::uint64_t at) {
    keep(contents_.channels, channel_from(content), "channel", at);
  }

  void take_message(std::string_view content, std::uint64_t at) {
    const auto message = message_from(content);
    if (!message) return problem(at, "a message that is too short");
    const auto channel = contents_.channels.find(message->channel);
    if (channel == contents_.channels.end())
      return problem(at, "a message of channel " + std::to_string(message->channel) +
                             ", which is not declared");
    ++contents_.messages;
    use_(channel->second, *message);
  }

  void take_metadata(std::string_view content, std::uint64_t at) {
    Taker taker(content);
    const std::string name(taker.text());
    auto facts = taker.map();
    if (!taker.good()) return problem(at, "metadata that are too short");
    contents_.metadata.emplace(name, std::move(facts));
  }

  struct ChunkHead {
    std::uint64_t size = 0;
    std::uint32_t crc = 0;
    std::string compression;
    std::uint64_t bytes = 0;
  };

  static ChunkHead chunk_head(Taker& taker) {
    taker.take(16);  // its times
    ChunkHead head;
    head.size = taker.take<std::uint64_t>();
    head.crc = taker.take<std::uint32_t>();
    head.compression = taker.text();
    head.bytes = taker.take<std::uint64_t>();
    return head;
  }

  void take_chunk(std::string_view content, std::uint64_t at) {
    Taker taker(content);
    const ChunkHead head = chunk_head(taker);
    const std::string_view bytes = taker.take(head.bytes);
    if (!taker.good()) return problem(at, "a chunk that is too short");
    const auto compression = compression_named(head.compression);
    if (!compression) return problem(at, "a chunk compressed by '" + head.compression + "'");
    if (head.size > limits_.chunk)
      return problem(at, "a chunk of " + std::to_string(head.size) + " bytes is too large");
    const auto records = uncompressed(*compression, bytes, head.size);
    if (!records) return problem(at, "a chunk that does not come out of its compression");
    if (head.crc != 0 && crc32_of(*records) != head.crc)
      return problem(at, "a chunk whose checksum is wrong");
    read(*records, at, true);
  }

  /// Of an uncompressed chunk that was cut off what is whole can be read, unchecked.
  void salvage(std::string_view left, std::uint64_t at) {
    Taker taker(left);
    const ChunkHead head = chunk_head(taker);
    if (taker.good() && head.compression.empty()) read(taker.left(), at, true);
  }

  void take_data_end(std::string_view content, std::uint64_t at) {
    in_summary_ = true;
    Taker taker(content);
    const auto crc = taker.take<std::uint32_t>();
    if (!taker.good()) return problem(at, "an end of data that is too short");
    if (crc != 0 && crc != crc32_of(file_.substr(0, at)))
      problem(at, "the checksum of the data is wrong");
  }

  void take_footer(std::string_view content, std::uint64_t at) {
    over_ = true;
    Taker taker(content);
    const auto summary = taker.take<std::uint64_t>();
    taker.take<std::uint64_t>();
    const auto crc = taker.take<std::uint32_t>();
    const std::uint64_t end = at + kRecordHead + content.size();
    if (!taker.good()) return problem(at, "a footer that is too short");
    contents_.complete = file_.substr(end) == kMagic;
    if (!contents_.complete)
      problem(end, "the end of the file is missing, or something follows it");
    const std::uint64_t checked = at + kRecordHead + 16;
    if (crc == 0 || summary == 0) return;
    if (summary > at || crc != crc32_of(file_.substr(summary, checked - summary)))
      problem(at, "the checksum of the summary is wrong");
  }

  void check_statistics() {
    if (!contents_.complete) {
      if (contents_.problems.empty()) problem(file_.size(), "it ends without a footer");
      return;
    }
    if (statistics_.empty()) return;
    Taker taker(statistics_);
    const auto messages = taker.take<std::uint64_t>();
    if (taker.good() && messages != contents_.messages)
      problem(file_.size(), std::to_string(contents_.messages) + " messages were read of " +
                                std::to_string(messages) + " that were written");
  }

  std::string_view file_;
  const Use& use_;
  const ScanLimits& limits_;
  Contents contents_;
  bool in_summary_ = false, over_ = false;
  std::string_view statistics_;
};

}  // namespace

Contents scan(std::string_view file, const Use& use, const ScanLimits& limits) {
  return Scan(file, use, limits).run();
}

}  // namespace skein::mcap
