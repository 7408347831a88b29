// SPDX-License-Identifier: Apache-2.0
// UAVs at degree 4 that meet each other again and again, some of them to be done by a date.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "parts.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/mission_lab/generate.hpp"

namespace skein::mission_lab {

namespace {

constexpr double kLatest = 300;  // of cuts and of what is asked for besides [s]
constexpr int kFirstMeeting = 500;
constexpr double kGathering = 900;  // what a joint task may last, by the domain [s]

class MeetingDrawing {
 public:
  MeetingDrawing(std::uint64_t seed, const Kinds& kinds)
      : random_(seed, "random meetings"),
        joint_(seed, "random meetings: joint tasks"),
        kinds_(kinds) {
    mission_.seed = seed;
  }

  Mission draw() {
    mission_.limit = 3000;
    mission_.finish_after = 20;
    mission_.consistency = kinds_.consistency;
    if (kinds_.orders) mission_.separation = "{merge: true}";
    mission_.wind = "toward: " + tenths(random_.uniform(0, 6.2)) +
                    ", speed: " + tenths(random_.uniform(0, 4)) + ", gusts: 0.1";
    draw_uavs();
    draw_meetings();
    if (kinds_.gatherings) draw_gathering();
    for (std::size_t who = 0; who < mission_.team.size(); ++who) draw_work(who);
    for (std::size_t n = random_.below(4); n > 0; --n) draw_more();
    if (kinds_.radio) mission_.cuts = draw_cuts(random_, mission_.team, 4, kLatest);
    if (kinds_.deaths) add_deaths(mission_, kLatest);
    return std::move(mission_);
  }

 private:
  /// All who are in it send; those who receive wait for them.
  struct Drawn {
    std::vector<std::string> senders, receivers;
    bool has(const std::string& name) const {
      return std::count(senders.begin(), senders.end(), name) +
                 std::count(receivers.begin(), receivers.end(), name) >
             0;
    }
  };

  void draw_uavs() {
    const std::size_t count = 2 + random_.below(4);
    for (std::size_t i = 0; i < count; ++i) {
      Member one;
      one.name = "uav" + std::to_string(i + 1);
      const double drawn = random_.uniform();
      one.model = drawn < 0.5 ? "marvin" : drawn < 0.8 ? "heliv" : "karma";
      const double turn =
          2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
      one.more = "start: " + point(120 * std::cos(turn), 120 * std::sin(turn));
      one.altitude = kinds_.orders ? 40 : 35 + 20 * static_cast<double>(i);
      one.first_id = 1000 * static_cast<int>(i + 1);
      mission_.team.push_back(std::move(one));
    }
  }

  // Of some UAVs in common; one in five is a signal that its sender does not wait for.
  void draw_meetings() {
    for (std::size_t n = 1 + random_.below(4); n > 0; --n) {
      Drawn one;
      for (const Member& member : mission_.team)
        if (random_.chance(0.6)) one.senders.push_back(member.name);
      while (one.senders.size() < 2) {
        const std::string& name = mission_.team[random_.below(mission_.team.size())].name;
        if (!one.has(name)) one.senders.push_back(name);
      }
      one.receivers = one.senders;
      if (random_.chance(0.2)) one.senders.resize(1);
      meetings_.push_back(std::move(one));
    }
  }

  // Of the first two who hover, before one of their meetings.
  void draw_gathering() {
    std::vector<std::string> names;
    for (const Member& one : mission_.team)
      if (one.model != "karma" && names.size() < 2) names.push_back(one.name);
    if (names.size() < 2) return;
    const JointTask drawn = draw_joint_task(joint_, names);
    mission_.joint = true;
    mission_.places.insert(mission_.places.end(), drawn.places.begin(), drawn.places.end());
    gathering_ = {{names, names}, joint_.below(meetings_.size() + 1), drawn.words};
  }

