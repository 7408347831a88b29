// SPDX-License-Identifier: Apache-2.0
#include "skein/mcap/writer.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "bytes.hpp"
#include "compression.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::mcap {

namespace {

constexpr std::size_t kMost = 65'534;  ///< schemas, and channels

/// The messages of a channel in a chunk: time and offset.
using Index = std::vector<std::pair<std::uint64_t, std::uint64_t>>;

struct Span {
  std::uint64_t from = UINT64_MAX, to = 0;
  void add(std::uint64_t time) {
    from = std::min(from, time);
    to = std::max(to, time);
  }
  std::uint64_t start() const { return from == UINT64_MAX ? 0 : from; }
};

}  // namespace

class Writer::Impl {
 public:
  Impl(WriterOptions options, Sink sink) : options_(std::move(options)), sink_(std::move(sink)) {
    put(kMagic);
    Bytes header;
    header.put(std::string_view(options_.profile)).put(std::string_view(options_.library));
    put(record(Op::kHeader, header.text()));
  }

  SchemaId add(const Schema& schema) {
    SKEIN_EXPECTS(schemas_.size() < kMost);
    const auto id = static_cast<SchemaId>(schemas_.size() + 1);
    schemas_.push_back(record_of(id, schema));
    chunk_ += schemas_.back();
    return id;
  }

  ChannelId add(const Channel& channel) {
    SKEIN_EXPECTS(channels_.size() < kMost && channel.schema <= schemas_.size());
    const auto id = static_cast<ChannelId>(channels_.size() + 1);
    channels_.push_back(record_of(id, channel));
    counts_.push_back(0);
    chunk_ += channels_.back();
    return id;
  }

  void write(const Message& message) {
    SKEIN_EXPECTS(!closed_ && message.channel >= 1 && message.channel <= channels_.size());
    const auto count = ++counts_[message.channel - 1U];
    chunk_index_[message.channel].emplace_back(message.log_time, chunk_.size());
    chunk_span_.add(message.log_time);
    Bytes head;
    head.put(static_cast<std::uint8_t>(Op::kMessage))
        .put(static_cast<std::uint64_t>(22 + message.data.size()))
        .put(message.channel)
        .put(static_cast<std::uint32_t>(count))
        .put(message.log_time)
        .put(message.publish_time);
    chunk_ += head.text();
    chunk_.append(message.data);
    ++messages_;
    if (chunk_.size() >= options_.chunk) flush();
  }

  void metadata(const std::string& name, const std::map<std::string, std::string>& facts) {
    Bytes content, index;
    content.put(std::string_view(name)).put(facts);
    const std::string whole = record(Op::kMetadata, content.text());
    index.put(offset_).put(static_cast<std::uint64_t>(whole.size())).put(std::string_view(name));
    metadata_indexes_.push_back(record(Op::kMetadataIndex, index.text()));
    put(whole);
  }

  void flush() {
    if (chunk_.empty()) return;
    const std::uint64_t start = offset_;
    const std::string records = compressed(options_.compression, chunk_);
    Bytes content;
    content.put(chunk_span_.start())
        .put(chunk_span_.to)
        .put(static_cast<std::uint64_t>(chunk_.size()))
        .put(crc32_of(chunk_))
        .put(name_of(options_.compression))
        .put(static_cast<std::uint64_t>(records.size()))
        .raw(records);
    put(record(Op::kChunk, content.text()));
    const std::uint64_t length = offset_ - start;
    const auto [offsets, index_length] = put_message_indexes();
    Bytes index;
    index.put(chunk_span_.start()).put(chunk_span_.to).put(start).put(length);
    index.put(std::string_view(offsets)).put(index_length).put(name_of(options_.compression));
    index.put(static_cast<std::uint64_t>(records.size()))
        .put(static_cast<std::uint64_t>(chunk_.size()));
    chunk_indexes_.push_back(record(Op::kChunkIndex, index.text()));
    begin_chunk();
  }

