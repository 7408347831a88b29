// SPDX-License-Identifier: Apache-2.0
// UAVs at degree 4 that map areas together, some of them two areas one after the other, while links
// are cut, daemons die, operators take one in hand and air closes over the area.
#include <array>
#include <cmath>
#include <numbers>

#include "parts.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/mission_lab/generate.hpp"

namespace skein::mission_lab {

namespace {

constexpr double kAllGiven = 15;             // by then most have their missions [s]
constexpr double kLatest = 900;              // of troubles [s]
constexpr double kEast = 450, kNorth = 300;  // of the middle of all [m]
constexpr int kGoalsOfEach = 1000;

class SharingDrawing {
 public:
  SharingDrawing(std::uint64_t seed, const Kinds& kinds)
      : random_(seed, "random shared mappings"), kinds_(kinds) {
    mission_.seed = seed;
  }

  Mission draw() {
    mission_.limit = 3600;
    mission_.finish_after = kinds_.deaths ? -1 : 30;  // the goals of who dies are never settled
    mission_.partner_lease = random_.chance(0.3) ? 600 : random_.uniform(60, 400);
    mission_.separation = kinds_.merged && random_.chance(0.7) ? "{merge: true}" : "";
    mission_.wind = "toward: " + tenths(random_.uniform(0, 6.2)) +
                    ", speed: " + tenths(random_.uniform(0, 3)) + ", gusts: 0.1";
    mission_.joint = true;
    mission_.interaction = "cooperative-mapping";
    draw_team();
    mission_.places.push_back("H: [0, 0, 0]");  // of all: it is part of what they agree on
    add_area(0);
    if (random_.chance(0.4)) add_area(1);
    const bool contrary = kinds_.changes && random_.chance(0.2);
    const bool stays_away = kinds_.changes && random_.chance(0.15);
    for (std::size_t who = 0; who < mission_.team.size(); ++who)
      draw_work(who, contrary && who == 0, stays_away && who + 1 == mission_.team.size());
    if (kinds_.radio) add_radio_troubles(random_, mission_, kLatest);
    if (kinds_.degrees && random_.chance(0.4)) add_hands(random_, mission_, any().name, kLatest);
    if (kinds_.air && random_.chance(0.2))
      add_closing_air(random_, mission_, kEast, kNorth, kLatest);
    if (kinds_.faults && random_.chance(0.2))
      mission_.faults.push_back(draw_fault(
          random_, any().name, [](Random&) { return std::string("mapping"); }, kLatest));
    if (kinds_.deaths) add_death_of_one(random_, mission_, kLatest);
    return std::move(mission_);
  }

 private:
  const Member& any() { return any_of(random_, mission_); }

  void draw_team() {
    static constexpr std::array kModels{"heron", "wren", "swift"};
    const std::size_t count = 2 + random_.below(3);
    for (std::size_t i = 0; i < count; ++i) {
      const double turn =
          2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
      Member one;
      one.name = "uav" + std::to_string(i + 1);
      one.model = kModels[random_.below(kModels.size())];
      one.folder = "area-sharing";
      one.more = "start: " + point(kEast + 420 * std::cos(turn), kNorth + 420 * std::sin(turn));
      if (random_.chance(0.5)) one.more += contact_loss("return", 300);
      if (kinds_.energy && random_.chance(0.15))
        one.more += ", energy: " + hundredths(random_.uniform(0.3, 0.8));
      one.altitude = 40 + 25 * static_cast<double>(i);
      one.first_id = kGoalsOfEach * static_cast<int>(i + 1);
      mission_.team.push_back(std::move(one));
    }
  }

  // Zones are named as people name them. The second one is for some of those of the first.
  void add_area(std::size_t which) {
    static constexpr std::array kNames{"field", "Z1", "OstWiese", "zone-2", "west"};
    const std::string name = std::string(kNames[random_.below(kNames.size())]) +
                             (which == 0 ? "" : "b"),
                      place = "C" + std::to_string(which + 1);
    const double x = kEast + random_.uniform(-120, 120), y = kNorth + random_.uniform(-80, 80);
    mission_.zones.push_back(name + ": " +
                             rectangle(x, y, random_.uniform(80, 260), random_.uniform(80, 220)));
    mission_.places.push_back(place + ": [" + whole(x) + ", " + whole(y) + ", 0]");
    Area area;
    area.members = 2 + random_.below(mission_.team.size() - 1);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < area.members; ++i) names.push_back(mission_.team[i].name);
    area.words = "[cooperative-mapping, " + name + ", " + place + ", H, " +
                 whole_between(random_, 200, 1200) + ", [" + joined(names, ", ") + "]]";
    areas_.push_back(std::move(area));
  }

  struct Area {
    std::string words;
    std::size_t members = 0;
  };

  std::string a_task() {
    return "[perceive, " + add_place(random_, mission_) + ", " + whole(random_.uniform(10, 60)) +
           "]";
  }

  void draw_work(std::size_t who, bool contrary, bool stays_away) {
    Step step;
    step.name = "first-" + mission_.team[who].name;
    const double latest = random_.chance(0.2) ? 150 : kAllGiven;
    step.when = "{time: " + whole(random_.uniform(3, latest)) + "}";
    step.uav = mission_.team[who].name;
    step.mission = static_cast<int>(who + 1);
    const auto add = [&](std::string words) {
      const int goal =
          700 + kGoalsOfEach * static_cast<int>(who) + static_cast<int>(step.tasks.size());
      step.tasks.push_back({goal, std::move(words), ""});
    };
    if (random_.chance(0.3)) add(a_task());
    std::vector<std::string> shared;
    for (const Area& area : areas_) {
      if (who >= area.members || (stays_away && &area == &areas_.front())) continue;
      shared.push_back(area.words);
    }
    if (contrary) std::swap(shared.front(), shared.back());
    for (std::string& words : shared) {
      add(std::move(words));
      if (random_.chance(0.2)) add(a_task());
    }
    add("[general-land]");
    mission_.steps.push_back(std::move(step));
  }

  Random random_;
  Kinds kinds_;
  Mission mission_;
  std::vector<Area> areas_;
};

}  // namespace

Mission generate_sharing(std::uint64_t seed, const Kinds& kinds) {
  return SharingDrawing(seed, kinds).draw();
}

}  // namespace skein::mission_lab
