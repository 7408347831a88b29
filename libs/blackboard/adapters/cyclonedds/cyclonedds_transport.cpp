// SPDX-License-Identifier: Apache-2.0
// Domain, participant and channels over Cyclone DDS.
#include "skein/blackboard/cyclonedds_transport.hpp"

#include <dds/dds.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "adapters/rtps/kept_samples.hpp"
#include "adapters/rtps/mailbox.hpp"
#include "adapters/rtps/participant_number.hpp"
#include "adapters/rtps/ports.hpp"
#include "middleware_log.hpp"
#include "qos.hpp"
#include "reader_listener.hpp"
#include "sample_type.hpp"
#include "settings.hpp"
#include "skein/blackboard/program_description.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::blackboard {
namespace {

using cyclonedds::ReaderListener;

/// How long the end of a node may be held up by those who have not yet got its last words.
constexpr std::chrono::milliseconds kLastWords{2000};

/// Of the domains within this process; what is on the network is set apart (ExternalDomainId).
dds_domainid_t next_domain() {
  static std::atomic<dds_domainid_t> last{0};
  return ++last;
}

std::string reason(dds_return_t code) { return dds_strretcode(code); }

}  // namespace

class CycloneDdsTransport::Impl {
 public:
  explicit Impl(DdsConfig config)
      : config_(std::move(config)), log_(id_, [this](const std::string& line) { say(line); }) {}
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl();

  Result<void, Failure> open(const TransportPlan& plan);
  bool write(std::size_t channel, const wire::Sample& sample);
  Result<void, Failure> set_up(std::size_t channel, bool up);
  rtps::Mailbox& mailbox() { return mailbox_; }

 private:
  struct Topic {
    dds_entity_t entity = 0;
    const ddsi_sertype* type = nullptr;  ///< of the domain
  };
  /// While it is cut a channel has no endpoints: Cyclone cannot move them to another partition.
  struct Channel {
    ChannelConfig config;
    std::vector<wire::Slot> writes, reads;
    bool up = true;
    dds_entity_t publisher = 0;
    dds_entity_t subscriber = 0;
    std::array<dds_entity_t, wire::kSlotCount> writers{};
    std::map<wire::Slot, ReaderListener> listeners;
    rtps::KeptSamples kept;
  };

  void say(const std::string& line);
  void flush_world();
  Result<void, Failure> join();
  Result<void, Failure> open_channel(std::size_t index, const TransportPlan& plan);
  /// What of its endpoints is missing. What could not be made leaves the others.
  Result<void, Failure> make_endpoints(Channel& channel);
  dds_return_t make_writers(Channel& channel);
  dds_return_t make_readers(Channel& channel);
  Result<void, Failure> delete_endpoints(Channel& channel);
  bool write(const Channel& channel, const wire::Sample& sample);
  Topic& topic(wire::Slot slot);

  const dds_domainid_t id_ = next_domain();
  DdsConfig config_;
  std::mutex said_mutex_;
  std::string said_;  ///< by Cyclone of its start
  cyclonedds::MiddlewareLog log_;
  std::optional<rtps::ParticipantNumber> number_;
  rtps::Mailbox mailbox_;
  dds_entity_t domain_ = 0;  ///< owns all other entities
  dds_entity_t participant_ = 0;
  std::map<wire::Slot, Topic> topics_;
  std::vector<Channel> channels_;
};

CycloneDdsTransport::Impl::~Impl() {
  flush_world();
  if (domain_ > 0) dds_delete(domain_);
}

void CycloneDdsTransport::Impl::say(const std::string& line) {
  if (config_.log) config_.log(line);
  const std::lock_guard lock(said_mutex_);
  if (participant_ <= 0) said_ += (said_.empty() ? "" : "; ") + line;
}

/// On the world channel no session makes good what a writer takes with it: waits, within bounds,
/// until everybody has got it.
void CycloneDdsTransport::Impl::flush_world() {
  const auto until = std::chrono::steady_clock::now() + kLastWords;
  for (const Channel& channel : channels_) {
    if (channel.config.kind != ChannelKind::kWorld) continue;
    for (const dds_entity_t writer : channel.writers) {
      const std::chrono::nanoseconds left = until - std::chrono::steady_clock::now();
      if (writer > 0 && left.count() > 0) dds_wait_for_acks(writer, left.count());
    }
  }
}

