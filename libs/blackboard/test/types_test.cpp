// SPDX-License-Identifier: Apache-2.0
// What a blackboard over Cyclone DDS announces of its types: who has none of our IDL reads our
// samples by it, and nobody is worse off for it.
#include <cyclone/event.h>
#include <cyclone/state.h>
#include <dds/dds.h>
#include <dds/ddsc/dds_public_impl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "adapters/cyclonedds/qos.hpp"
#include "adapters/cyclonedds/settings.hpp"
#include "skein/blackboard/blackboard.hpp"
#include "skein/blackboard/dds_transport.hpp"
#include "skein/blackboard/domain_lease.hpp"
#include "testing/foreign_writer.hpp"

namespace skein::blackboard::testing {
namespace {

const Node kGround{NodeNumber(1), "ground"};
const Node kMarvin{NodeNumber(3), "marvin"};
constexpr const char* kFromMarvin = "radio/marvin>ground";

Now now() {
  const auto since = std::chrono::steady_clock::now().time_since_epoch();
  return {{}, Duration::nanoseconds(std::chrono::nanoseconds(since).count())};
}

/// That something came, to any of those who share it.
class Bell {
 public:
  void ring() {
    const std::lock_guard lock(mutex_);
    rung_ = true;
    wake_.notify_one();
  }
  void wait_until(std::chrono::steady_clock::time_point at_most) {
    std::unique_lock lock(mutex_);
    wake_.wait_until(lock, at_most, [this] { return rung_; });
    rung_ = false;
  }

 private:
  std::mutex mutex_;
  std::condition_variable wake_;
  bool rung_ = false;
};

/// A node on the radio between marvin and the ground station.
class OneOfUs {
 public:
  OneOfUs(std::uint32_t domain, Bell& bell, const Node& self, DdsVendor dds, bool types) {
    DdsConfig config;
    config.domain = domain;
    config.network.dds = dds;
    config.network.types = types;
    transport_ = make_dds_transport(std::move(config));
    transport_->on_arrival([&bell] { bell.ring(); });
    Config settings;
    settings.self = self.number;
    settings.channels = station_link(kGround, kMarvin);
    blackboard_ =
        std::make_unique<Blackboard>(Blackboard::open(std::move(settings), *transport_).value());
  }
  Blackboard& operator*() { return *blackboard_; }
  std::chrono::steady_clock::time_point next_step() const {
    const Duration next = blackboard_->next_wakeup().value_or(now().steady + Duration::seconds(1));
    return std::chrono::steady_clock::time_point(std::chrono::nanoseconds(next.count()));
  }
  void step() {
    for (Incoming& incoming : blackboard_->step(now()))
      if (auto* received = std::get_if<Received>(&incoming)) samples.push_back(received->sample);
  }
  template <class T>
  bool has() const {
    return std::ranges::any_of(samples,
                               [](const auto& one) { return std::holds_alternative<T>(one); });
  }

  std::vector<wire::Sample> samples;

 private:
  std::unique_ptr<Transport> transport_;
  std::unique_ptr<Blackboard> blackboard_;
};

struct FreeDescriptor {
  void operator()(dds_topic_descriptor_t* one) const { dds_delete_topic_descriptor(one); }
};
using Descriptor = std::unique_ptr<dds_topic_descriptor_t, FreeDescriptor>;

/// A program on Cyclone DDS that is none of ours, with a domain of its own in this process: what
/// it knows of types it was told by the network.
class Foreign {
 public:
  Foreign(std::uint32_t domain, Bell& bell)
      : rings_(dds_create_listener(&bell), &dds_delete_listener) {
    dds_lset_data_available(rings_.get(),
                            [](dds_entity_t, void* to) { static_cast<Bell*>(to)->ring(); });
    DdsConfig config;
    config.domain = domain;
    const std::uint32_t number = next_foreign_number();
    const dds_domainid_t id = 9000 + number;
    domain_ = made(dds_create_domain(id, cyclonedds::settings(config, number).c_str()));
    participant_ = made(dds_create_participant(id, nullptr, nullptr));
    writers_ = made(
        dds_create_reader(participant_, DDS_BUILTIN_TOPIC_DCPSPUBLICATION, nullptr, rings_.get()));
  }
  Foreign(const Foreign&) = delete;
  Foreign& operator=(const Foreign&) = delete;
  ~Foreign() { dds_delete(domain_); }

