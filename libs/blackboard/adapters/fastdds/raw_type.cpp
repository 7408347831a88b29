// SPDX-License-Identifier: Apache-2.0
#include "raw_type.hpp"

#include <fastdds/rtps/common/InstanceHandle.h>
#include <fastdds/rtps/common/SerializedPayload.h>

#include <algorithm>
#include <array>

#include "sample_type.hpp"

namespace skein::blackboard::fastdds {
namespace {

using eprosima::fastrtps::rtps::InstanceHandle_t;
using eprosima::fastrtps::rtps::SerializedPayload_t;

constexpr std::size_t kEncapsulation = 4;
constexpr std::size_t kKeyOfOurs = 12;  ///< origin, instance, destination

}  // namespace

RawType::RawType(const std::string& name, bool keyed) {
  setName(name.c_str());
  m_typeSize = kTypicalSize;
  m_isGetKeyDefined = keyed;
  auto_fill_type_object(false);
  auto_fill_type_information(false);
}

bool RawType::serialize(void* data, SerializedPayload_t* payload) {
  const Sample& bytes = *static_cast<const Sample*>(data);
  if (bytes.size() > payload->max_size) return false;
  const bool little_endian = bytes.size() > 1 && (bytes[1] & 1U) != 0;
  payload->encapsulation = little_endian ? CDR_LE : CDR_BE;
  payload->length = static_cast<std::uint32_t>(bytes.size());
  std::copy(bytes.begin(), bytes.end(), payload->data);
  return true;
}

bool RawType::deserialize(SerializedPayload_t* payload, void* data) {
  static_cast<Sample*>(data)->assign(payload->data, payload->data + payload->length);
  return true;
}

std::function<uint32_t()> RawType::getSerializedSizeProvider(void* data) {
  const auto size = static_cast<std::uint32_t>(static_cast<const Sample*>(data)->size());
  return [size] { return size; };
}

void* RawType::createData() { return new Sample; }

void RawType::deleteData(void* data) { delete static_cast<Sample*>(data); }

bool RawType::getKey(void* data, InstanceHandle_t* handle, bool /*force_md5*/) {
  const Sample& bytes = *static_cast<const Sample*>(data);
  std::array<std::uint8_t, 16> key{};
  const bool ours = std::string_view(getName()).starts_with("skein::idl::");
  if (ours && bytes.size() >= kEncapsulation + kKeyOfOurs) {
    const bool little_endian = (bytes[1] & 1U) != 0;
    for (std::size_t i = 0; i < kKeyOfOurs; ++i)
      key[i] = bytes[kEncapsulation + (little_endian ? i / 4 * 4 + 3 - i % 4 : i)];
  }
  eprosima::fastrtps::rtps::octet* const out = handle->value;
  std::copy(key.begin(), key.end(), out);
  return true;
}

}  // namespace skein::blackboard::fastdds
