// SPDX-License-Identifier: Apache-2.0
// A type of which Fast DDS knows nothing but the name.
#pragma once

#include <cstdint>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <string>
#include <vector>

namespace skein::blackboard::fastdds {

/// A sample is a vector of bytes: CDR behind its 4-byte header. Without keys. Thread rule:
/// stateless, any thread.
class BytesType final : public eprosima::fastdds::dds::TopicDataType {
 public:
  explicit BytesType(const std::string& name);

  bool serialize(void* data, eprosima::fastrtps::rtps::SerializedPayload_t* payload) override;
  bool deserialize(eprosima::fastrtps::rtps::SerializedPayload_t* payload, void* data) override;
  std::function<uint32_t()> getSerializedSizeProvider(void* data) override;
  void* createData() override;
  void deleteData(void* data) override;
  bool getKey(void*, eprosima::fastrtps::rtps::InstanceHandle_t*, bool) override { return false; }
};

}  // namespace skein::blackboard::fastdds
