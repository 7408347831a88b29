// SPDX-License-Identifier: Apache-2.0
// Participant, channels and mailbox over Fast DDS.
#include "skein/blackboard/fastdds_transport.hpp"

#include <fastrtps/xmlparser/XMLProfileManager.h>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <mutex>
#include <optional>

#include "adapters/rtps/kept_samples.hpp"
#include "adapters/rtps/mailbox.hpp"
#include "adapters/rtps/participant_number.hpp"
#include "adapters/rtps/ports.hpp"
#include "middleware_log.hpp"
#include "qos.hpp"
#include "sample_type.hpp"
#include "security.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::blackboard {
namespace {

namespace dds = eprosima::fastdds::dds;
using eprosima::fastrtps::types::ReturnCode_t;
using fastdds::Cargo;

/// How long the end of a node may be held up by those who have not yet got its last words.
constexpr std::chrono::milliseconds kLastWords{2000};

/// Where writers are, as they say when they are found.
class Partitions final : public dds::DomainParticipantListener {
 public:
  void on_publisher_discovery(dds::DomainParticipant* /*participant*/,
                              eprosima::fastrtps::rtps::WriterDiscoveryInfo&& found) override {
    const std::vector<std::string> names = found.info.m_qos.m_partition.names();
    const std::lock_guard lock(mutex_);
    of_[found.info.guid()] = names.empty() ? "" : names.front();
  }
  std::string of(const eprosima::fastrtps::rtps::GUID_t& writer) const {
    const std::lock_guard lock(mutex_);
    const auto found = of_.find(writer);
    return found == of_.end() ? "" : found->second;
  }

 private:
  mutable std::mutex mutex_;
  std::map<eprosima::fastrtps::rtps::GUID_t, std::string> of_;
};

/// Takes what a reader has, at once, in the middleware's thread.
class Listener final : public dds::DataReaderListener {
 public:
  /// `identities`: of a secured domain, else null. All references outlive it.
  Listener(rtps::Mailbox& mailbox, std::size_t channel, ChannelConfig channel_config,
           NodeNumber self, const fastdds::Identities* identities, const DdsConfig& config,
           const Partitions& partitions)
      : mailbox_(mailbox),
        channel_(channel),
        config_(std::move(channel_config)),
        self_(self.value()),
        identities_(identities),
        names_(config.names),
        tap_(config.tap),
        partitions_(partitions) {}

  void on_data_available(dds::DataReader* reader) override {
    bool any = false;
    Cargo cargo;
    dds::SampleInfo info;
    while (reader->take_next_sample(&cargo, &info) == ReturnCode_t::RETCODE_OK) {
      if (!info.valid_data || is_own(cargo)) continue;
      if (tap_) tell_tap(cargo, info);
      check_writer(cargo, info);
      mailbox_.put({channel_, std::move(cargo.incoming)});
      any = true;
    }
    if (any) mailbox_.notify();
  }

 private:
  void tell_tap(const Cargo& cargo, const dds::SampleInfo& info) const {
    const auto* sample = std::get_if<wire::Sample>(&cargo.incoming);
    const wire::Slot slot =
        sample != nullptr ? wire::slot_of(*sample) : std::get<Malformed>(cargo.incoming).slot;
    tap_({slot, partitions_.of(info.sample_identity.writer_guid()), info.source_timestamp.to_ns(),
          cargo.bytes});
  }

  /// Who made it, or who may pass it on for him (docs/threats.md).
  bool is_entitled(const wire::Sample& sample, const std::string& origin,
                   const eprosima::fastrtps::rtps::GuidPrefix_t& writer) const {
    if (identities_->confirm(origin, writer)) return true;
    const auto relay = names_.find(config_.from);
    return config_.relays(wire::slot_of(sample)) && relay != names_.end() &&
           identities_->confirm(relay->second, writer);
  }

