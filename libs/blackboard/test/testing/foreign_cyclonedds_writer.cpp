// SPDX-License-Identifier: Apache-2.0
// A foreign writer over Cyclone DDS.
#include <dds/dds.h>

#include <stdexcept>

#include "adapters/cyclonedds/qos.hpp"
#include "adapters/cyclonedds/sample_type.hpp"
#include "adapters/cyclonedds/settings.hpp"
#include "testing/foreign_writer.hpp"

namespace skein::blackboard::testing {
namespace {

constexpr dds_domainid_t kWithinProcess = 9000;  // out of the way of the blackboard's

class CycloneWriter final : public ForeignWriter {
 public:
  explicit CycloneWriter(const ForeignTopic& topic) {
    DdsConfig config;
    config.domain = topic.domain;
    const std::uint32_t number = next_foreign_number();
    const dds_domainid_t id = kWithinProcess + number;
    domain_ = made(dds_create_domain(id, cyclonedds::settings(config, number).c_str()));
    const dds_entity_t participant = made(dds_create_participant(id, nullptr, nullptr));
    type_ = cyclonedds::make_sample_type(topic.type);
    const std::string name(wire::slot_name(topic.name));
    const dds_entity_t on = made(
        dds_create_topic_sertype(participant, name.c_str(), &type_, nullptr, nullptr, nullptr));
    const dds_entity_t publisher = made(dds_create_publisher(
        participant, cyclonedds::partition_qos(topic.partition).get(), nullptr));
    writer_ = made(dds_create_writer(
        publisher, on, cyclonedds::writer_qos(topic.name, ChannelKind::kRadio).get(), nullptr));
  }
  ~CycloneWriter() override { dds_delete(domain_); }

  bool write(const Bytes& bytes) override {
    ddsrt_iovec_t piece{};
    piece.iov_base = const_cast<std::uint8_t*>(bytes.data());
    piece.iov_len = bytes.size();
    ddsi_serdata* const data = ddsi_serdata_from_ser_iov(type_, SDK_DATA, 1, &piece, bytes.size());
    return dds_writecdr(writer_, data) == DDS_RETCODE_OK;
  }

 private:
  static dds_entity_t made(dds_entity_t entity) {
    if (entity < 0) throw std::runtime_error(dds_strretcode(entity));
    return entity;
  }

  dds_entity_t domain_;
  ddsi_sertype* type_ = nullptr;
  dds_entity_t writer_ = 0;
};

}  // namespace

std::unique_ptr<ForeignWriter> make_foreign_cyclonedds_writer(const ForeignTopic& topic) {
  return std::make_unique<CycloneWriter>(topic);
}

}  // namespace skein::blackboard::testing