  void close() {
    if (std::exchange(closed_, true)) return;
    flush();
    put(record(Op::kDataEnd, Bytes().put(crc_).text()));
    const std::uint64_t summary = offset_;
    crc_ = 0;
    put_group(Op::kSchema, schemas_);
    put_group(Op::kChannel, channels_);
    put_group(Op::kStatistics, {statistics()});
    put_group(Op::kChunkIndex, chunk_indexes_);
    put_group(Op::kMetadataIndex, metadata_indexes_);
    const std::uint64_t offsets = offset_;
    for (const std::string& one : summary_offsets_) put(one);
    // The checksum covers the footer up to itself.
    Bytes places;
    places.put(static_cast<std::uint8_t>(Op::kFooter)).put(std::uint64_t{20});
    put(places.put(summary).put(offsets).text());
    put(Bytes().put(crc_).text());
    put(kMagic);
  }

  std::uint64_t bytes() const { return offset_; }
  std::uint64_t messages() const { return messages_; }

 private:
  void put(std::string_view bytes) {
    crc_ = crc32_of(bytes, crc_);
    offset_ += bytes.size();
    sink_(bytes);
  }

  /// The map of their places, and their length together.
  std::pair<std::string, std::uint64_t> put_message_indexes() {
    const std::uint64_t start = offset_;
    Bytes offsets;
    for (const auto& [channel, index] : chunk_index_) {
      offsets.put(channel).put(offset_);
      Bytes entries;
      for (const auto& [time, at] : index) entries.put(time).put(at);
      Bytes content;
      content.put(channel).put(std::string_view(entries.text()));
      put(record(Op::kMessageIndex, content.text()));
    }
    return {offsets.text(), offset_ - start};
  }

  void begin_chunk() {
    if (!chunk_index_.empty()) {
      span_.add(chunk_span_.from);
      span_.add(chunk_span_.to);
    }
    chunk_.clear();
    chunk_index_.clear();
    chunk_span_ = {};
  }

  void put_group(Op op, const std::vector<std::string>& records) {
    if (records.empty()) return;
    const std::uint64_t start = offset_;
    for (const std::string& one : records) put(one);
    Bytes place;
    place.put(static_cast<std::uint8_t>(op)).put(start).put(offset_ - start);
    summary_offsets_.push_back(record(Op::kSummaryOffset, place.text()));
  }

  std::string statistics() const {
    const auto number = [](const auto& of) { return static_cast<std::uint32_t>(of.size()); };
    Bytes counts, content;
    for (std::size_t i = 0; i < counts_.size(); ++i)
      counts.put(static_cast<ChannelId>(i + 1)).put(counts_[i]);
    content.put(messages_)
        .put(static_cast<std::uint16_t>(schemas_.size()))
        .put(number(channels_))
        .put(std::uint32_t{0})
        .put(number(metadata_indexes_))
        .put(number(chunk_indexes_))
        .put(span_.start())
        .put(span_.to)
        .put(std::string_view(counts.text()));
    return record(Op::kStatistics, content.text());
  }

  WriterOptions options_;
  Sink sink_;
  std::uint64_t offset_ = 0;
  std::uint32_t crc_ = 0;  ///< of the data section, then of the summary
  bool closed_ = false;
  std::vector<std::string> schemas_, channels_;  ///< their records, by id from 1
  std::vector<std::uint64_t> counts_;            ///< messages by channel
  std::vector<std::string> chunk_indexes_, metadata_indexes_, summary_offsets_;
  std::uint64_t messages_ = 0;
  Span span_;
  std::string chunk_;  ///< that is being filled
  std::map<ChannelId, Index> chunk_index_;
  Span chunk_span_;
};

Writer::Writer(WriterOptions options, Sink sink)
    : impl_(std::make_unique<Impl>(std::move(options), std::move(sink))) {}
Writer::~Writer() = default;
SchemaId Writer::add(const Schema& schema) { return impl_->add(schema); }
ChannelId Writer::add(const Channel& channel) { return impl_->add(channel); }
void Writer::write(ChannelId channel, std::uint64_t log_time, std::uint64_t publish_time,
                   std::string_view data) {
  impl_->write({channel, 0, log_time, publish_time, data});
}
void Writer::metadata(const std::string& name, const std::map<std::string, std::string>& facts) {
  impl_->metadata(name, facts);
}
void Writer::flush() { impl_->flush(); }
void Writer::close() { impl_->close(); }
std::uint64_t Writer::bytes() const { return impl_->bytes(); }
std::uint64_t Writer::messages() const { return impl_->messages(); }

}  // namespace skein::mcap
