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

#include <array>
#include <chrono>
#include <map>
#include <mutex>
#include <optional>
#include <set>

#include "middleware_log.hpp"
#include "named_lock.hpp"
#include "ports.hpp"
#include "qos.hpp"
#include "sample_type.hpp"
#include "security.hpp"
#include "skein/foundation/contract.hpp"
#include "skein/foundation/joined.hpp"

namespace skein::blackboard {
namespace {

namespace dds = eprosima::fastdds::dds;
using eprosima::fastrtps::types::ReturnCode_t;
using fastdds::Cargo;

/// How long the end of a node may be held up by those who have not yet got its last words.
constexpr std::chrono::milliseconds kLastWords{2000};

/// What listeners of any thread leave and the owner takes.
class Mailbox {
 public:
  void put(Arrival arrival) {
    const std::lock_guard lock(mutex_);
    arrivals_.push_back(std::move(arrival));
  }
  void notify() {
    const std::lock_guard lock(notify_mutex_);
    if (notify_) notify_();
  }
  std::vector<Arrival> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(arrivals_, {});
  }
  void on_arrival(std::function<void()> notify) {
    const std::lock_guard lock(notify_mutex_);
    notify_ = std::move(notify);
  }

 private:
  std::mutex mutex_;
  std::vector<Arrival> arrivals_;
  std::mutex notify_mutex_;  // apart: a notified thread may take at once
  std::function<void()> notify_;
};

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
  Listener(Mailbox& mailbox, std::size_t channel, NodeNumber self,
           const fastdds::Identities* identities, const FastDdsConfig& config,
           const Partitions& partitions)
      : mailbox_(mailbox),
        channel_(channel),
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

  /// The header of a forged sample is all zero: it has no place in the session of him it names.
  void check_writer(Cargo& cargo, const dds::SampleInfo& info) const {
    const auto* sample = std::get_if<wire::Sample>(&cargo.incoming);
    if (identities_ == nullptr || sample == nullptr) return;
    const auto named = names_.find(NodeNumber(wire::header_of(*sample).origin));
    const auto& writer = info.sample_identity.writer_guid().guidPrefix;
    if (named != names_.end() && identities_->confirm(named->second, writer)) return;
    const std::string name = named == names_.end() ? "a stranger" : named->second;
    cargo.incoming =
        Malformed{wire::slot_of(*sample), {}, {"header.origin", name + " did not write this"}};
  }

  /// Where a partition is shared, our readers also match our own writers.
  bool is_own(const Cargo& cargo) const {
    const auto* sample = std::get_if<wire::Sample>(&cargo.incoming);
    return sample != nullptr && wire::header_of(*sample).origin == self_;
  }

  Mailbox& mailbox_;
  std::size_t channel_;
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
  explicit Impl(FastDdsConfig config) : config_(std::move(config)), log_(config_.log) {}
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl();

  Result<void, Failure> open(const TransportPlan& plan);
  bool write(std::size_t channel, const wire::Sample& sample);
  void set_up(std::size_t channel, bool up);
  Mailbox& mailbox() { return mailbox_; }

 private:
  struct Channel {
    ChannelConfig config;
    dds::Publisher* publisher = nullptr;  // both owned by the participant
    dds::Subscriber* subscriber = nullptr;
    std::array<dds::DataWriter*, wire::kSlotCount> writers{};
  };

  /// On the world channel no session makes good what a writer takes with it: waits, within bounds,
  /// until everybody has got it.
  void flush_world();
  Result<void, Failure> check_network() const;
  bool checks_writers() const { return identities_.has_value() && !config_.names.empty(); }
  Result<void, Failure> join();
  /// The smallest number whose ports nobody has; nothing if all are taken.
  std::optional<std::uint32_t> claim_participant_number();
  Result<void, Failure> open_channel(std::size_t index, const TransportPlan& plan);
  bool add_writer(Channel& channel, wire::Slot slot);
  bool add_reader(Channel& channel, wire::Slot slot, Listener& listener);
  dds::Topic* topic(wire::Slot slot);

  FastDdsConfig config_;
  fastdds::MiddlewareLog log_;
  std::optional<fastdds::NamedLock> number_;
  std::optional<fastdds::Identities> identities_;  ///< in a secured domain
  Mailbox mailbox_;
  Partitions partitions_;
  dds::DomainParticipant* participant_ = nullptr;
  std::map<wire::Slot, dds::Topic*> topics_;
  std::vector<Channel> channels_;
  std::vector<std::unique_ptr<Listener>> listeners_;
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

Result<void, Failure> FastDdsTransport::Impl::check_network() const {
  std::vector<std::string> problems = problems_of(config_.network);
  // Fast DDS would take an address that nobody has and then be deaf.
  const std::set<std::string> own = fastdds::own_addresses();
  for (const std::string& address : config_.network.interfaces) {
    if (!own.contains(address)) {
      problems.push_back("no interface that is up has address " + address);
    }
  }
  if (problems.empty()) return {};
  return failure(joined(problems, "; "));
}

Result<void, Failure> FastDdsTransport::Impl::join() {
  const std::string domain = std::to_string(config_.domain);
  const std::string& keys = config_.network.keys;
  const auto number = claim_participant_number();
  if (!number) return failure("too many DDS participants in domain " + domain);
  dds::DomainParticipantQos qos = fastdds::participant_qos(config_, *number);
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
  if (auto checked = check_network(); !checked) return checked;
  if (auto joined = join(); !joined) return joined;
  channels_.resize(plan.channels.size());
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    if (auto opened = open_channel(i, plan); !opened) return opened;
  }
  return {};
}

