// SPDX-License-Identifier: Apache-2.0
// How Fast DDS sees the type of a slot.
#pragma once

#include <fastdds/dds/topic/TopicDataType.hpp>
#include <variant>

#include "skein/blackboard/transport.hpp"

namespace skein::blackboard::fastdds {

/// Of a sample [byte]: only a first guess for buffers, which grow.
inline constexpr std::uint32_t kTypicalSize = 512;

/// The data behind the void pointers of Fast DDS: for writing a pointer to the sample, for reading
/// the received content.
struct Cargo {
  const wire::Sample* outgoing = nullptr;
  std::variant<wire::Sample, Malformed> incoming;
};

/// The DDS type "skein::idl::<slot>". Malformed content is not an error for Fast DDS (which would
/// drop it without a word): it is read as Malformed. Thread rule: stateless, any thread.
class SampleType final : public eprosima::fastdds::dds::TopicDataType {
 public:
  explicit SampleType(wire::Slot slot);

  bool serialize(void* data, eprosima::fastrtps::rtps::SerializedPayload_t* payload) override;
  bool deserialize(eprosima::fastrtps::rtps::SerializedPayload_t* payload, void* data) override;
  std::function<uint32_t()> getSerializedSizeProvider(void* data) override;
  void* createData() override;
  void deleteData(void* data) override;
  bool getKey(void* data, eprosima::fastrtps::rtps::InstanceHandle_t* handle,
              bool force_md5) override;

 private:
  wire::Slot slot_;
};

}  // namespace skein::blackboard::fastdds
