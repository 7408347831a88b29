// SPDX-License-Identifier: Apache-2.0
// The transport over Fast DDS.
#include "skein/blackboard/fastdds_transport.hpp"

#include <fastdds/rtps/participant/ParticipantDiscoveryInfo.h>
#include <fastdds/rtps/writer/WriterDiscoveryInfo.h>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>

#include <chrono>
#include <sstream>
#include <string>

#include "adapters/rtps/links.hpp"
#include "channel_endpoints.hpp"
#include "middleware_log.hpp"
#include "participation.hpp"

namespace skein::blackboard {
namespace {

namespace dds = eprosima::fastdds::dds;

namespace frtps = eprosima::fastrtps::rtps;

std::string text_of(const frtps::GuidPrefix_t& guid) {
  std::ostringstream text;
  text << guid;
  return text.str();
}

/// Tells of the writers that others have, of handshakes with others, and which programs they are.
class Discovery final : public dds::DomainParticipantListener {
 public:
  Discovery(rtps::AwaitedWriters& awaited, const DdsConfig& config)
      : awaited_(awaited),
        handshakes_(config.handshakes.get()),
        programs_(config.programs.get()),
        secured_(!config.network.keys.empty()) {}

  void on_publisher_discovery(dds::DomainParticipant* participant,
                              frtps::WriterDiscoveryInfo&& found) override {
    using Info = frtps::WriterDiscoveryInfo;
    const bool own = found.info.guid().guidPrefix == participant->guid().guidPrefix;
    if (own || found.status == Info::REMOVED_WRITER) return;
    awaited_.found(found.info.topicName().c_str(), found.info.typeName().c_str(),
                   found.info.m_qos.m_partition.names());
  }

  void on_participant_discovery(dds::DomainParticipant* /*participant*/,
                                frtps::ParticipantDiscoveryInfo&& found) override {
    using Info = frtps::ParticipantDiscoveryInfo;
    const std::string guid = text_of(found.info.m_guid.guidPrefix);
    note_program(guid, found);
    if (handshakes_ == nullptr) return;
    if (found.status == Info::DISCOVERED_PARTICIPANT) {
      const auto now = std::chrono::steady_clock::now().time_since_epoch();
      handshakes_->begun(guid, found.info.m_participantName.c_str(),
                         Duration::nanoseconds(std::chrono::nanoseconds(now).count()));
    } else if (found.status != Info::CHANGED_QOS_PARTICIPANT) {
      handshakes_->gone(guid);
    }
  }

  void onParticipantAuthentication(dds::DomainParticipant* /*participant*/,
                                   frtps::ParticipantAuthenticationInfo&& info) override {
    using Info = frtps::ParticipantAuthenticationInfo;
    if (info.status != Info::AUTHORIZED_PARTICIPANT) return;
    const std::string guid = text_of(info.guid.guidPrefix);
    if (programs_ != nullptr) programs_->proved(guid);
    if (handshakes_ != nullptr) handshakes_->ended(guid);
  }

 private:
  void note_program(const std::string& guid, const frtps::ParticipantDiscoveryInfo& found) {
    using Info = frtps::ParticipantDiscoveryInfo;
    if (programs_ == nullptr) return;
    const bool there = found.status == Info::DISCOVERED_PARTICIPANT ||
                       found.status == Info::CHANGED_QOS_PARTICIPANT;
    if (!there) return programs_->gone(guid);
    const auto& said = found.info.m_userData.data_vec();
    programs_->found(guid, found.info.m_participantName.c_str(), {said.begin(), said.end()},
                     !secured_);
  }

  rtps::AwaitedWriters& awaited_;
  Handshakes* handshakes_;
  Programs* programs_;
  bool secured_;
};

}  // namespace

class FastDdsTransport::Impl {
 public:
  explicit Impl(DdsConfig config) : config_(std::move(config)), log_(config_.log) {}
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() {
    links_.flush();
    links_.close();
  }

  Result<void, Failure> open(const TransportPlan& plan);
  rtps::Links& links() { return links_; }

 private:
  DdsConfig config_;
  fastdds::MiddlewareLog log_;
  rtps::Links links_;
  Discovery discovery_{links_.awaited(), config_};
  fastdds::Participation participation_;  // ends before what its threads use
  fastdds::Topics topics_{participation_};
};

Result<void, Failure> FastDdsTransport::Impl::open(const TransportPlan& plan) {
  links_.plan(plan, config_);
  const auto joined = participation_.join(config_, &discovery_, rtps::pace_of(plan),
                                          fastdds::Departures::kLeftToTheLease);
  if (!joined) return joined;
  const auto& identities = participation_.identities();
  const bool checks = identities.has_value() && !config_.names.empty();
  const fastdds::SampleListener::Writers writers{checks ? &*identities : nullptr, config_.names};
  return links_.open([&](std::size_t channel, const rtps::LinkPlan& link) {
    auto listener = std::make_unique<fastdds::SampleListener>(
        links_.mailbox(), fastdds::SampleListener::Place{channel, link.config, plan.self}, writers);
    return std::make_unique<fastdds::ChannelEndpoints>(
        participation_, topics_, link, std::move(listener),
        std::make_unique<fastdds::WriterListener>(links_.matches(), channel));
  });
}

FastDdsTransport::FastDdsTransport(DdsConfig config)
    : impl_(std::make_unique<Impl>(std::move(config))) {}

FastDdsTransport::~FastDdsTransport() = default;

Result<void, Failure> FastDdsTransport::open(const TransportPlan& plan) {
  return impl_->open(plan);
}

bool FastDdsTransport::write(std::size_t channel, const wire::Sample& sample) {
  return impl_->links().write(channel, sample);
}

Result<void, Failure> FastDdsTransport::set_up(std::size_t channel, bool up) {
  return impl_->links().set_up(channel, up);
}

std::vector<Arrival> FastDdsTransport::take() { return impl_->links().take(); }

void FastDdsTransport::on_arrival(std::function<void()> notify) {
  impl_->links().mailbox().on_arrival(std::move(notify));
}

}  // namespace skein::blackboard
