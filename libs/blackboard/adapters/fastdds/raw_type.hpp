// SPDX-License-Identifier: Apache-2.0
// A type of which nothing is known but its name.
#pragma once

#include <fastdds/dds/topic/TopicDataType.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace skein::blackboard::fastdds {

/// Its samples are bytes, with the 4 bytes of their encapsulation first. Instances are told apart
/// by the key hash that the writer sends; of our own types, whose key is the beginning of the
/// header, also without one.
class RawType final : public eprosima::fastdds::dds::TopicDataType {
 public:
  using Sample = std::vector<std::uint8_t>;

  RawType(const std::string& name, bool keyed);

  bool serialize(void* data, eprosima::fastrtps::rtps::SerializedPayload_t* payload) override;
  bool deserialize(eprosima::fastrtps::rtps::SerializedPayload_t* payload, void* data) override;
  std::function<uint32_t()> getSerializedSizeProvider(void* data) override;
  void* createData() override;
  void deleteData(void* data) override;
  bool getKey(void* data, eprosima::fastrtps::rtps::InstanceHandle_t* handle,
              bool force_md5) override;
};

}  // namespace skein::blackboard::fastdds
