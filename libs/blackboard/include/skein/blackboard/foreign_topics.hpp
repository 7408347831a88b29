// SPDX-License-Identifier: Apache-2.0
// DDS topics of programs that are not part of Skein, as bytes.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "skein/blackboard/network.hpp"
#include "skein/foundation/result.hpp"

namespace skein::blackboard {

/// A topic without keys; durability volatile, history keep-last `depth`, default partition.
struct ForeignTopic {
  std::string name;
  std::string type;
  bool reliable = true;
  int depth = 10;
};

struct ForeignConfig {
  std::uint32_t domain = 0;      ///< 0 to 100
  std::string participant_name;  ///< shown by DDS tools
  NetworkConfig network;         ///< its `keys` are ignored: foreign programs have none
  std::vector<ForeignTopic> writes;
  std::vector<ForeignTopic> reads;
};

/// A participant in a foreign DDS domain. Writes and reads samples as CDR bytes behind their 4-byte
/// encapsulation header. Thread rule: one thread, except that the middleware calls the callback of
/// on_arrival() from any of its threads.
class ForeignTopics {
 public:
  static Result<std::unique_ptr<ForeignTopics>, Failure> open(ForeignConfig config);
  ~ForeignTopics();
  ForeignTopics(const ForeignTopics&) = delete;
  ForeignTopics& operator=(const ForeignTopics&) = delete;

  /// `topic` is an index into `writes`. False if the middleware does not accept the sample. Blocks
  /// only if a reliable reader does not keep up, and for at most 100 ms.
  bool write(std::size_t topic, std::span<const std::uint8_t> bytes);

  struct Arrival {
    std::size_t topic = 0;  ///< index into `reads`
    std::vector<std::uint8_t> bytes;
  };
  /// The samples that arrived since the last call; only the last kWaiting are kept.
  std::vector<Arrival> take();
  static constexpr std::size_t kWaiting = 64;
  void on_arrival(std::function<void()> notify);

 private:
  class Impl;
  explicit ForeignTopics(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace skein::blackboard