  /// The header of a forged sample is all zero: it has no place in the session of him it names.
  void check_writer(Cargo& cargo, const dds::SampleInfo& info) const {
    const auto* sample = std::get_if<wire::Sample>(&cargo.incoming);
    if (identities_ == nullptr || sample == nullptr) return;
    const auto named = names_.find(NodeNumber(wire::header_of(*sample).origin));
    const auto& writer = info.sample_identity.writer_guid().guidPrefix;
    if (named != names_.end() && is_entitled(*sample, named->second, writer)) return;
    const std::string name = named == names_.end() ? "a stranger" : named->second;
    cargo.incoming =
        Malformed{wire::slot_of(*sample), {}, {"header.origin", name + " did not write this"}};
  }

  /// Where a partition is shared, our readers also match our own writers.
  bool is_own(const Cargo& cargo) const {
    const auto* sample = std::get_if<wire::Sample>(&cargo.incoming);
    return sample != nullptr && wire::header_of(*sample).origin == self_;
  }

  rtps::Mailbox& mailbox_;
  std::size_t channel_;
  ChannelConfig config_;
  std::uint32_t self_;
  const fastdds::Identities* identities_;
  const std::map<NodeNumber, std::string>& names_;
  const std::function<void(const RawSample&)>& tap_;
  const Partitions& partitions_;
};

/// No profile file on the way to a participant may change what this process does.
dds::DomainParticipantFactory& factory() {
  auto* const the_one = dds::DomainParticipantFactory::get_instance();
  static std::once_flag once;
  std::call_once(once, [&] {
    the_one->load_profiles();
    the_one->set_qos(dds::DomainParticipantFactoryQos{});
    // Two participants of one process use the network like any others.
    eprosima::fastrtps::LibrarySettingsAttributes settings;
    settings.intraprocess_delivery = eprosima::fastrtps::INTRAPROCESS_OFF;
    eprosima::fastrtps::xmlparser::XMLProfileManager::library_settings(settings);
  });
  return *the_one;
}

}  // namespace

class FastDdsTransport::Impl {
 public:
  explicit Impl(DdsConfig config) : config_(std::move(config)), log_(config_.log) {}
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl();

  Result<void, Failure> open(const TransportPlan& plan);
  bool write(std::size_t channel, const wire::Sample& sample);
  Result<void, Failure> set_up(std::size_t channel, bool up);
  rtps::Mailbox& mailbox() { return mailbox_; }

 private:
  /// While it is cut a channel has no endpoints. They are not moved to another partition: others
  /// (Cyclone DDS) do not follow a writer or reader that moves.
  struct Channel {
    ChannelConfig config;
    std::vector<wire::Slot> writes, reads;
    bool up = true;
    dds::Publisher* publisher = nullptr;  // both owned by the participant
    dds::Subscriber* subscriber = nullptr;
    std::unique_ptr<Listener> listener;
    std::array<dds::DataWriter*, wire::kSlotCount> writers{};
    rtps::KeptSamples kept;
  };

  /// On the world channel no session makes good what a writer takes with it: waits, within bounds,
  /// until everybody has got it.
  void flush_world();
  bool checks_writers() const { return identities_.has_value() && !config_.names.empty(); }
  Result<void, Failure> join();
  Result<void, Failure> open_channel(std::size_t index, const TransportPlan& plan);
  /// What of its endpoints is missing. What could not be made leaves the others.
  Result<void, Failure> make_endpoints(Channel& channel);
  bool make_writers(Channel& channel);
  bool make_readers(Channel& channel);
  Result<void, Failure> delete_endpoints(Channel& channel);
  bool write(const Channel& channel, const wire::Sample& sample);
  bool add_writer(Channel& channel, wire::Slot slot);
  bool add_reader(Channel& channel, wire::Slot slot);
  dds::Topic* topic(wire::Slot slot);

  DdsConfig config_;
  fastdds::MiddlewareLog log_;
  std::optional<rtps::ParticipantNumber> number_;
  std::optional<fastdds::Identities> identities_;  ///< in a secured domain
  rtps::Mailbox mailbox_;
  Partitions partitions_;
  dds::DomainParticipant* participant_ = nullptr;
  std::map<wire::Slot, dds::Topic*> topics_;
  std::vector<Channel> channels_;
};

FastDdsTransport::Impl::~Impl() {
  if (participant_ == nullptr) return;
  flush_world();
  participant_->delete_contained_entities();
  factory().delete_participant(participant_);
}

