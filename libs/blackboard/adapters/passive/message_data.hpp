// SPDX-License-Identifier: Apache-2.0
// The samples that are in RTPS messages, whoever they are for.
#pragma once

#include <bitset>
#include <cstdint>
#include <deque>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace skein::blackboard::passive {

/// A sample as its writer sent it.
struct SampleData {
  std::string writer;  ///< as Endpoint::guid
  std::uint64_t sequence = 0;
  std::int64_t sent = 0;            ///< by the writer's clock [ns since 1970]; 0: it does not say
  std::vector<std::uint8_t> bytes;  ///< behind the 4-byte header of CDR; none: the instance is gone
};

/// Reads messages in the order they passed by. The same sample goes to each of its readers, and
/// again to who lost it: each is given once, as far as can be told by the last kRemembered numbers
/// of its writer. Samples in fragments are put together; of more than kMostOpen that are begun, and
/// of those longer than kLongest, the rest is lost. What is malformed is passed over. Source: RTPS
/// 2.3, 8.3.7 and 9.4.5. Cost: linear in the message.
class MessageData {
 public:
  static constexpr std::size_t kRemembered = 1024;
  static constexpr std::size_t kMostOpen = 64;
  static constexpr std::uint32_t kLongest = 16U << 20U;  ///< [byte]

  /// What is whole now.
  std::vector<SampleData> take(std::span<const std::uint8_t> message);

 private:
  /// Which of the last sequence numbers of a writer have been given.
  struct Given {
    std::uint64_t last = 0;
    std::bitset<kRemembered> recent;
    bool add(std::uint64_t sequence);
  };
  using Key = std::pair<std::string, std::uint64_t>;  ///< writer, sequence
  struct Open {
    SampleData sample;
    std::uint32_t part = 0;   ///< [byte] of a fragment, the last aside
    std::vector<bool> there;  ///< by fragment
    std::size_t missing = 0;
  };
  struct Context;
  struct Body;
  void take_whole(const Context& context, const Body& body);
  void take_fragments(const Context& context, const Body& body);
  Open* opened(const Context& context, const Body& body, std::uint32_t size, std::uint32_t part);
  void give(SampleData sample);

  std::map<std::string, Given> given_;
  std::map<Key, Open> open_;
  std::deque<Key> order_;  ///< of those that were begun
  std::vector<SampleData> out_;
};

}  // namespace skein::blackboard::passive
