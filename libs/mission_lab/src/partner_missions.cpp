// SPDX-License-Identifier: Apache-2.0
// UAVs at degree 4 with joint tasks and synchronisations, of whom one dies, is cut off or stays
// away, in whatever phase of them.
#include <cmath>
#include <numbers>
#include <optional>

#include "parts.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/mission_lab/generate.hpp"

namespace skein::mission_lab {

namespace {

constexpr double kAllGiven = 12;     // by then all have their missions [s]
constexpr double kLatestLoss = 420;  // of what befalls a partner [s]

class PartnerDrawing {
 public:
  PartnerDrawing(std::uint64_t seed, const Kinds& kinds)
      : random_(seed, "random partners"), kinds_(kinds) {
    mission_.seed = seed;
  }

  Mission draw() {
    mission_.limit = 2400;
    mission_.finish_after = -1;  // the goals of who dies are never settled
    mission_.partner_lease = random_.chance(0.3) ? 600 : random_.uniform(60, 400);
    mission_.wind = "toward: " + tenths(random_.uniform(0, 6.2)) +
                    ", speed: " + tenths(random_.uniform(0, 3)) + ", gusts: 0.1";
    draw_uavs();
    const bool joint = random_.chance(0.6) && kinds_.joint;
    if (joint) joint_ = draw_joint_task(random_, {"uav1", "uav2"});
    meets_ = !joint || random_.chance(0.6);
    mission_.joint = joint;
    mission_.places.insert(mission_.places.end(), joint_.places.begin(), joint_.places.end());
    before_ = random_.chance(0.5);
    if (kinds_.changes && random_.chance(0.1)) stays_away_ = random_.below(mission_.team.size());
    for (std::size_t who = 0; who < mission_.team.size(); ++who) draw_work(who);
    if (kinds_.radio || kinds_.deaths) draw_trouble();
    return std::move(mission_);
  }

 private:
  void draw_uavs() {
    const std::size_t count = 2 + random_.below(2);
    for (std::size_t i = 0; i < count; ++i) {
      Member one;
      one.name = "uav" + std::to_string(i + 1);
      one.model = random_.chance(0.6) ? "marvin" : "heliv";
      const double turn =
          2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
      one.more = "start: " + point(80 * std::cos(turn), 80 * std::sin(turn));
      one.altitude = 35 + 20 * static_cast<double>(i);
      one.first_id = 1000 * static_cast<int>(i + 1);
      mission_.team.push_back(std::move(one));
    }
  }

  std::string a_task() {
    return "[perceive, " + add_place(random_, mission_) + ", " + whole(random_.uniform(10, 90)) +
           "]";
  }

  std::string a_meeting() const {
    std::vector<std::string> names;
    for (const Member& one : mission_.team) names.push_back(one.name);
    const std::string all = "[" + joined(names, ", ") + "]";
    return "[synchro, 500, " + all + ", " + all + "]";
  }

  // The joint task and the meeting in one order for all.
  void draw_work(std::size_t who) {
    const bool jointly = mission_.joint && who < 2;
    Step step;
    step.name = "first-" + mission_.team[who].name;
    step.when = "{time: " + whole(random_.uniform(3, kAllGiven)) + "}";
    step.uav = mission_.team[who].name;
    step.mission = static_cast<int>(who + 1);
    const auto add = [&](std::string words) {
      const int goal = 700 + 1000 * static_cast<int>(who) + static_cast<int>(step.tasks.size());
      step.tasks.push_back({goal, std::move(words), ""});
    };
    for (std::size_t n = random_.below(3); n > 0; --n) add(a_task());
    if (jointly && before_) add(joint_.words);
    if (meets_ && stays_away_ != who) add(a_meeting());
    if (jointly && !before_) add(joint_.words);
    if (random_.chance(0.4)) add(a_task());
    add("[general-land]");
    mission_.steps.push_back(std::move(step));
  }

  // While their missions are given and roles are negotiated, or on the way and later.
  double an_instant() {
    return random_.chance(0.3) ? random_.uniform(2, 1.5 * kAllGiven)
                               : random_.uniform(10, kLatestLoss);
  }

  void draw_trouble() {
    const std::string& who = mission_.team[random_.below(mission_.team.size())].name;
    const double at = an_instant();
    const std::size_t kind = random_.below(kinds_.deaths ? 4 : 1);
    if (kind == 0) return cut_off(who, at);
    std::string dies = "{at: " + tenths(at) + ", kill: " + who;
    if (kind == 1) dies += ", restart_after: " + tenths(random_.uniform(5, 500));
    mission_.faults.push_back(dies + "}");
    if (kind == 3) declare_lost(who, at + random_.uniform(5, 200));
  }

  void cut_off(const std::string& who, double from) {
    const double until = from + random_.uniform(20, 900);
    add_cut_off(mission_, who, from, until, random_.chance(0.5));
  }

  void declare_lost(const std::string& who, double at) {
    Step step;
    step.name = "lost";
    step.when = "{time: " + whole(at) + "}";
    step.action = "declare_lost: {uav: " + who + "}";
    mission_.steps.push_back(std::move(step));
  }

  Random random_;
  Kinds kinds_;
  Mission mission_;
  JointTask joint_;
  bool meets_ = true, before_ = false;
  std::optional<std::size_t> stays_away_;  ///< from the meeting
};

}  // namespace

Mission generate_partners(std::uint64_t seed, const Kinds& kinds) {
  return PartnerDrawing(seed, kinds).draw();
}

}  // namespace skein::mission_lab
