// SPDX-License-Identifier: Apache-2.0
// The figures of a run against a second count of the lines of its event log.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "builders.hpp"
#include "skein/foundation/random.hpp"
#include "story/statistics.hpp"

namespace skein::report {
namespace {

using nlohmann::json;

/// The lines of a run that never was: three UAVs, their tasks and what they send each other.
class WrittenLog {
 public:
  explicit WrittenLog(std::uint64_t seed) : random_(seed, "recount") {
    for (int second = 0; second < 30; ++second) {
      for (const char* uav : {"heliv", "karma", "marvin"}) telemetry(second, uav);
      if (random_.chance(0.5)) task(second);
      if (random_.chance(0.8)) message(second);
      if (random_.chance(0.1)) expectation(second);
    }
  }
  std::string text() const {
    std::string text;
    for (const json& line : lines) text += line.dump() + "\n";
    return text;
  }
  std::vector<json> lines;

 private:
  const char* any_uav() {
    static constexpr const char* kUavs[] = {"heliv", "karma", "marvin"};
    return kUavs[random_.below(3)];
  }
  json& line(double at, const std::string& node, const std::string& kind) {
    return lines.emplace_back(json{{"at", at}, {"node", node}, {"kind", kind}});
  }
  void telemetry(int second, const std::string& uav) {
    if (random_.chance(0.2)) return;  // not of every second
    double& energy = energy_.emplace(uav, 1.0).first->second;
    energy -= random_.uniform(0, 0.02);
    const json place = {random_.uniform(0, 99), random_.uniform(0, 99), random_.uniform(0, 60)};
    line(second, "sim", "telemetry")
        .update({{"uav", uav},
                 {"position", place},
                 {"velocity", {random_.uniform(0, 9), random_.uniform(0, 9), 0}},
                 {"heading", 0},
                 {"energy", energy},
                 {"airborne", random_.chance(0.7)}});
  }
  void task(int second) {
    const std::string uav = any_uav();
    const std::uint64_t id = ++tasks_;
    const auto tell = [&](double at, const char* state) {
      line(at, uav, "task")
          .update({{"uav", uav}, {"task", id}, {"type", "goto"}, {"state", state}});
    };
    tell(second, "scheduled");
    if (random_.chance(0.3)) return;
    tell(second + 0.25, "running");
    if (random_.chance(0.3)) return;
    tell(second + 0.5, random_.chance(0.5) ? "ended" : "aborted");
  }
  void message(int second) {
    const std::string from = any_uav(), to = "ground",
                      slot = random_.chance(0.5) ? "Alarm" : "Task";
    const std::uint64_t number = ++messages_;
    const auto tell = [&](double at, const std::string& node, const char* direction) {
      line(at, node, "message")
          .update({{"slot", slot},
                   {"from", from},
                   {"to", to},
                   {"sequence", number},
                   {"direction", direction}});
    };
    tell(second, from, "sent");
    if (random_.chance(0.2)) tell(second + 0.1, from, "sent");  // once more, after a while
    if (random_.chance(0.7)) tell(second + random_.uniform(0.2, 3), to, "received");
  }
  void expectation(int second) {
    line(second, "runner", "expectation")
        .update({{"name", "e"}, {"passed", random_.chance(0.8)}, {"seen", ""}});
  }