  /// Looks at who writes: the topics seen, and the types that were announced.
  void look() {
    void* sample = nullptr;
    dds_sample_info_t info;
    while (dds_take(writers_, &sample, &info, 1, 1) == 1) {
      const auto& writer = *static_cast<const dds_builtintopic_endpoint_t*>(sample);
      const dds_typeinfo_t* type = nullptr;
      if (info.valid_data) topics.insert(writer.topic_name);
      if (info.valid_data &&
          dds_builtintopic_get_endpoint_type_info(const_cast<dds_builtintopic_endpoint_t*>(&writer),
                                                  &type) == DDS_RETCODE_OK &&
          type != nullptr && !types.contains(writer.topic_name))
        types.emplace(writer.topic_name, described(*type));
      dds_return_loan(writers_, &sample, 1);
      sample = nullptr;
    }
  }
  dds_entity_t reader(const dds_topic_descriptor_t& type, wire::Slot slot, const char* partition) {
    const std::string name(wire::slot_name(slot));
    const dds_entity_t topic =
        made(dds_create_topic(participant_, &type, name.c_str(), nullptr, nullptr));
    const dds_entity_t subscriber = made(
        dds_create_subscriber(participant_, cyclonedds::partition_qos(partition).get(), nullptr));
    return made(dds_create_reader(
        subscriber, topic, cyclonedds::reader_qos(slot, ChannelKind::kRadio).get(), rings_.get()));
  }
  /// Whether something came; the sample is lent until the reader ends.
  template <class T>
  static bool take(dds_entity_t reader, const T*& into) {
    void* sample = nullptr;
    dds_sample_info_t info;
    if (dds_take(reader, &sample, &info, 1, 1) != 1 || !info.valid_data) return false;
    into = static_cast<const T*>(sample);
    return true;
  }

  std::set<std::string> topics;
  std::map<std::string, Descriptor> types;

 private:
  static dds_entity_t made(dds_entity_t entity) {
    if (entity < 0) throw std::runtime_error(dds_strretcode(entity));
    return entity;
  }
  Descriptor described(const dds_typeinfo_t& type) const {
    dds_topic_descriptor_t* found = nullptr;
    made(dds_create_topic_descriptor(DDS_FIND_SCOPE_GLOBAL, participant_, &type, DDS_SECS(10),
                                     &found));
    return Descriptor(found);
  }

  std::unique_ptr<dds_listener_t, decltype(&dds_delete_listener)> rings_;
  dds_entity_t domain_ = 0, participant_ = 0, writers_ = 0;
};

wire::MissionPlan plan_of_two() {
  wire::MissionPlan plan;
  plan.uav = "marvin";
  plan.revision = 7;
  plan.tasks.resize(2);
  plan.tasks[1].type = "GOTO";
  plan.tasks[1].dependences.resize(3);
  plan.tasks[1].dependences[2] = {wire::DependenceKind::kOver, 42};
  return plan;
}

wire::TaskRequest request_of_one() {
  wire::TaskRequest request;
  request.task.id = 104;
  request.task.type = "PERCEIVE";
  request.task.parameters.resize(1);
  request.task.parameters[0].name = "at";
  request.task.parameters[0].numbers = {1.5, -2.5};
  return request;
}

class AnnouncedTypes : public ::testing::Test {
 protected:
  OneOfUs of_us(const Node& self, DdsVendor dds = DdsVendor::kCycloneDds, bool types = true) {
    return {lease_.domain(), bell_, self, dds, types};
  }
  bool run_until(const std::function<bool()>& condition, std::vector<OneOfUs*> nodes) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (std::chrono::steady_clock::now() < deadline) {
      for (OneOfUs* const node : nodes) node->step();
      if (condition()) return true;
      auto due = deadline;
      for (const OneOfUs* const node : nodes) due = std::min(due, node->next_step());
      bell_.wait_until(due);
    }
    return false;
  }
  /// What `foreign` was told of the topic's type, which `node` announces; null: nothing.
  const dds_topic_descriptor_t* find_type(Foreign& foreign, const char* topic, OneOfUs& node) {
    const bool found =
        run_until([&] { return foreign.look(), foreign.types.contains(topic); }, {&node});
    return found ? foreign.types.at(topic).get() : nullptr;
  }

