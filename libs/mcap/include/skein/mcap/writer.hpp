// SPDX-License-Identifier: Apache-2.0
// Writes MCAP files.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "skein/mcap/format.hpp"

namespace skein::mcap {

struct WriterOptions {
  std::string library = "skein";
  std::string profile = {};
  Compression compression = Compression::kZstd;
  std::size_t chunk = 512 * 1024;  ///< a chunk ends when it has so many bytes, uncompressed
};

/// Hands bytes to a sink, in the order of the file, from its construction to close(). What was
/// flushed can be read even if nothing follows. Not safe to share between threads. Cost of a
/// message: a copy; of a chunk: its compression.
class Writer {
 public:
  using Sink = std::function<void(std::string_view)>;

  Writer(WriterOptions options, Sink sink);
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  /// Without close() the file has no index and no footer.
  ~Writer();

  /// Precondition of both: fewer than 65,535 of them so far.
  SchemaId add(const Schema& schema);
  ChannelId add(const Channel& channel);
  /// Messages of a channel are numbered from 1. Precondition: `channel` was added.
  void write(ChannelId channel, std::uint64_t log_time, std::uint64_t publish_time,
             std::string_view data);
  void write(ChannelId channel, std::uint64_t time, std::string_view data) {
    write(channel, time, time, data);
  }
  /// Facts of the whole file.
  void metadata(const std::string& name, const std::map<std::string, std::string>& facts);
  /// Ends the chunk, so that all messages so far can be read.
  void flush();
  /// Flushes, then writes index, statistics and footer. Nothing may be written after it.
  void close();

  std::uint64_t bytes() const;     ///< handed to the sink so far
  std::uint64_t messages() const;  ///< written so far

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace skein::mcap