  std::string new_place(double height) {
    const std::string name = (height > 0 ? "A" : "P") + std::to_string(mission_.places.size() + 1);
    mission_.places.push_back(name + ": [" + whole(random_.uniform(-50, 450)) + ", " +
                              whole(random_.uniform(-50, 450)) + ", " + whole(height) + "]");
    return name;
  }

  std::string a_task(const Member& one) {
    if (random_.chance(0.3)) return "[general-gotoxyz, " + new_place(one.altitude) + "]";
    return "[perceive, " + new_place(0) + ", " + whole(random_.uniform(10, 120)) + "]";
  }

  std::string by(double least, double most) {
    const bool bounded = kinds_.deadlines && random_.chance(0.25);
    return bounded ? "end_before: " + whole(random_.uniform(least, most)) : "";
  }

  // What lies before each of its meetings, and home. Now and then two are the other way round for
  // one of them: if others take part in both they wait for each other for ever.
  void draw_work(std::size_t who) {
    const Member& one = mission_.team[who];
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < meetings_.size(); ++i)
      if (meetings_[i].has(one.name)) order.push_back(i);
    if (kinds_.faults && order.size() > 1 && random_.chance(0.05))
      std::swap(order.front(), order.back());
    Step step;
    step.name = "first-" + one.name;
    step.when = "{time: " + whole(random_.uniform(3, 40)) + "}";
    step.uav = one.name;
    step.mission = static_cast<int>(who + 1);
    const int goal = 700 + 1000 * static_cast<int>(who);
    const auto add = [&](std::string words, std::string times = "") {
      step.tasks.push_back(
          {goal + static_cast<int>(step.tasks.size()), std::move(words), std::move(times)});
    };
    double later = 0;
    bool gathered = !gathering_ || !gathering_->who.has(one.name);
    const auto gather = [&](std::size_t until) {
      if (gathered || gathering_->before >= until) return;
      gathered = true;
      const bool bounded = kinds_.deadlines && joint_.chance(0.3);
      add(gathering_->words,
          bounded ? "end_before: " + whole(joint_.uniform(1000, 2000)) : std::string());
      later = kGathering;
    };
    for (const std::size_t i : order) {
      gather(i + 1);
      for (std::size_t n = random_.below(3); n > 0; --n) add(a_task(one));
      add("[synchro, " + std::to_string(kFirstMeeting + static_cast<int>(i)) + ", " + "[" +
              joined(meetings_[i].senders, ", ") + "], [" + joined(meetings_[i].receivers, ", ") +
              "]]",
          by(200 + later, 1200 + later));
    }
    gather(meetings_.size() + 1);
    if (step.tasks.empty()) add(a_task(one));
    add("[general-land]", by(400 + later, 1500 + later));
    mission_.steps.push_back(std::move(step));
  }

  // Somebody is asked for something besides, while others count on him.
  void draw_more() {
    static const std::vector<std::string> kPlacements{"", "first", "last", "in-time", "tour"};
    const std::size_t who = random_.below(mission_.team.size());
    const Member& one = mission_.team[who];
    Step step;
    step.name = "later-" + std::to_string(++more_);
    step.when = "{time: " + whole(random_.uniform(45, kLatest)) + "}";
    step.uav = one.name;
    step.mission = 10 + more_;
    step.placement = kPlacements[random_.below(kPlacements.size())];
    step.tasks.push_back({700 + 1000 * static_cast<int>(who) + 50 + more_, a_task(one), ""});
    mission_.steps.push_back(std::move(step));
  }

  /// A joint task, before so many of the meetings.
  struct Gathering {
    Drawn who;
    std::size_t before = 0;
    std::string words;
  };

  Random random_, joint_;
  Kinds kinds_;
  Mission mission_;
  std::vector<Drawn> meetings_;
  std::optional<Gathering> gathering_;
  int more_ = 0;
};

}  // namespace

Mission generate_meetings(std::uint64_t seed, const Kinds& kinds) {
  return MeetingDrawing(seed, kinds).draw();
}

}  // namespace skein::mission_lab