  DomainLease lease_ = claim_domain().value();
  Bell bell_;
};

TEST_F(AnnouncedTypes, AForeignProgramReadsAStateByThem) {
  OneOfUs marvin = of_us(kMarvin);
  Foreign foreign(lease_.domain(), bell_);
  ASSERT_TRUE((*marvin).send(plan_of_two(), kGround.number, now()));
  const dds_topic_descriptor_t* const found = find_type(foreign, "MissionPlan", marvin);
  ASSERT_NE(found, nullptr);
  const dds_topic_descriptor_t& type = *found;
  ASSERT_STREQ(type.m_typename, "skein::idl::MissionPlan");
  ASSERT_EQ(type.m_size, sizeof(skein_idl_MissionPlan));
  ASSERT_EQ(type.m_nkeys, 3U);

  const dds_entity_t reader = foreign.reader(type, wire::Slot::kMissionPlan, kFromMarvin);

  const skein_idl_MissionPlan* plan = nullptr;
  ASSERT_TRUE(run_until([&] { return Foreign::take(reader, plan); }, {&marvin}));
  EXPECT_EQ(plan->parent.origin, kMarvin.number.value());
  EXPECT_STREQ(plan->uav, "marvin");
  EXPECT_EQ(plan->revision, 7U);
  ASSERT_EQ(plan->tasks._length, 2U);
  EXPECT_STREQ(plan->tasks._buffer[1].type, "GOTO");
  ASSERT_EQ(plan->tasks._buffer[1].dependences._length, 3U);
  EXPECT_EQ(plan->tasks._buffer[1].dependences._buffer[2].kind, skein_idl_DEPENDENCE_OVER);
  EXPECT_EQ(plan->tasks._buffer[1].dependences._buffer[2].task, 42U);
}

TEST_F(AnnouncedTypes, AForeignProgramReadsAnEventByThem) {
  OneOfUs ground = of_us(kGround);
  Foreign foreign(lease_.domain(), bell_);
  ASSERT_TRUE((*ground).send(request_of_one(), kMarvin.number, now()));
  const dds_topic_descriptor_t* const found = find_type(foreign, "TaskRequest", ground);
  ASSERT_NE(found, nullptr);
  const dds_topic_descriptor_t& type = *found;
  ASSERT_EQ(type.m_size, sizeof(skein_idl_TaskRequest));

  const dds_entity_t reader = foreign.reader(type, wire::Slot::kTaskRequest, "radio/ground>marvin");

  const skein_idl_TaskRequest* request = nullptr;
  ASSERT_TRUE(run_until([&] { return Foreign::take(reader, request); }, {&ground}));
  EXPECT_EQ(request->parent.destination, kMarvin.number.value());
  EXPECT_EQ(request->task.id, 104U);
  ASSERT_EQ(request->task.parameters._length, 1U);
  EXPECT_STREQ(request->task.parameters._buffer[0].name, "at");
  ASSERT_EQ(request->task.parameters._buffer[0].numbers._length, 2U);
  EXPECT_EQ(request->task.parameters._buffer[0].numbers._buffer[1], -2.5);
}

TEST_F(AnnouncedTypes, ThereAreNoneUnlessAskedFor) {
  OneOfUs marvin = of_us(kMarvin, DdsVendor::kCycloneDds, false);
  Foreign foreign(lease_.domain(), bell_);
  ASSERT_TRUE((*marvin).send(plan_of_two(), kGround.number, now()));

  ASSERT_TRUE(
      run_until([&] { return foreign.look(), foreign.topics.contains("MissionPlan"); }, {&marvin}));

  EXPECT_THAT(foreign.types, ::testing::IsEmpty());
}

// It announces a type of its own, in which the header is a base: Cyclone DDS writes past its memory
// when it compares that with another, in every program that does.
TEST_F(AnnouncedTypes, AProgramMadeFromTheIdlReadsUsAsBefore) {
  OneOfUs marvin = of_us(kMarvin);
  Foreign foreign(lease_.domain(), bell_);
  const dds_entity_t everywhere =
      foreign.reader(skein_idl_MissionPlan_desc, wire::Slot::kMissionPlan, "*");

  ASSERT_TRUE((*marvin).send(plan_of_two(), kGround.number, now()));

  const skein_idl_MissionPlan* plan = nullptr;
  ASSERT_TRUE(run_until([&] { return Foreign::take(everywhere, plan); }, {&marvin}));
  EXPECT_STREQ(plan->uav, "marvin");
}

TEST_F(AnnouncedTypes, NodesOnFastDdsTalkAsBefore) {
  OneOfUs marvin = of_us(kMarvin);
  OneOfUs ground = of_us(kGround, DdsVendor::kFastDds, false);

  ASSERT_TRUE((*ground).send(request_of_one(), kMarvin.number, now()));
  ASSERT_TRUE((*marvin).send(plan_of_two(), kGround.number, now()));

  EXPECT_TRUE(
      run_until([&] { return marvin.has<wire::TaskRequest>() && ground.has<wire::MissionPlan>(); },
                {&marvin, &ground}));
}

// Somebody announces what he likes under the name of ours.
TEST_F(AnnouncedTypes, WhatOthersAnnounceDecidesNothing) {
  OneOfUs marvin = of_us(kMarvin);
  OneOfUs ground = of_us(kGround);
  Foreign foreign(lease_.domain(), bell_);
  dds_topic_descriptor_t liar = skein_idl_TaskRequest_desc;
  liar.m_typename = "skein::idl::MissionPlan";
  foreign.reader(liar, wire::Slot::kMissionPlan, "*");

  ASSERT_TRUE((*ground).send(request_of_one(), kMarvin.number, now()));
  ASSERT_TRUE((*marvin).send(plan_of_two(), kGround.number, now()));

  EXPECT_TRUE(
      run_until([&] { return marvin.has<wire::TaskRequest>() && ground.has<wire::MissionPlan>(); },
                {&marvin, &ground}));
}

}  // namespace
}  // namespace skein::blackboard::testing