Result<void, Failure> CycloneDdsTransport::Impl::join() {
  const std::string domain = std::to_string(config_.domain);
  number_ = rtps::ParticipantNumber::claim(config_.domain);
  if (!number_) return failure("too many DDS participants in domain " + domain);
  domain_ = dds_create_domain(id_, cyclonedds::settings(config_, number_->value()).c_str());
  dds_entity_t participant = domain_;
  if (domain_ > 0) {
    const cyclonedds::Qos qos(dds_create_qos());
    dds_qset_entity_name(qos.get(), config_.participant_name.c_str());
    const std::string description = to_text(program_description());
    dds_qset_userdata(qos.get(), description.data(), description.size());
    participant = dds_create_participant(id_, qos.get(), nullptr);
  }
  const std::lock_guard lock(said_mutex_);
  participant_ = participant;
  if (participant > 0) return {};
  return failure("no Cyclone DDS participant in domain " + domain + ": " +
                 (said_.empty() ? reason(participant) : said_));
}

Result<void, Failure> CycloneDdsTransport::Impl::open(const TransportPlan& plan) {
  SKEIN_EXPECTS(domain_ == 0);
  if (auto checked = rtps::check(config_.network); !checked) return checked;
  if (auto joined = join(); !joined) return joined;
  channels_.resize(plan.channels.size());
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    if (auto opened = open_channel(i, plan); !opened) return opened;
  }
  return {};
}

Result<void, Failure> CycloneDdsTransport::Impl::open_channel(std::size_t index,
                                                              const TransportPlan& plan) {
  Channel& channel = channels_[index];
  channel.config = plan.channels[index];
  const bool world = channel.config.kind == ChannelKind::kWorld;
  std::vector<wire::Slot> slots = channel.config.slots;
  if (!world) slots.push_back(wire::Slot::kHeartbeat);
  if (world || channel.config.from == plan.self) channel.writes = slots;
  if (world || channel.config.from != plan.self) channel.reads = world ? plan.world_reads : slots;
  for (const wire::Slot slot : channel.reads) {
    channel.listeners.try_emplace(slot, mailbox_, index, slot, config_.tap);
  }
  return make_endpoints(channel);
}

Result<void, Failure> CycloneDdsTransport::Impl::make_endpoints(Channel& channel) {
  dds_return_t made = make_writers(channel);
  if (made >= 0) made = make_readers(channel);
  if (made >= 0) return {};
  return failure("Cyclone DDS refuses the endpoints of channel " + channel.config.partition + ": " +
                 reason(made));
}

dds_return_t CycloneDdsTransport::Impl::make_writers(Channel& channel) {
  if (channel.writes.empty() || channel.publisher > 0) return DDS_RETCODE_OK;
  channel.publisher = dds_create_publisher(
      participant_, cyclonedds::partition_qos(channel.config.partition).get(), nullptr);
  if (channel.publisher < 0) return channel.publisher;
  for (const wire::Slot slot : channel.writes) {
    const dds_entity_t on = topic(slot).entity;
    if (on < 0) return on;
    const dds_entity_t writer = dds_create_writer(
        channel.publisher, on, cyclonedds::writer_qos(slot, channel.config.kind).get(), nullptr);
    if (writer < 0) return writer;
    channel.writers[static_cast<std::size_t>(slot)] = writer;
  }
  return DDS_RETCODE_OK;
}

dds_return_t CycloneDdsTransport::Impl::make_readers(Channel& channel) {
  if (channel.reads.empty() || channel.subscriber > 0) return DDS_RETCODE_OK;
  channel.subscriber = dds_create_subscriber(
      participant_, cyclonedds::partition_qos(channel.config.partition).get(), nullptr);
  if (channel.subscriber < 0) return channel.subscriber;
  for (auto& [slot, listener] : channel.listeners) {
    const dds_entity_t on = topic(slot).entity;
    if (on < 0) return on;
    const dds_entity_t reader = listener.make_reader(
        channel.subscriber, on, *cyclonedds::reader_qos(slot, channel.config.kind));
    if (reader < 0) return reader;
  }
  return DDS_RETCODE_OK;
}

