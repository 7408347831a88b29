// SPDX-License-Identifier: Apache-2.0
// Hosts of a ground station, a simulator and two UAVs in one process, over memory and with the
// test's time.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "skein/blackboard/memory_transport.hpp"
#include "skein/node/host.hpp"
#include "testing/fake_node.hpp"

namespace skein::node::testing {

using blackboard::Now;
using journal::Record;

// One node with its host, and everything that came out of it.
struct Station {
  explicit Station(blackboard::MemoryHub& hub) : transport(hub) {}

  Diary diary;
  blackboard::MemoryTransport transport;
  std::unique_ptr<Host> host;
  std::vector<Record> records;
  std::vector<wire::Sample> world;
  std::vector<StartJob> jobs;
  int finishes = 0;

  std::vector<std::string> lines(const std::string& kind) const {
    std::vector<std::string> found;
    for (const Record& record : records) {
      if (record.kind() == kind) found.push_back(to_json(record));
    }
    return found;
  }
};

// ground, sim and two UAVs in one process; time is the test's.
class Hosts : public ::testing::Test {
 protected:
  Hosts() {
    for (const char* name : {"ground", "sim", "marvin", "heliv"}) start(name);
  }

  void start(const std::string& name, std::uint64_t incarnation = 1, double rate = 1) {
    open(name, incarnation, rate);
    (*this)[name].host->start(now());
  }
  // A host that is there, but not started yet.
  void open(const std::string& name, std::uint64_t incarnation = 1, double rate = 1) {
    auto station = std::make_unique<Station>(hub_);
    Station& it = *station;
    HostConfig config;
    config.incarnation = incarnation;
    config.rate = rate;
    config.told = told;
    config.world = world;
    HostPorts ports;
    ports.journal = [&it](const Record& record, LineMark) { it.records.push_back(record); };
    ports.start_job = [&it](StartJob job) { it.jobs.push_back(std::move(job)); };
    ports.finish = [&it] { ++it.finishes; };
    ports.world = [&it](const wire::Sample& sample) { it.world.push_back(sample); };
    auto host = Host::open(roster_, *roster_.find(name), std::make_unique<FakeNode>(it.diary),
                           it.transport, config, ports);
    it.host = std::move(host.value());
    stations_[name] = std::move(station);
  }

  Station& operator[](const std::string& name) { return *stations_.at(name); }
  NodeNumber number(const std::string& name) const { return roster_.find(name)->number; }
  Now now() const { return {MissionTime::seconds(time_), Duration::seconds(time_)}; }

  // Steps every host until all are quiet.
  void settle() {
    for (bool busy = true; busy;) {
      busy = false;
      for (auto& [name, station] : stations_) busy = station->host->step(now()) || busy;
    }
  }
  void advance(double seconds) {
    const double until = time_ + seconds;
    while (time_ + 0.05 < until) {
      time_ += 0.05;
      settle();
    }
    time_ = until;
    settle();
  }
  // Lets a node answer its next input, the end of a job, with an effect.
  void act(const std::string& name, Effects effects) {
    Station& station = (*this)[name];
    station.diary.effects = std::move(effects);
    station.host->job_done({}, now());
  }
  void set_link(const std::string& a, const std::string& b, bool up) {
    (*this)["sim"].host->publish(link(number(a), number(b), up), now());
    (*this)["sim"].host->publish(link(number(b), number(a), up), now());
    settle();
  }
  void meet() { advance(0.2); }

  Roster roster_{{"marvin", "heliv"}};
  blackboard::MemoryHub hub_;
  std::map<std::string, std::unique_ptr<Station>> stations_;
  ToldOfLinks told = ToldOfLinks::kAll;
  bool world = true;
  double time_ = 0;
};

}  // namespace skein::node::testing
