// SPDX-License-Identifier: Apache-2.0
#include "skein/blackboard/fastdds_observer.hpp"

#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>

#include <map>

#include "middleware_log.hpp"
#include "participation.hpp"
#include "raw_type.hpp"
#include "sightings.hpp"
#include "skein/blackboard/transport.hpp"

namespace skein::blackboard {
namespace {

namespace dds = eprosima::fastdds::dds;
using eprosima::fastrtps::types::ReturnCode_t;

/// Samples of an instance that may come before they are taken.
constexpr int kDepth = static_cast<int>(kWorldEventDepth);

eprosima::fastrtps::Duration_t duration_of(Duration duration) {
  if (duration == Duration::max()) return eprosima::fastrtps::c_TimeInfinite;
  return {static_cast<std::int32_t>(duration.count() / 1'000'000'000),
          static_cast<std::uint32_t>(duration.count() % 1'000'000'000)};
}

dds::DataReaderQos qos_of(const EndpointQos& asked) {
  dds::DataReaderQos qos;
  qos.reliability().kind =
      asked.reliable ? dds::RELIABLE_RELIABILITY_QOS : dds::BEST_EFFORT_RELIABILITY_QOS;
  qos.durability().kind = static_cast<dds::DurabilityQosPolicyKind_t>(asked.durability);
  qos.ownership().kind = asked.exclusive ? dds::EXCLUSIVE_OWNERSHIP_QOS : dds::SHARED_OWNERSHIP_QOS;
  qos.deadline().period = duration_of(asked.deadline);
  qos.history().kind = dds::KEEP_LAST_HISTORY_QOS;
  qos.history().depth = kDepth;
  qos.resource_limits().max_samples = 0;
  qos.resource_limits().max_instances = 0;
  qos.resource_limits().max_samples_per_instance = 0;
  qos.resource_limits().allocated_samples = 1;
  qos.endpoint().history_memory_policy = eprosima::fastrtps::rtps::DYNAMIC_REUSABLE_MEMORY_MODE;
  qos.data_sharing().off();
  qos.reliable_reader_qos().times.heartbeatResponseDelay = {0, 1'000'000};
  return qos;
}

}  // namespace

class FastDdsObserver::Impl {
 public:
  explicit Impl(ObserverConfig config)
      : config_{config.domain, std::move(config.participant_name), std::move(config.network), {}},
        log_({}) {}

  Result<void, Failure> open() { return participation_.join(config_, &sightings_); }
  Result<void, Failure> read(const Subscription& subscription);
  fastdds::Sightings& sightings() { return sightings_; }

 private:
  dds::Topic* topic(const Subscription& subscription);
  dds::Subscriber* subscriber(const std::vector<std::string>& partitions);

  DdsConfig config_;
  fastdds::MiddlewareLog log_;
  fastdds::Sightings sightings_;
  fastdds::Participation participation_;  // ends before what its threads use
  std::map<std::string, dds::Topic*> topics_;
  std::map<std::vector<std::string>, dds::Subscriber*> subscribers_;
};

dds::Topic* FastDdsObserver::Impl::topic(const Subscription& subscription) {
  dds::Topic*& topic = topics_[subscription.topic];
  if (topic != nullptr) return topic->get_type_name() == subscription.type ? topic : nullptr;
  auto* const participant = participation_.participant();
  const dds::TypeSupport type(new fastdds::RawType(subscription.type, subscription.keyed));
  const bool known = !participant->find_type(subscription.type).empty();
  if (!known && type.register_type(participant) != ReturnCode_t::RETCODE_OK) return nullptr;
  topic = participant->create_topic(subscription.topic, subscription.type, dds::TopicQos{}, nullptr,
                                    dds::StatusMask::none());
  return topic;
}

dds::Subscriber* FastDdsObserver::Impl::subscriber(const std::vector<std::string>& partitions) {
  dds::Subscriber*& subscriber = subscribers_[partitions];
  if (subscriber != nullptr) return subscriber;
  dds::SubscriberQos qos;
  for (const std::string& one : partitions) qos.partition().push_back(one.c_str());
  subscriber =
      participation_.participant()->create_subscriber(qos, nullptr, dds::StatusMask::none());
  return subscriber;
}

Result<void, Failure> FastDdsObserver::Impl::read(const Subscription& subscription) {
  dds::Topic* const on = topic(subscription);
  if (on == nullptr)
    return failure("topic " + subscription.topic + " is not read as " + subscription.type +
                   ": another type, or the same without its key, is");
  dds::Subscriber* const in = subscriber(subscription.partitions);
  const auto qos = qos_of(subscription.qos);
  if (in != nullptr &&
      in->create_datareader(on, qos, &sightings_, dds::StatusMask::data_available()) != nullptr)
    return {};
  return failure("DDS refuses a reader of " + subscription.topic +
                 (config_.network.keys.empty()
                      ? ""
                      : ": the permissions in " + config_.network.keys + " do not allow it"));
}

FastDdsObserver::FastDdsObserver(ObserverConfig config)
    : impl_(std::make_unique<Impl>(std::move(config))) {}
FastDdsObserver::~FastDdsObserver() = default;
Result<void, Failure> FastDdsObserver::open() { return impl_->open(); }
Result<void, Failure> FastDdsObserver::read(const Subscription& subscription) {
  return impl_->read(subscription);
}
std::vector<Sighting> FastDdsObserver::take() { return impl_->sightings().take(); }
void FastDdsObserver::on_sighting(std::function<void()> notify) {
  impl_->sightings().on_sighting(std::move(notify));
}

}  // namespace skein::blackboard