  Random random_;
  std::map<std::string, double> energy_;
  std::uint64_t tasks_ = 0, messages_ = 0;
};

struct Measured {
  explicit Measured(const WrittenLog& log) {
    Journal journal = testing::salvage(log.text()).journal;
    sort_by_time(journal);
    story = tell({}, journal);
    figures = measure(story, journal);
  }
  const UavFigures& of(const std::string& uav) const {
    return figures.uavs.at(*story.uav_index(uav));
  }
  Chronology story;
  Statistics figures;
};

RC_GTEST_PROP(FiguresRecount, EveryLineIsOneOfTheRun, (std::uint64_t seed)) {
  const WrittenLog log(seed);

  RC_ASSERT(Measured(log).figures.lines == log.lines.size());
}

RC_GTEST_PROP(FiguresRecount, TasksAndHowTheyEndedAreThoseOfTheLines, (std::uint64_t seed)) {
  const WrittenLog log(seed);
  const Measured measured(log);
  std::map<std::string, std::map<std::uint64_t, std::string>> last;
  for (const json& line : log.lines) {
    if (line["kind"] == "task") last[line["uav"]][line["task"]] = line["state"];
  }

  for (const auto& [uav, tasks] : last) {
    std::size_t ended = 0, aborted = 0;
    for (const auto& [id, state] : tasks) {
      ended += state == "ended" ? 1 : 0;
      aborted += state == "aborted" ? 1 : 0;
    }
    RC_ASSERT(measured.of(uav).tasks == tasks.size());
    RC_ASSERT(measured.of(uav).ended == ended);
    RC_ASSERT(measured.of(uav).aborted == aborted);
  }
}

RC_GTEST_PROP(FiguresRecount, WayTimeInTheAirHeightSpeedAndEnergyAreThoseOfTheSamples,
              (std::uint64_t seed)) {
  const WrittenLog log(seed);
  const Measured measured(log);
  std::map<std::string, std::vector<json>> samples;
  for (const json& line : log.lines) {
    if (line["kind"] == "telemetry") samples[line["uav"]].push_back(line);
  }

  for (const auto& [uav, track] : samples) {
    bool ever = false;
    for (const json& p : track) ever = ever || p["airborne"].get<bool>();
    double way = 0, air = 0, top = -1e9, fastest = 0;
    for (std::size_t i = 0; i < track.size(); ++i) {
      const auto place = track[i]["position"].get<std::vector<double>>();
      const auto speed = track[i]["velocity"].get<std::vector<double>>();
      top = std::max(top, place[2]);
      fastest = std::max(fastest, std::sqrt(speed[0] * speed[0] + speed[1] * speed[1]));
      if (i == 0) continue;
      const auto before = track[i - 1]["position"].get<std::vector<double>>();
      const bool flew = track[i]["airborne"].get<bool>() || track[i - 1]["airborne"].get<bool>();
      double squares = 0;
      for (std::size_t k = 0; k < 3; ++k) squares += std::pow(place[k] - before[k], 2);
      if (flew || !ever) way += std::sqrt(squares);
      if (flew) air += track[i]["at"].get<double>() - track[i - 1]["at"].get<double>();
    }
    const UavFigures& f = measured.of(uav);
    RC_ASSERT(std::abs(f.distance - way) < 1e-6);
    RC_ASSERT(std::abs(f.airborne - air) < 1e-6);
    RC_ASSERT(std::abs(*f.max_altitude - top) < 1e-6);
    RC_ASSERT(std::abs(f.max_speed - fastest) < 1e-6);
    const double used =
        track.front()["energy"].get<double>() - track.back()["energy"].get<double>();
    RC_ASSERT(std::abs(*f.energy_used - used) < 1e-9);
  }
}

RC_GTEST_PROP(FiguresRecount, MessagesAreCountedOnceAndLatenciesAreFromTheFirstSending,
              (std::uint64_t seed)) {
  const WrittenLog log(seed);
  std::map<ChannelKey, std::map<std::uint64_t, double>> sent;
  std::map<ChannelKey, std::vector<double>> latencies;
  for (const json& line : log.lines) {
    if (line["kind"] != "message") continue;
    const ChannelKey key{line["slot"], line["from"], line["to"]};
    const double at = line["at"];
    if (line["direction"] == "sent")
      sent[key].emplace(line["sequence"], at);
    else
      latencies[key].push_back(at - sent[key].at(line["sequence"]));
  }

  const Measured measured(log);

  RC_ASSERT(measured.figures.channels.size() == sent.size());
  for (auto& [key, first] : sent) {
    const ChannelFigures& f = measured.figures.channels.at(key);
    std::vector<double>& expected = latencies[key];
    std::sort(expected.begin(), expected.end());
    RC_ASSERT(f.sent == first.size());
    RC_ASSERT(f.received == expected.size());
    RC_ASSERT(f.latencies.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      RC_ASSERT(std::abs(f.latencies[i] - expected[i]) < 1e-6);
    }
  }
}

RC_GTEST_PROP(FiguresRecount, ExpectationsAreThoseThatPassedAndThoseThatDidNot,
              (std::uint64_t seed)) {
  const WrittenLog log(seed);
  const Statistics figures = Measured(log).figures;
  std::size_t passed = 0, failed = 0;
  for (const json& line : log.lines) {
    if (line["kind"] == "expectation") ++(line["passed"].get<bool>() ? passed : failed);
  }

  RC_ASSERT(figures.passed == passed);
  RC_ASSERT(figures.failed == failed);
  RC_ASSERT(figures.ok() == (passed > 0 && failed == 0));
}

// The nearest that two samples came, one of them where its line leads between its own.
RC_GTEST_PROP(FiguresRecount, NoSampleOfEitherIsNearerThanTheSeparation, (std::uint64_t seed)) {
  const WrittenLog log(seed);
  const Measured measured(log);
  std::optional<double> least;
  for (const UavStory& one : measured.story.uavs) {
    for (const UavStory& other : measured.story.uavs) {
      if (one.name == other.name) continue;
      for (const TrackPoint& p : one.track) {
        const auto q = at(other.track, p.t);
        if (!q || !p.airborne || !q->airborne) continue;
        const double metres = std::hypot(p.position.x - q->position.x, p.position.y - q->position.y,
                                         p.position.z - q->position.z);
        least = std::min(least.value_or(metres), metres);
      }
    }
  }

  RC_ASSERT(measured.figures.separation.has_value() == least.has_value());
  if (least) RC_ASSERT(std::abs(measured.figures.separation->metres - *least) < 1e-9);
}

}  // namespace
}  // namespace skein::report
