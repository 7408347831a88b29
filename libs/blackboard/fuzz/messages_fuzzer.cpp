// SPDX-License-Identifier: Apache-2.0
// RTPS messages of anybody that pass by: what is given was sent whole, and is given once.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <set>
#include <span>
#include <string>

#include "adapters/passive/message_data.hpp"

namespace {

using skein::blackboard::passive::MessageData;
using skein::blackboard::passive::SampleData;

void demand(bool holds) {
  if (!holds) std::abort();
}

/// Of what a writer said, all that was given.
struct Given {
  std::uint64_t greatest = 0;
  std::set<std::uint64_t> numbers;
};

class Passing {
 public:
  void take(std::span<const std::uint8_t> message) {
    for (const SampleData& sample : data_.take(message)) {
      demand(sample.writer.size() == kGuid && sample.bytes.size() <= MessageData::kLongest);
      Given& given = given_[sample.writer];
      const bool fresh = given.numbers.insert(sample.sequence).second;
      demand(fresh || sample.sequence + MessageData::kRemembered <= given.greatest);
      given.greatest = std::max(given.greatest, sample.sequence);
    }
  }

 private:
  static constexpr std::size_t kGuid = 33;  ///< digits of the prefix, a dot, those of the entity

  MessageData data_;
  std::map<std::string, Given> given_;
};

}  // namespace

// Messages behind each other, each behind its length in two bytes.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::span<const std::uint8_t> left(data, size);
  Passing passing;
  while (left.size() > 2) {
    const std::size_t length = std::min<std::size_t>(left.size() - 2, left[0] << 8U | left[1]);
    passing.take(left.subspan(2, length));
    left = left.subspan(2 + length);
  }
  return 0;
}