std::optional<std::uint32_t> FastDdsTransport::Impl::claim_participant_number() {
  for (std::uint32_t number = 0; number < fastdds::kParticipants; ++number) {
    number_ = fastdds::NamedLock::take("skein-dds-participant-" + std::to_string(config_.domain) +
                                       "-" + std::to_string(number));
    if (!number_) continue;
    const auto ports = fastdds::bound_udp_ports();
    const unsigned first = fastdds::first_port(config_.domain, number);
    if (!ports.contains(first) && !ports.contains(first + 1)) return number;
  }
  return std::nullopt;
}

Result<void, Failure> FastDdsTransport::Impl::open_channel(std::size_t index,
                                                           const TransportPlan& plan) {
  Channel& channel = channels_[index];
  channel.config = plan.channels[index];
  const bool world = channel.config.kind == ChannelKind::kWorld;
  std::vector<wire::Slot> slots = channel.config.slots;
  if (!world) slots.push_back(wire::Slot::kHeartbeat);
  bool good = true;
  if (world || channel.config.from == plan.self) {
    dds::PublisherQos qos;
    qos.partition().push_back(channel.config.partition.c_str());
    channel.publisher = participant_->create_publisher(qos, nullptr, dds::StatusMask::none());
    good = channel.publisher != nullptr;
    for (const wire::Slot slot : slots) good = good && add_writer(channel, slot);
  }
  if (world || channel.config.from != plan.self) {
    dds::SubscriberQos qos;
    qos.partition().push_back(channel.config.partition.c_str());
    channel.subscriber = participant_->create_subscriber(qos, nullptr, dds::StatusMask::none());
    good = good && channel.subscriber != nullptr;
    listeners_.push_back(std::make_unique<Listener>(mailbox_, index, plan.self,
                                                    checks_writers() ? &*identities_ : nullptr,
                                                    config_, partitions_));
    for (const wire::Slot slot : world ? plan.world_reads : slots) {
      good = good && add_reader(channel, slot, *listeners_.back());
    }
  }
  if (!good) {
    return failure(
        "DDS refuses the endpoints of channel " + channel.config.partition +
        (identities_ ? ": the permissions in " + config_.network.keys + " do not allow them" : ""));
  }
  return {};
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

bool FastDdsTransport::Impl::add_reader(Channel& channel, wire::Slot slot, Listener& listener) {
  dds::Topic* const on = topic(slot);
  if (on == nullptr) return false;
  return channel.subscriber->create_datareader(on, fastdds::reader_qos(slot, channel.config.kind),
                                               &listener,
                                               dds::StatusMask::data_available()) != nullptr;
}

bool FastDdsTransport::Impl::write(std::size_t channel, const wire::Sample& sample) {
  auto* const writer =
      channels_.at(channel).writers[static_cast<std::size_t>(wire::slot_of(sample))];
  SKEIN_EXPECTS(writer != nullptr);
  Cargo cargo;
  cargo.outgoing = &sample;
  return writer->write(&cargo);
}

void FastDdsTransport::Impl::set_up(std::size_t channel, bool up) {
  const Channel& it = channels_.at(channel);
  const std::string& partition = it.config.partition;
  // The two sides of a cut channel are in different partitions, each alone.
  const auto put = [&](auto qos, auto* entity, const std::string& side) {
    qos.partition().clear();
    qos.partition().push_back((up ? partition : "cut/" + side + "/" + partition).c_str());
    entity->set_qos(qos);
  };
  if (it.publisher != nullptr) put(it.publisher->get_qos(), it.publisher, "out");
  if (it.subscriber != nullptr) put(it.subscriber->get_qos(), it.subscriber, "in");
}

FastDdsTransport::FastDdsTransport(FastDdsConfig config)
    : impl_(std::make_unique<Impl>(std::move(config))) {}

FastDdsTransport::~FastDdsTransport() = default;

Result<void, Failure> FastDdsTransport::open(const TransportPlan& plan) {
  return impl_->open(plan);
}

bool FastDdsTransport::write(std::size_t channel, const wire::Sample& sample) {
  return impl_->write(channel, sample);
}

void FastDdsTransport::set_up(std::size_t channel, bool up) { impl_->set_up(channel, up); }

std::vector<Arrival> FastDdsTransport::take() { return impl_->mailbox().take(); }

void FastDdsTransport::on_arrival(std::function<void()> notify) {
  impl_->mailbox().on_arrival(std::move(notify));
}

}  // namespace skein::blackboard