Result<void, Failure> CycloneDdsTransport::Impl::delete_endpoints(Channel& channel) {
  channel.writers.fill(0);
  dds_return_t worst = DDS_RETCODE_OK;
  for (dds_entity_t* const owner : {&channel.publisher, &channel.subscriber}) {
    if (*owner > 0) worst = std::min(worst, dds_delete(*owner));
    *owner = 0;
  }
  if (worst == DDS_RETCODE_OK) return {};
  return failure("Cyclone DDS does not delete the endpoints of channel " +
                 channel.config.partition + ": " + reason(worst));
}

CycloneDdsTransport::Impl::Topic& CycloneDdsTransport::Impl::topic(wire::Slot slot) {
  Topic& topic = topics_[slot];
  if (topic.entity > 0) return topic;
  ddsi_sertype* type = cyclonedds::make_sample_type(slot);
  const std::string name(wire::slot_name(slot));
  topic.entity =
      dds_create_topic_sertype(participant_, name.c_str(), &type, nullptr, nullptr, nullptr);
  if (topic.entity > 0) {
    topic.type = type;  // the one of the domain
  } else {
    ddsi_sertype_unref(type);
  }
  return topic;
}

bool CycloneDdsTransport::Impl::write(std::size_t index, const wire::Sample& sample) {
  Channel& channel = channels_.at(index);
  if (channel.config.kind != ChannelKind::kWorld) {  // which is never cut
    channel.kept.keep(sample, rtps::KeptSamples::Clock::now());
  }
  return !channel.up || write(channel, sample);
}

bool CycloneDdsTransport::Impl::write(const Channel& channel, const wire::Sample& sample) {
  const wire::Slot slot = wire::slot_of(sample);
  const dds_entity_t writer = channel.writers[static_cast<std::size_t>(slot)];
  if (writer <= 0) return false;  // could not be made
  ddsi_serdata* const data = cyclonedds::make_outgoing(*topics_.at(slot).type, sample);
  return dds_writecdr(writer, data) == DDS_RETCODE_OK;
}

Result<void, Failure> CycloneDdsTransport::Impl::set_up(std::size_t index, bool up) {
  Channel& channel = channels_.at(index);
  if (!up) {
    channel.up = false;
    return delete_endpoints(channel);
  }
  if (auto made = make_endpoints(channel); !made) {
    (void)delete_endpoints(channel);  // whole or not at all
    return made;
  }
  if (channel.up) return {};
  std::size_t refused = 0;
  channel.kept.for_each(rtps::KeptSamples::Clock::now(), [&](const wire::Sample& sample) {
    refused += write(channel, sample) ? 0 : 1;
  });
  channel.up = refused == 0;
  if (channel.up) return {};
  (void)delete_endpoints(channel);
  return failure("Cyclone DDS does not take " + std::to_string(refused) + " samples of channel " +
                 channel.config.partition);
}

CycloneDdsTransport::CycloneDdsTransport(DdsConfig config)
    : impl_(std::make_unique<Impl>(std::move(config))) {}

CycloneDdsTransport::~CycloneDdsTransport() = default;

Result<void, Failure> CycloneDdsTransport::open(const TransportPlan& plan) {
  return impl_->open(plan);
}

bool CycloneDdsTransport::write(std::size_t channel, const wire::Sample& sample) {
  return impl_->write(channel, sample);
}

Result<void, Failure> CycloneDdsTransport::set_up(std::size_t channel, bool up) {
  return impl_->set_up(channel, up);
}

std::vector<Arrival> CycloneDdsTransport::take() { return impl_->mailbox().take(); }

void CycloneDdsTransport::on_arrival(std::function<void()> notify) {
  impl_->mailbox().on_arrival(std::move(notify));
}

}  // namespace skein::blackboard
