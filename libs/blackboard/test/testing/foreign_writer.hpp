// SPDX-License-Identifier: Apache-2.0
// Writers that are none of ours and say what they like.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "skein/blackboard/cdr.hpp"
#include "skein/blackboard/network.hpp"

namespace skein::blackboard::testing {

using Bytes = std::vector<std::uint8_t>;

/// CDR of a sample, which may break every rule of the wire but that of its type.
inline Bytes bytes_of(const wire::Sample& sample) { return in_cdr(sample); }

/// What a foreign program writes on: the topic of one slot, with the type of the same or another.
struct ForeignTopic {
  std::uint32_t domain = 0;
  wire::Slot name = wire::Slot::kHeartbeat;
  wire::Slot type = wire::Slot::kHeartbeat;
  std::string partition;
};

/// Numbers for foreign participants, out of the way of the blackboards'.
inline std::uint32_t next_foreign_number() {
  static std::uint32_t last = 19;
  last = last < 31 ? last + 1 : 20;
  return last;
}

/// A DDS participant with one writer, whose samples are bytes of anybody's choice.
class ForeignWriter {
 public:
  ForeignWriter() = default;
  ForeignWriter(const ForeignWriter&) = delete;
  ForeignWriter& operator=(const ForeignWriter&) = delete;
  virtual ~ForeignWriter() = default;
  /// False if its DDS does not take it.
  virtual bool write(const Bytes& bytes) = 0;
};

std::unique_ptr<ForeignWriter> make_foreign_fastdds_writer(const ForeignTopic& topic);
std::unique_ptr<ForeignWriter> make_foreign_cyclonedds_writer(const ForeignTopic& topic);

inline std::unique_ptr<ForeignWriter> make_foreign_writer(DdsVendor vendor,
                                                          const ForeignTopic& topic) {
  return vendor == DdsVendor::kFastDds ? make_foreign_fastdds_writer(topic)
                                       : make_foreign_cyclonedds_writer(topic);
}

}  // namespace skein::blackboard::testing
