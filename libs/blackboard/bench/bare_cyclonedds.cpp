// SPDX-License-Identifier: Apache-2.0
// Request, reply and stream over bare Cyclone DDS, with the types that idlc generates.
#include <cyclone/event.h>
#include <cyclone/stream.h>
#include <dds/dds.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "adapters/cyclonedds/qos.hpp"
#include "adapters/cyclonedds/settings.hpp"
#include "bare_pair.hpp"

namespace skein::blackboard::bench {
namespace {

constexpr dds_domainid_t kWithinProcess = 9000;  // clear of the blackboard's

dds_entity_t made(dds_entity_t entity) {
  if (entity < 0) std::abort();
  return entity;
}

class CycloneSide final : public BareSide {
 public:
  CycloneSide(std::uint32_t domain, Role role) : asks_(role == Role::kAsks) {
    DdsConfig config;
    config.domain = domain;
    domain_ = made(
        dds_create_domain(kWithinProcess, cyclonedds::settings(config, bare_number(role)).c_str()));
    participant_ = made(dds_create_participant(kWithinProcess, nullptr, nullptr));
    const dds_entity_t request = topic(skein_idl_TaskRequest_desc, wire::Slot::kTaskRequest);
    const dds_entity_t reply = topic(skein_idl_RequestReply_desc, wire::Slot::kRequestReply);
    const auto partition = cyclonedds::partition_qos("bench/bare");
    const auto slot = wire::Slot::kTaskRequest;  // of the same class as the reply
    writer_ = made(dds_create_writer(
        made(dds_create_publisher(participant_, partition.get(), nullptr)), asks_ ? request : reply,
        cyclonedds::writer_qos(slot, ChannelKind::kRadio).get(), nullptr));
    const std::unique_ptr<dds_listener_t, decltype(&dds_delete_listener)> listener(
        dds_create_listener(this), &dds_delete_listener);
    dds_lset_data_available(listener.get(), [](dds_entity_t reader, void* self) {
      static_cast<CycloneSide*>(self)->take_all(reader);
    });
    made(dds_create_reader(made(dds_create_subscriber(participant_, partition.get(), nullptr)),
                           asks_ ? reply : request,
                           cyclonedds::reader_qos(slot, ChannelKind::kRadio).get(),
                           listener.get()));
  }
  ~CycloneSide() override { dds_delete(domain_); }

  bool ask(std::uint64_t command) override {
    std::array<double, 3> numbers{100.0, 200.0, 50.0};
    skein_idl_Parameter to{};
    to.name = const_cast<char*>("to");
    to.text = const_cast<char*>("");
    to.numbers._length = to.numbers._maximum = 3;
    to.numbers._buffer = numbers.data();
    skein_idl_TaskRequest request{};
    request.parent.origin = 1;
    request.command = command;
    request.task.id = command;
    request.task.type = const_cast<char*>("goto");
    request.task.parameters._length = request.task.parameters._maximum = 1;
    request.task.parameters._buffer = &to;
    return dds_write(writer_, &request) == DDS_RETCODE_OK && wait() == command;
  }
  void serve() override {
    while (true) {
      const std::uint64_t command = wait();
      if (command == 0) continue;
      skein_idl_RequestReply reply{};
      reply.parent.origin = 2;
      reply.command = command;
      reply.accepted = true;
      dds_write(writer_, &reply);
    }
  }

 private:
  dds_entity_t topic(const dds_topic_descriptor_t& type, wire::Slot slot) const {
    const std::string name(wire::slot_name(slot));
    return made(dds_create_topic(participant_, &type, name.c_str(), nullptr, nullptr));
  }
  void take_all(dds_entity_t reader) {
    std::array<void*, 1> sample{};
    dds_sample_info_t info;
    while (dds_take(reader, sample.data(), &info, 1, 1) > 0) {
      const std::uint64_t command = asks_ ? static_cast<skein_idl_RequestReply*>(sample[0])->command
                                          : static_cast<skein_idl_TaskRequest*>(sample[0])->command;
      dds_return_loan(reader, sample.data(), 1);
      if (!info.valid_data) continue;
      const std::lock_guard lock(mutex_);
      came_ = command;
      wake_.notify_one();
    }
  }
  /// The command of what came; 0 if nothing comes within 5 s.
  std::uint64_t wait() {
    std::unique_lock lock(mutex_);
    wake_.wait_for(lock, std::chrono::seconds(5), [this] { return came_ != 0; });
    return std::exchange(came_, 0);
  }

  bool asks_;
  dds_entity_t domain_ = 0;
  dds_entity_t participant_ = 0;
  dds_entity_t writer_ = 0;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::uint64_t came_ = 0;
};

class CycloneStream final : public BareStream {
 public:
  CycloneStream(std::uint32_t domain, Role role) {
    DdsConfig config;
    config.domain = domain;
    const std::uint32_t number =
        bare_number(role == Role::kWrites ? BareSide::Role::kAsks : BareSide::Role::kAnswers);
    domain_ = made(dds_create_domain(kWithinProcess, cyclonedds::settings(config, number).c_str()));
    const dds_entity_t participant = made(dds_create_participant(kWithinProcess, nullptr, nullptr));
    const dds_entity_t topic = made(
        dds_create_topic(participant, &skein_idl_Telemetry_desc, "Telemetry", nullptr, nullptr));
    const auto partition = cyclonedds::partition_qos("bench/bare");
    if (role == Role::kWrites) {
      writer_ = made(dds_create_writer(
          made(dds_create_publisher(participant, partition.get(), nullptr)), topic,
          cyclonedds::writer_qos(wire::Slot::kTelemetry, ChannelKind::kRadio).get(), nullptr));
      return;
    }
    const std::unique_ptr<dds_listener_t, decltype(&dds_delete_listener)> listener(
        dds_create_listener(this), &dds_delete_listener);
    dds_lset_data_available(listener.get(), [](dds_entity_t reader, void* self) {
      std::array<void*, 1> sample{};
      dds_sample_info_t info;
      while (dds_take(reader, sample.data(), &info, 1, 1) > 0) {
        if (info.valid_data) ++static_cast<CycloneStream*>(self)->taken_;
        dds_return_loan(reader, sample.data(), 1);
      }
    });
    made(dds_create_reader(
        made(dds_create_subscriber(participant, partition.get(), nullptr)), topic,
        cyclonedds::reader_qos(wire::Slot::kTelemetry, ChannelKind::kRadio).get(), listener.get()));
  }
  ~CycloneStream() override { dds_delete(domain_); }

  bool write(std::uint64_t sequence) override {
    skein_idl_Telemetry telemetry{};
    telemetry.parent.origin = 1;
    telemetry.parent.sequence_number = sequence;
    telemetry.uav = const_cast<char*>("asker");
    telemetry.activity = const_cast<char*>("flying");
    return dds_write(writer_, &telemetry) == DDS_RETCODE_OK;
  }
  std::uint64_t taken() const override { return taken_; }

 private:
  dds_entity_t domain_ = 0;
  dds_entity_t writer_ = 0;
  std::atomic<std::uint64_t> taken_{0};
};

}  // namespace

std::unique_ptr<BareStream> make_bare_cyclonedds_stream(std::uint32_t domain,
                                                        BareStream::Role role) {
  return std::make_unique<CycloneStream>(domain, role);
}

std::unique_ptr<BareSide> make_bare_cyclonedds_side(std::uint32_t domain, BareSide::Role role) {
  return std::make_unique<CycloneSide>(domain, role);
}

}  // namespace skein::blackboard::bench
