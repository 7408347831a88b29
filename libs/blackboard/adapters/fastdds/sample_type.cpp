// SPDX-License-Identifier: Apache-2.0
// How Fast DDS sees the type of a slot.
#include "sample_type.hpp"

#include <fastdds/rtps/common/InstanceHandle.h>
#include <fastdds/rtps/common/SerializedPayload.h>
#include <fastrtps/utils/md5.h>

#include <algorithm>
#include <array>
#include <string>

#include "skein/blackboard/cdr.hpp"
#include "skein/blackboard/dds_type.hpp"

namespace skein::blackboard::fastdds {
namespace {

using eprosima::fastrtps::rtps::InstanceHandle_t;
using eprosima::fastrtps::rtps::SerializedPayload_t;

const wire::SampleHeader& header_of(const Cargo& cargo) {
  if (cargo.outgoing != nullptr) return wire::header_of(*cargo.outgoing);
  if (const auto* sample = std::get_if<wire::Sample>(&cargo.incoming)) {
    return wire::header_of(*sample);
  }
  return std::get<Malformed>(cargo.incoming).header;
}

}  // namespace

SampleType::SampleType(wire::Slot slot) : slot_(slot) {
  setName(blackboard::dds_type_of(slot).c_str());
  m_typeSize = kTypicalSize;
  m_isGetKeyDefined = true;
  auto_fill_type_object(false);
  auto_fill_type_information(false);
}

bool SampleType::serialize(void* data, SerializedPayload_t* payload) {
  const wire::Sample& sample = *static_cast<const Cargo*>(data)->outgoing;
  if (encoded_size(sample) > payload->max_size) return false;
  payload->encapsulation = CDR_LE;
  payload->length = static_cast<std::uint32_t>(encode(sample, {payload->data, payload->max_size}));
  return true;
}

bool SampleType::deserialize(SerializedPayload_t* payload, void* data) {
  auto& cargo = *static_cast<Cargo*>(data);
  cargo.incoming = decode(slot_, {payload->data, payload->length});
  return true;
}

std::function<uint32_t()> SampleType::getSerializedSizeProvider(void* data) {
  const wire::Sample* sample = static_cast<const Cargo*>(data)->outgoing;
  return [sample] { return static_cast<std::uint32_t>(encoded_size(*sample)); };
}

void* SampleType::createData() { return new Cargo; }

void SampleType::deleteData(void* data) { delete static_cast<Cargo*>(data); }

bool SampleType::getKey(void* data, InstanceHandle_t* handle, bool force_md5) {
  const wire::SampleHeader& header = header_of(*static_cast<const Cargo*>(data));
  std::array<std::uint8_t, 16> key{};  // big-endian, filled up with zeros (RTPS 2.3, 9.6.3.8)
  std::size_t at = 0;
  for (const std::uint32_t part : {header.origin, header.instance, header.destination}) {
    for (int shift = 24; shift >= 0; shift -= 8) {
      key[at++] = static_cast<std::uint8_t>(part >> shift);
    }
  }
  if (force_md5) {
    MD5 digest;
    digest.init();
    digest.update(key.data(), static_cast<unsigned int>(at));
    digest.finalize();
    std::copy_n(digest.digest, key.size(), key.begin());
  }
  eprosima::fastrtps::rtps::octet* const out = handle->value;
  std::copy(key.begin(), key.end(), out);
  return true;
}

}  // namespace skein::blackboard::fastdds
