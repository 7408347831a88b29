// SPDX-License-Identifier: Apache-2.0
#include "participation.hpp"

#include <fastrtps/xmlparser/XMLProfileManager.h>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>

#include <mutex>
#include <string>

#include "adapters/rtps/ports.hpp"
#include "qos.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::blackboard::fastdds {
namespace {

namespace dds = eprosima::fastdds::dds;

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

Participation::~Participation() {
  if (participant_ == nullptr) return;
  participant_->delete_contained_entities();
  factory().delete_participant(participant_);
}

Result<void, Failure> Participation::join(const DdsConfig& config,
                                          dds::DomainParticipantListener* listener,
                                          const rtps::Pace& pace, Departures departures) {
  SKEIN_EXPECTS(participant_ == nullptr);
  if (auto checked = rtps::check(config.network); !checked) return checked;
  const std::string domain = std::to_string(config.domain);
  const std::string& keys = keys_ = config.network.keys;
  number_ = rtps::ParticipantNumber::claim(config.domain);
  if (!number_) return failure("too many DDS participants in domain " + domain);
  dds::DomainParticipantQos qos = participant_qos(config, number_->value(), pace, departures);
  if (!keys.empty()) {
    auto security = security_properties(keys);
    if (!security) return tl::unexpected(security.error());
    qos.properties() = *security;
    auto identities = Identities::read(keys);
    if (!identities) return tl::unexpected(identities.error());
    identities_ = std::move(*identities);
  }
  participant_ =
      factory().create_participant(config.domain, qos, listener, dds::StatusMask::none());
  if (participant_ != nullptr) return {};
  return failure("no DDS participant in domain " + domain +
                 (keys.empty() ? " (no such interface, or its ports are taken?)"
                               : ": Fast DDS refuses the keys in " + keys));
}

}  // namespace skein::blackboard::fastdds
