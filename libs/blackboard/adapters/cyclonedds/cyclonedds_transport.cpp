// SPDX-License-Identifier: Apache-2.0
// The transport over Cyclone DDS.
#include "skein/blackboard/cyclonedds_transport.hpp"

#include <dds/dds.h>

#include <atomic>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "adapters/rtps/links.hpp"
#include "adapters/rtps/participant_number.hpp"
#include "adapters/rtps/ports.hpp"
#include "announced_types.hpp"
#include "bounded_call.hpp"
#include "channel_endpoints.hpp"
#include "middleware_log.hpp"
#include "program_discovery.hpp"
#include "qos.hpp"
#include "settings.hpp"
#include "skein/blackboard/program_description.hpp"
#include "skein/foundation/contract.hpp"
#include "wall_clock.hpp"
#include "writer_discovery.hpp"

namespace skein::blackboard {
namespace {

/// Of the domains within this process; what is on the network is set apart (ExternalDomainId).
dds_domainid_t next_domain() {
  static std::atomic<dds_domainid_t> last{0};
  return ++last;
}

constexpr Duration kCloses = Duration::milliseconds(5'000);  ///< far more than it takes

}  // namespace

class CycloneDdsTransport::Impl {
 public:
  explicit Impl(DdsConfig config)
      : config_(std::move(config)), log_(id_, [this](const std::string& line) { say(line); }) {}
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  Result<void, Failure> open(const TransportPlan& plan);
  /// False: Cyclone DDS does not end, and its threads go on using this object.
  bool close();
  rtps::Links& links() { return links_; }
  /// As often as the node looks at what came: its threads wake when the wall clock was set back.
  void look_at_clock();

 private:
  void say(const std::string& line);
  Result<void, Failure> join(const rtps::Pace& pace);
  /// A participant, or negative.
  dds_entity_t make_participant() const;
  /// Of what the node writes.
  Result<void, Failure> announce() const;

  const dds_domainid_t id_ = next_domain();
  DdsConfig config_;
  std::mutex said_mutex_;
  std::string said_;  ///< by Cyclone of its start
  cyclonedds::MiddlewareLog log_;
  std::optional<rtps::ParticipantNumber> number_;
  rtps::Links links_;
  cyclonedds::WriterDiscovery discovery_{links_.awaited()};
  cyclonedds::ProgramDiscovery programs_{config_.programs};
  dds_entity_t domain_ = 0;  ///< owns all other entities
  dds_entity_t participant_ = 0;
  cyclonedds::Topics topics_{participant_};
  cyclonedds::WallClock wall_clock_;
};

// Threads of Cyclone DDS wait on the wall clock: set back by a day while one waits, a deletion that
// needs this thread takes a day (eclipse-cyclonedds/cyclonedds issue 1995, mended after 0.10).
bool CycloneDdsTransport::Impl::close() {
  look_at_clock();
  links_.flush();
  look_at_clock();
  if (domain_ <= 0 || cyclonedds::returns_within(kCloses, [id = domain_] { dds_delete(id); }))
    return true;
  links_.mailbox().on_arrival({});
  if (config_.log)
    config_.log("Cyclone DDS does not end within " + to_text(kCloses) +
                ", as when the wall clock was set back: the process goes on without it");
  return false;
}

void CycloneDdsTransport::Impl::look_at_clock() {
  if (!wall_clock_.set_back() || participant_ <= 0) return;
  // To delete a reliable writer is what wakes both: the thread of garbage, and that of timed
  // events, of which the writer had one.
  const dds_entity_t publisher =
      dds_create_publisher(participant_, cyclonedds::partition_qos("woken").get(), nullptr);
  dds_create_writer(publisher, topics_.of(wire::Slot::kClock).entity,
                    cyclonedds::writer_qos(wire::Slot::kClock, ChannelKind::kWorld).get(), nullptr);
  dds_delete(publisher);
}

void CycloneDdsTransport::Impl::say(const std::string& line) {
  if (config_.log) config_.log(line);
  const std::lock_guard lock(said_mutex_);
  if (participant_ <= 0) said_ += (said_.empty() ? "" : "; ") + line;
}

dds_entity_t CycloneDdsTransport::Impl::make_participant() const {
  if (domain_ <= 0) return domain_;
  const cyclonedds::Qos qos(dds_create_qos());
  dds_qset_entity_name(qos.get(), config_.participant_name.c_str());
  const std::string description = to_text(program_description(config_.scenario));
  dds_qset_userdata(qos.get(), description.data(), description.size());
  return dds_create_participant(id_, qos.get(), nullptr);
}

Result<void, Failure> CycloneDdsTransport::Impl::join(const rtps::Pace& pace) {
  const std::string domain = std::to_string(config_.domain);
  number_ = rtps::ParticipantNumber::claim(config_.domain);
  if (!number_) return failure("too many DDS participants in domain " + domain);
  domain_ = dds_create_domain(id_, cyclonedds::settings(config_, number_->value(), pace).c_str());
  const dds_entity_t participant = make_participant();
  dds_return_t watches = participant > 0 ? programs_.begin(participant) : participant;
  if (watches >= 0) watches = discovery_.begin(participant);
  const std::lock_guard lock(said_mutex_);
  participant_ = participant;
  if (watches > 0) return {};
  return failure("no Cyclone DDS participant in domain " + domain + ": " +
                 (said_.empty() ? std::string(dds_strretcode(watches)) : said_));
}

Result<void, Failure> CycloneDdsTransport::Impl::announce() const {
  if (!config_.network.types) return {};
  const dds_return_t announced = cyclonedds::announce_types(participant_, links_.written());
  if (announced >= 0) return {};
  return failure(std::string("Cyclone DDS does not announce the types: ") +
                 dds_strretcode(announced));
}

Result<void, Failure> CycloneDdsTransport::Impl::open(const TransportPlan& plan) {
  SKEIN_EXPECTS(domain_ == 0);
  if (auto checked = rtps::check(config_.network); !checked) return checked;
  links_.plan(plan, config_);
  if (auto joined = join(rtps::pace_of(plan)); !joined) return joined;
  if (auto announced = announce(); !announced) return announced;
  return links_.open([this](std::size_t channel, const rtps::LinkPlan& link) {
    return std::make_unique<cyclonedds::ChannelEndpoints>(participant_, topics_, link, channel,
                                                          links_.mailbox(), links_.matches());
  });
}

CycloneDdsTransport::CycloneDdsTransport(DdsConfig config)
    : impl_(std::make_unique<Impl>(std::move(config))) {}

CycloneDdsTransport::~CycloneDdsTransport() {
  if (!impl_->close()) impl_.release();  // NOLINT(bugprone-unused-return-value): it is still used
}

Result<void, Failure> CycloneDdsTransport::open(const TransportPlan& plan) {
  return impl_->open(plan);
}

bool CycloneDdsTransport::write(std::size_t channel, const wire::Sample& sample) {
  return impl_->links().write(channel, sample);
}

Result<void, Failure> CycloneDdsTransport::set_up(std::size_t channel, bool up) {
  return impl_->links().set_up(channel, up);
}

std::vector<Arrival> CycloneDdsTransport::take() {
  impl_->look_at_clock();
  return impl_->links().take();
}

void CycloneDdsTransport::on_arrival(std::function<void()> notify) {
  impl_->links().mailbox().on_arrival(std::move(notify));
}

}  // namespace skein::blackboard
