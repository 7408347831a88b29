// SPDX-License-Identifier: Apache-2.0
#include "skein/ros2_out/ros2_out.hpp"

#include <chrono>
#include <map>

#include "skein/blackboard/foreign_topics.hpp"
#include "skein/foundation/unix_time.hpp"
#include "skein/ros2/cdr.hpp"
#include "skein/ros2/names.hpp"

namespace skein::ros2_out {

namespace {

using blackboard::ForeignTopic;
using blackboard::ForeignTopics;

constexpr const char* kWho = "ros2";
/// Of the header: a station beside the console's.
constexpr std::uint32_t kInstance = 2;

/// As the profiles of ROS 2 have it: the default, and that of sensors.
template <class M>
ForeignTopic topic(const std::string& name, bool of_sensor) {
  return {ros2::topic_of(name), std::string(ros2::type_name<M>()), !of_sensor, of_sensor ? 5 : 10};
}

std::vector<ForeignTopic> topics_of(const std::vector<std::string>& uavs) {
  std::vector<ForeignTopic> topics;
  for (const std::string& name : uavs) {
    const std::string uav = ros2::token_of(name);
    topics.push_back(topic<ros2::NavSatFix>(fix_topic(uav), true));
    topics.push_back(topic<ros2::Odometry>(odometry_topic(uav), false));
    topics.push_back(topic<ros2::BatteryState>(battery_topic(uav), true));
    topics.push_back(topic<ros2::DiagnosticArray>(tasks_topic(uav), false));
  }
  topics.push_back(topic<ros2::DiagnosticArray>(kAlarmsTopic, false));
  topics.push_back(topic<ros2::DiagnosticArray>(kDiagnosticsTopic, false));
  topics.push_back(topic<ros2::String>(kReplyTopic, false));
  return topics;
}

std::uint64_t microseconds_of_now() {
  const auto since = std::chrono::system_clock::now().time_since_epoch();
  return static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::microseconds>(since).count());
}

bool is_list(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return false;
  if (text[first] == '#') {
    const std::size_t end = text.find('\n', first);
    return end != std::string::npos && is_list(text.substr(end));
  }
  if (text.compare(first, 3, "---") == 0) return is_list(text.substr(first + 3));
  return text[first] == '[' || text[first] == '-';
}

}  // namespace

NarratorConfig narrator_config_of(const scenario::Scenario& scenario) {
  return {scenario.uav_names(), scenario.world.origin, epoch_of(scenario.epoch)};
}

std::string request_of(const std::string& text) {
  if (is_list(text)) return text;
  std::string request = "- mission:\n    ";
  for (const char c : text) {
    request += c;
    if (c == '\n') request += "    ";
  }
  return request;
}

class Ros2Out::Impl {
 public:
  Impl(std::unique_ptr<ForeignTopics> topics, Narrator narrator,
       const std::vector<ForeignTopic>& all)
      : topics_(std::move(topics)), narrator_(std::move(narrator)) {
    for (std::size_t i = 0; i < all.size(); ++i) index_[all[i].name] = i;
  }

  ForeignTopics& topics() { return *topics_; }
  Narrator& narrator() { return narrator_; }

  void write(const std::vector<Told>& told) {
    for (const Told& one : told) write(one);
  }
  void write(const Told& told) {
    topics_->write(index_.at(ros2::topic_of(told.topic)), ros2::to_cdr(told.message));
  }
  void reply(const std::string& json) { write({kReplyTopic, ros2::String{json}}); }

  /// What is no request is told at once.
  std::vector<wire::Sample> requests() {
    std::vector<wire::Sample> requests;
    for (const ForeignTopics::Arrival& arrival : topics_->take()) {
      const auto text = ros2::text_of(arrival.bytes);
      if (!text) {
        refuse(text.error().why);
        continue;
      }
      wire::OperatorRequest request;
      request.header.instance = kInstance;
      request.who = kWho;
      request.number = number_ = std::max(number_ + 1, microseconds_of_now());
      request.request = request_of(*text);
      if (const auto wrong = wire::find_violation(request)) {
        refuse(wrong->why);
        continue;
      }
      requests.emplace_back(std::move(request));
    }
    return requests;
  }

 private:
  void refuse(const std::string& why) {
    wire::OperatorReply refusal;
    refusal.who = kWho;
    refusal.complete = true;
    refusal.problems = {why};
    reply(wire::to_json(refusal));
  }

  std::unique_ptr<ForeignTopics> topics_;
  Narrator narrator_;
  std::map<std::string, std::size_t> index_;
  std::uint64_t number_ = 0;  ///< of the last request; grows over restarts too
};

Result<std::unique_ptr<Ros2Out>, Failure> Ros2Out::open(Ros2Config config) {
  auto narrator = Narrator::make(config.narrator);
  if (!narrator) return tl::unexpected(narrator.error());
  if (!config.network.keys.empty()) {
    return failure("a mission with keys is not told to ROS 2, where nobody proves who he is");
  }
  blackboard::ForeignConfig foreign;
  foreign.domain = config.domain;
  foreign.participant_name = "skein";
  foreign.network = config.network;
  foreign.writes = topics_of(config.narrator.uavs);
  foreign.reads = {topic<ros2::String>(kMissionTopic, false)};
  const std::vector<ForeignTopic> all = foreign.writes;
  auto topics = ForeignTopics::open(std::move(foreign));
  if (!topics) return tl::unexpected(topics.error());
  return std::unique_ptr<Ros2Out>(
      new Ros2Out(std::make_unique<Impl>(std::move(*topics), std::move(*narrator), all)));
}

Ros2Out::Ros2Out(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Ros2Out::~Ros2Out() = default;

void Ros2Out::attach(std::function<void()> wake) { impl_->topics().on_arrival(std::move(wake)); }
void Ros2Out::detach() { impl_->topics().on_arrival({}); }
std::vector<wire::Sample> Ros2Out::take() { return impl_->requests(); }

void Ros2Out::sees(const wire::Sample& sample) {
  const auto* reply = std::get_if<wire::OperatorReply>(&sample);
  if (reply != nullptr && reply->who == kWho) impl_->reply(wire::to_json(sample));
  impl_->write(impl_->narrator().hear(sample));
}

void Ros2Out::turn(const node::DaemonState& state) {
  impl_->write(impl_->narrator().turn(state.now.steady, state.now.mission));
}

}  // namespace skein::ros2_out
