// SPDX-License-Identifier: Apache-2.0
// UAVs at degree 4 over whose places, pads, areas and ways air closes for a time: by the scenario,
// or by an operator while they fly.
#include <array>

#include "parts.hpp"
#include "skein/mission_lab/generate.hpp"

namespace skein::mission_lab {

namespace {

constexpr double kLatestClosing = 400;  // of what closes later [s]
constexpr int kIdsOfEach = 1000;

struct FlownCraft {
  const char *model, *folder;
  bool maps;
};
constexpr std::array<FlownCraft, 7> kFlownCrafts{{{"marvin", "comets", false},
                                                  {"heliv", "comets", false},
                                                  {"karma", "comets", true},
                                                  {"plane", "../tests/random_missions", true},
                                                  {"heron", "area-sharing", true},
                                                  {"swift", "area-sharing", true},
                                                  {"ressac", "action", false}}};

class ClosureDrawing {
 public:
  ClosureDrawing(std::uint64_t seed, const Kinds& kinds)
      : random_(seed, "random mission under air that closes"), kinds_(kinds) {
    mission_.seed = seed;
  }

  Mission draw() {
    mission_.limit = 3000;
    mission_.finish_after = kinds_.deaths ? -1 : 30;  // the goals of who dies are never settled
    mission_.separation = kinds_.merged && random_.chance(0.4) ? "{merge: true}" : "";
    mission_.wind = "toward: " + tenths(random_.uniform(0, 6.2)) +
                    ", speed: " + tenths(random_.uniform(0, 4)) + ", gusts: 0.2";
    const std::size_t count = 1 + random_.below(4);
    for (std::size_t who = 0; who < count; ++who) add_uav(who);
    for (std::size_t who = 0; who < count; ++who) draw_work(who);
    for (std::size_t n = 1 + random_.below(5); n > 0; --n) close(n);
    if (kinds_.radio && random_.chance(0.3))
      mission_.cuts = draw_cuts(random_, mission_.team, 3, kLatestClosing);
    if (kinds_.faults && random_.chance(0.3))
      mission_.faults.push_back(draw_refusals(
          random_, mission_.team[random_.below(mission_.team.size())].name, kLatestClosing));
    if (kinds_.deaths) add_deaths(mission_, kLatestClosing);
    return std::move(mission_);
  }

 private:
  void add_uav(std::size_t who) {
    const FlownCraft& kind = kFlownCrafts[random_.below(kFlownCrafts.size())];
    kinds_of_.push_back(&kind);
    Member one;
    one.name = "uav" + std::to_string(who + 1);
    one.model = kind.model;
    one.folder = kind.folder;
    const double x = 120 * static_cast<double>(who), y = random_.uniform(-60, 60);
    pads_.emplace_back(x, y);
    one.more = "start: " + point(x, y);
    if (kinds_.energy && random_.chance(0.15))
      one.more += ", energy: " + hundredths(random_.uniform(0.2, 0.5));
    one.altitude = 40 + 20 * static_cast<double>(who);
    one.first_id = kIdsOfEach * static_cast<int>(who + 1);
    mission_.team.push_back(std::move(one));
  }

  std::string tour() {
    std::string places = add_place(random_, mission_);
    for (std::size_t n = 1 + random_.below(5); n > 0; --n)
      places += ", " + add_place(random_, mission_);
    return "[perform-tour, [" + places + "]]";
  }

  std::string a_zone() {
    const std::string name = "Z" + std::to_string(mission_.zones.size() + 1);
    mission_.zones.push_back(name + ": " + draw_zone(random_));
    return name;
  }

  std::string a_task(std::size_t who) {
    switch (random_.below(kinds_of_[who]->maps ? 7 : 6)) {
      case 0:
      case 1:
        return tour();
      case 2:
        return "[general-gotoxyz, " + add_place(random_, mission_) + "]";
      case 3:
        return "[perform-monitoring, " + add_place(random_, mission_) + ", " +
               whole_between(random_, 20, 90) + "]";
      case 4:
        return "[general-wait, " + draw_length(random_) + "]";
      case 6:
        return "[perform-mapping, " + a_zone() + "]";
      default:
        return "[perceive, " + add_place(random_, mission_) + ", " + draw_length(random_) + "]";
    }
  }

  // In up to two missions: the second comes when some air has closed.
  void draw_work(std::size_t who) {
    give(who, "first-", random_.uniform(3, 40), 1 + random_.below(4));
    if (random_.chance(0.3))
      give(who, "then-", random_.uniform(60, kLatestClosing), 1 + random_.below(2));
  }

  void give(std::size_t who, const std::string& name, double at, std::size_t tasks) {
    Step step;
    step.name = name + mission_.team[who].name;
    step.when = "{time: " + whole(at) + "}";
    step.uav = mission_.team[who].name;
    step.mission = 1 + static_cast<int>(mission_.steps.size());
    const auto add = [&](std::string words) {
      const int goal = 700 + kIdsOfEach * static_cast<int>(who) + given_++;
      Task task{goal, std::move(words), ""};
      if (kinds_.deadlines && random_.chance(0.1)) task.times = draw_times(random_);
      step.tasks.push_back(std::move(task));
    };
    for (; tasks > 0; --tasks) add(a_task(who));
    if (random_.chance(0.7)) add("[general-land]");
    mission_.steps.push_back(std::move(step));
  }

  // Over a pad, a place of somebody's, or half-way to one from a pad.
  std::pair<double, double> somewhere() {
    const auto pad = pads_[random_.below(pads_.size())];
    if (mission_.places.empty() || random_.chance(0.25)) return pad;
    const auto place = draw_place_of(random_, mission_);
    const double share = random_.chance(0.5) ? 1 : 0.5;
    return {pad.first + share * (place.first - pad.first),
            pad.second + share * (place.second - pad.second)};
  }

  // From the start, for a while as everybody knows before, or when an operator says so. One of ten
  // does not open again.
  void close(std::size_t number) {
    const auto [x, y] = somewhere();
    const std::string volume = draw_box(random_, x, y), n = std::to_string(number);
    const double from = random_.chance(0.3) ? 0 : random_.uniform(20, kLatestClosing);
    const double lasts = random_.uniform(20, 500);
    const bool opens = random_.chance(0.9);
    if (!kinds_.air || random_.chance(0.6)) {
      mission_.volumes.push_back("V" + n + ": {" + volume + ", from: " + whole(from) +
                                 (opens ? ", until: " + whole(from + lasts) : "") + "}");
      return;
    }
    const std::string closes = "close-" + n, smoke = "{name: smoke-" + n;
    add_action(mission_, closes, "{time: " + whole(5 + from) + "}", 0,
               "close_air: " + smoke + ", " + volume + "}");
    if (opens)
      add_action(mission_, "open-" + n, "{step: " + closes + "}", lasts,
                 "open_air: " + smoke + "}");
  }

  Random random_;
  Kinds kinds_;
  Mission mission_;
  std::vector<const FlownCraft*> kinds_of_;  ///< by member
  std::vector<std::pair<double, double>> pads_;
  int given_ = 0;
};

}  // namespace

Mission generate_closures(std::uint64_t seed, const Kinds& kinds) {
  return ClosureDrawing(seed, kinds).draw();
}

}  // namespace skein::mission_lab
