// SPDX-License-Identifier: Apache-2.0
// What readers of Fast DDS do with what comes.
#include "sample_listener.hpp"

#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>

namespace skein::blackboard::fastdds {

namespace dds = eprosima::fastdds::dds;
using eprosima::fastrtps::types::ReturnCode_t;

void SampleListener::on_data_available(dds::DataReader* reader) {
  bool any = false;
  Cargo cargo;
  dds::SampleInfo info;
  while (reader->take_next_sample(&cargo, &info) == ReturnCode_t::RETCODE_OK) {
    if (!info.valid_data || is_own(cargo)) continue;
    check_writer(cargo, info.sample_identity.writer_guid().guidPrefix);
    mailbox_.put({place_.channel, std::move(cargo.incoming)});
    any = true;
  }
  if (any) mailbox_.notify();
}

bool SampleListener::is_own(const Cargo& cargo) const {
  const auto* sample = std::get_if<wire::Sample>(&cargo.incoming);
  return sample != nullptr && wire::header_of(*sample).origin == place_.self.value();
}

void SampleListener::check_writer(Cargo& cargo, const Prefix& writer) const {
  const auto* sample = std::get_if<wire::Sample>(&cargo.incoming);
  if (writers_.identities == nullptr || sample == nullptr) return;
  const auto named = writers_.names.find(NodeNumber(wire::header_of(*sample).origin));
  const bool known = named != writers_.names.end();
  if (known && is_entitled(*sample, named->second, writer)) return;
  const std::string name = known ? named->second : "a stranger";
  cargo.incoming =
      Malformed{wire::slot_of(*sample), {}, {"header.origin", name + " did not write this"}};
}

bool SampleListener::is_entitled(const wire::Sample& sample, const std::string& origin,
                                 const Prefix& writer) const {
  if (writers_.identities->confirm(origin, writer)) return true;
  const auto relay = writers_.names.find(place_.config.from);
  return place_.config.relays(wire::slot_of(sample)) && relay != writers_.names.end() &&
         writers_.identities->confirm(relay->second, writer);
}

}  // namespace skein::blackboard::fastdds
