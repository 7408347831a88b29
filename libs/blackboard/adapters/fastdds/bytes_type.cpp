// SPDX-License-Identifier: Apache-2.0
#include "bytes_type.hpp"

#include <fastdds/rtps/common/SerializedPayload.h>

#include <algorithm>

namespace skein::blackboard::fastdds {

namespace {

using Bytes = std::vector<std::uint8_t>;
using eprosima::fastrtps::rtps::SerializedPayload_t;

/// Only a first guess for buffers, which grow.
constexpr std::uint32_t kTypicalSize = 512;

}  // namespace

BytesType::BytesType(const std::string& name) {
  setName(name.c_str());
  m_typeSize = kTypicalSize;
  m_isGetKeyDefined = false;
  auto_fill_type_object(false);
  auto_fill_type_information(false);
}

bool BytesType::serialize(void* data, SerializedPayload_t* payload) {
  const Bytes& bytes = *static_cast<const Bytes*>(data);
  if (bytes.size() > payload->max_size) return false;
  payload->encapsulation = CDR_LE;
  payload->length = static_cast<std::uint32_t>(bytes.size());
  std::copy(bytes.begin(), bytes.end(), payload->data);
  return true;
}

bool BytesType::deserialize(SerializedPayload_t* payload, void* data) {
  static_cast<Bytes*>(data)->assign(payload->data, payload->data + payload->length);
  return true;
}

std::function<uint32_t()> BytesType::getSerializedSizeProvider(void* data) {
  const auto size = static_cast<std::uint32_t>(static_cast<const Bytes*>(data)->size());
  return [size] { return size; };
}

void* BytesType::createData() { return new Bytes; }

void BytesType::deleteData(void* data) { delete static_cast<Bytes*>(data); }

}  // namespace skein::blackboard::fastdds