void FastDdsTransport::Impl::flush_world() {
  const auto until = std::chrono::steady_clock::now() + kLastWords;
  for (const Channel& channel : channels_) {
    if (channel.config.kind != ChannelKind::kWorld) continue;
    for (dds::DataWriter* const writer : channel.writers) {
      const std::chrono::nanoseconds left = until - std::chrono::steady_clock::now();
      if (writer == nullptr || left.count() <= 0) continue;
      writer->wait_for_acknowledgments({static_cast<std::int32_t>(left.count() / 1'000'000'000),
                                        static_cast<std::uint32_t>(left.count() % 1'000'000'000)});
    }
  }
}

Result<void, Failure> FastDdsTransport::Impl::join() {
  const std::string domain = std::to_string(config_.domain);
  const std::string& keys = config_.network.keys;
  number_ = rtps::ParticipantNumber::claim(config_.domain);
  if (!number_) return failure("too many DDS participants in domain " + domain);
  dds::DomainParticipantQos qos = fastdds::participant_qos(config_, number_->value());
  if (!keys.empty()) {
    auto security = fastdds::security_properties(keys);
    if (!security) return tl::unexpected(security.error());
    qos.properties() = *security;
    auto identities = fastdds::Identities::read(keys);
    if (!identities) return tl::unexpected(identities.error());
    identities_ = std::move(*identities);
  }
  participant_ = factory().create_participant(
      config_.domain, qos, config_.tap ? &partitions_ : nullptr, dds::StatusMask::none());
  if (participant_ != nullptr) return {};
  return failure("no DDS participant in domain " + domain +
                 (keys.empty() ? " (no such interface, or its ports are taken?)"
                               : ": Fast DDS refuses the keys in " + keys));
}

Result<void, Failure> FastDdsTransport::Impl::open(const TransportPlan& plan) {
  SKEIN_EXPECTS(participant_ == nullptr);
  if (auto checked = rtps::check(config_.network); !checked) return checked;
  if (auto joined = join(); !joined) return joined;
  channels_.resize(plan.channels.size());
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    if (auto opened = open_channel(i, plan); !opened) return opened;
  }
  return {};
}

Result<void, Failure> FastDdsTransport::Impl::open_channel(std::size_t index,
                                                           const TransportPlan& plan) {
  Channel& channel = channels_[index];
  channel.config = plan.channels[index];
  const bool world = channel.config.kind == ChannelKind::kWorld;
  std::vector<wire::Slot> slots = channel.config.slots;
  if (!world) slots.push_back(wire::Slot::kHeartbeat);
  if (world || channel.config.from == plan.self) channel.writes = slots;
  if (world || channel.config.from != plan.self) channel.reads = world ? plan.world_reads : slots;
  channel.listener =
      std::make_unique<Listener>(mailbox_, index, channel.config, plan.self,
                                 checks_writers() ? &*identities_ : nullptr, config_, partitions_);
  return make_endpoints(channel);
}

Result<void, Failure> FastDdsTransport::Impl::make_endpoints(Channel& channel) {
  if (make_writers(channel) && make_readers(channel)) return {};
  return failure(
      "Fast DDS refuses the endpoints of channel " + channel.config.partition +
      (identities_ ? ": the permissions in " + config_.network.keys + " do not allow them" : ""));
}

bool FastDdsTransport::Impl::make_writers(Channel& channel) {
  if (channel.writes.empty() || channel.publisher != nullptr) return true;
  dds::PublisherQos qos;
  qos.partition().push_back(channel.config.partition.c_str());
  channel.publisher = participant_->create_publisher(qos, nullptr, dds::StatusMask::none());
  return channel.publisher != nullptr && std::ranges::all_of(channel.writes, [&](wire::Slot slot) {
           return add_writer(channel, slot);
         });
}

bool FastDdsTransport::Impl::make_readers(Channel& channel) {
  if (channel.reads.empty() || channel.subscriber != nullptr) return true;
  dds::SubscriberQos qos;
  qos.partition().push_back(channel.config.partition.c_str());
  channel.subscriber = participant_->create_subscriber(qos, nullptr, dds::StatusMask::none());
  return channel.subscriber != nullptr && std::ranges::all_of(channel.reads, [&](wire::Slot slot) {
           return add_reader(channel, slot);
         });
}

Result<void, Failure> FastDdsTransport::Impl::delete_endpoints(Channel& channel) {
  constexpr auto kOk = ReturnCode_t::RETCODE_OK;
  bool good = true;
  channel.writers.fill(nullptr);
  if (channel.publisher != nullptr) {
    good = channel.publisher->delete_contained_entities() == kOk &&
           participant_->delete_publisher(channel.publisher) == kOk;
    channel.publisher = nullptr;
  }
  if (channel.subscriber != nullptr) {
    good = channel.subscriber->delete_contained_entities() == kOk &&
           participant_->delete_subscriber(channel.subscriber) == kOk && good;
    channel.subscriber = nullptr;
  }
  if (good) return {};
  return failure("Fast DDS does not delete the endpoints of channel " + channel.config.partition);
}

dds::Topic* FastDdsTransport::Impl::topic(wire::Slot slot) {
  dds::Topic*& topic = topics_[slot];
  if (topic == nullptr) {
    const dds::TypeSupport type(new fastdds::SampleType(slot, static_cast<bool>(config_.tap)));
    if (type.register_type(participant_) != ReturnCode_t::RETCODE_OK) return nullptr;
    topic = participant_->create_topic(std::string(wire::slot_name(slot)), type.get_type_name(),
                                       dds::TopicQos{}, nullptr, dds::StatusMask::none());
  }
  return topic;
}

bool FastDdsTransport::Impl::add_writer(Channel& channel, wire::Slot slot) {
  dds::Topic* const on = topic(slot);
  if (on == nullptr) return false;
  auto*& writer = channel.writers[static_cast<std::size_t>(slot)];
  writer = channel.publisher->create_datawriter(on, fastdds::writer_qos(slot, channel.config.kind),
                                                nullptr, dds::StatusMask::none());
  return writer != nullptr;
}

bool FastDdsTransport::Impl::add_reader(Channel& channel, wire::Slot slot) {
  dds::Topic* const on = topic(slot);
  if (on == nullptr) return false;
  return channel.subscriber->create_datareader(on, fastdds::reader_qos(slot, channel.config.kind),
                                               channel.listener.get(),
                                               dds::StatusMask::data_available()) != nullptr;
}

bool FastDdsTransport::Impl::write(std::size_t index, const wire::Sample& sample) {
  Channel& channel = channels_.at(index);
  if (channel.config.kind != ChannelKind::kWorld) {  // which is never cut
    channel.kept.keep(sample, rtps::KeptSamples::Clock::now());
  }
  return !channel.up || write(channel, sample);
}

bool FastDdsTransport::Impl::write(const Channel& channel, const wire::Sample& sample) {
  auto* const writer = channel.writers[static_cast<std::size_t>(wire::slot_of(sample))];
  if (writer == nullptr) return false;  // could not be made
  Cargo cargo;
  cargo.outgoing = &sample;
  return writer->write(&cargo);
}

Result<void, Failure> FastDdsTransport::Impl::set_up(std::size_t index, bool up) {
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
  return failure("Fast DDS does not take " + std::to_string(refused) + " samples of channel " +
                 channel.config.partition);
}

FastDdsTransport::FastDdsTransport(DdsConfig config)
    : impl_(std::make_unique<Impl>(std::move(config))) {}

FastDdsTransport::~FastDdsTransport() = default;

Result<void, Failure> FastDdsTransport::open(const TransportPlan& plan) {
  return impl_->open(plan);
}

bool FastDdsTransport::write(std::size_t channel, const wire::Sample& sample) {
  return impl_->write(channel, sample);
}

Result<void, Failure> FastDdsTransport::set_up(std::size_t channel, bool up) {
  return impl_->set_up(channel, up);
}

std::vector<Arrival> FastDdsTransport::take() { return impl_->mailbox().take(); }

void FastDdsTransport::on_arrival(std::function<void()> notify) {
  impl_->mailbox().on_arrival(std::move(notify));
}

}  // namespace skein::blackboard
