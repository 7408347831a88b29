// SPDX-License-Identifier: Apache-2.0
// A foreign writer over Fast DDS.
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>

#include <algorithm>

#include "adapters/fastdds/qos.hpp"
#include "testing/foreign_writer.hpp"

namespace skein::blackboard::testing {
namespace {

namespace dds = eprosima::fastdds::dds;
using eprosima::fastrtps::rtps::InstanceHandle_t;
using eprosima::fastrtps::rtps::SerializedPayload_t;

/// Samples are Bytes; the key is what they have where the key should be.
class BytesType final : public dds::TopicDataType {
 public:
  explicit BytesType(wire::Slot slot) {
    setName(("skein::idl::" + std::string(wire::slot_name(slot))).c_str());
    m_typeSize = 64;
    m_isGetKeyDefined = true;
    auto_fill_type_object(false);
    auto_fill_type_information(false);
  }
  bool serialize(void* data, SerializedPayload_t* payload) override {
    const auto& bytes = *static_cast<const Bytes*>(data);
    if (bytes.size() > payload->max_size) return false;
    std::ranges::copy(bytes, payload->data);
    payload->length = static_cast<std::uint32_t>(bytes.size());
    return true;
  }
  bool deserialize(SerializedPayload_t*, void*) override { return true; }
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
    return [data] { return static_cast<std::uint32_t>(static_cast<Bytes*>(data)->size()); };
  }
  void* createData() override { return new Bytes; }
  void deleteData(void* data) override { delete static_cast<Bytes*>(data); }
  bool getKey(void* data, InstanceHandle_t* handle, bool) override {
    const auto& bytes = *static_cast<const Bytes*>(data);
    eprosima::fastrtps::rtps::octet* const key = handle->value;
    for (std::size_t i = 0; i < 12; ++i) {
      const std::size_t at = 4 + i / 4 * 4 + 3 - i % 4;
      key[i] = at < bytes.size() ? bytes[at] : 0;
    }
    return true;
  }
};

dds::DomainParticipantFactory* factory() { return dds::DomainParticipantFactory::get_instance(); }

class FastWriter final : public ForeignWriter {
 public:
  explicit FastWriter(const ForeignTopic& topic) {
    DdsConfig config;
    config.domain = topic.domain;
    participant_ = factory()->create_participant(
        topic.domain, fastdds::participant_qos(config, next_foreign_number()));
    const dds::TypeSupport type(new BytesType(topic.type));
    type.register_type(participant_);
    dds::Topic* const on = participant_->create_topic(std::string(wire::slot_name(topic.name)),
                                                      type.get_type_name(), dds::TOPIC_QOS_DEFAULT);
    dds::PublisherQos qos;
    qos.partition().push_back(topic.partition.c_str());
    writer_ = participant_->create_publisher(qos)->create_datawriter(
        on, fastdds::writer_qos(topic.name, ChannelKind::kRadio));
  }
  ~FastWriter() override {
    participant_->delete_contained_entities();
    factory()->delete_participant(participant_);
  }
  bool write(const Bytes& bytes) override {
    Bytes copy = bytes;
    return writer_->write(&copy);
  }

 private:
  dds::DomainParticipant* participant_ = nullptr;
  dds::DataWriter* writer_ = nullptr;
};

}  // namespace

std::unique_ptr<ForeignWriter> make_foreign_fastdds_writer(const ForeignTopic& topic) {
  return std::make_unique<FastWriter>(topic);
}

}  // namespace skein::blackboard::testing
