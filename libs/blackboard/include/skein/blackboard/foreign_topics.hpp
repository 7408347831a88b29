// SPDX-License-Identifier: Apache-2.0
// Topics of programs that know nothing of Skein, as bytes.
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

/// A topic without keys, volatile, of which the last `depth` samples count; in no partition.
struct ForeignTopic {
  std::string name;
  std::string type;
  bool reliable = true;
  int depth = 10;
};

struct ForeignConfig {
  std::uint32_t domain = 0;      ///< 0 to 100
  std::string participant_name;  ///< shown by DDS tools
  NetworkConfig network;         ///< keys do not count: others have none
  std::vector<ForeignTopic> writes;
  std::vector<ForeignTopic> reads;
};

/// A participant of its own in a domain of others: writes and reads what is already, or still,
/// bytes of CDR behind their 4-byte header. Thread rule: one thread, but for what `on_arrival` is
/// given, which any of the middleware's threads may call.
class ForeignTopics {
 public:
  static Result<std::unique_ptr<ForeignTopics>, Failure> open(ForeignConfig config);
  ~ForeignTopics();
  ForeignTopics(const ForeignTopics&) = delete;
  ForeignTopics& operator=(const ForeignTopics&) = delete;

  /// `topic` is an index into `writes`. False if the middleware does not take it. Never blocks for
  /// longer than 100 ms, and only if a reader that wants all does not keep up.
  bool write(std::size_t topic, std::span<const std::uint8_t> bytes);

  struct Arrival {
    std::size_t topic = 0;  ///< index into `reads`
    std::vector<std::uint8_t> bytes;
  };
  /// What has come; at most kWaiting are kept, of more the oldest are lost.
  std::vector<Arrival> take();
  static constexpr std::size_t kWaiting = 64;
  void on_arrival(std::function<void()> notify);

 private:
  class Impl;
  explicit ForeignTopics(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace skein::blackboard
