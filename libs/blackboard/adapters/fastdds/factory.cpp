// SPDX-License-Identifier: Apache-2.0
#include "factory.hpp"

#include <fastrtps/xmlparser/XMLProfileManager.h>

#include <mutex>

namespace skein::blackboard::fastdds {

namespace dds = eprosima::fastdds::dds;

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

}  // namespace skein::blackboard::fastdds
