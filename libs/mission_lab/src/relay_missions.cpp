// SPDX-License-Identifier: Apache-2.0
// Teams at degree 4 some of whom are heard past relays alone: links drawn at random, all others
// cut.
#include <algorithm>
#include <set>
#include <utility>

#include "parts.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/mission_lab/generate.hpp"

namespace skein::mission_lab {

namespace {

constexpr double kLatest = 250;  // of cuts and deaths [s]
constexpr int kFirstMeeting = 500;
const std::string kGround = "ground";

class RelayDrawing {
 public:
  RelayDrawing(std::uint64_t seed, const Kinds& kinds)
      : random_(seed, "random relaying mission"), kinds_(kinds) {
    mission_.seed = seed;
  }

  Mission draw() {
    mission_.limit = 3000;
    mission_.finish_after = 40;
    mission_.latency = random_.uniform(0.01, 0.15);
    mission_.wind = "toward: " + tenths(random_.uniform(0, 6.2)) +
                    ", speed: " + tenths(random_.uniform(0, 4)) + ", gusts: 0.1";
    draw_team();
    draw_links();
    draw_meetings();
    for (std::size_t who = 0; who < mission_.team.size(); ++who) draw_work(who);
    cut_the_rest();
    if (kinds_.radio) cut_some();
    if (kinds_.deaths) add_deaths(mission_, kLatest);
    return std::move(mission_);
  }

 private:
  using Link = std::pair<std::string, std::string>;  ///< both ways

  // The first is a relay, the last is heard past relays alone.
  void draw_team() {
    const std::size_t count = 2 + random_.below(5);
    for (std::size_t i = 0; i < count; ++i) {
      Member one;
      one.name = "uav" + std::to_string(i + 1);
      one.model = random_.chance(0.7) ? "marvin" : "heliv";
      one.more = "start: " + point(40 * static_cast<double>(i), -60);
      one.altitude = 35 + 15 * static_cast<double>(i);
      one.first_id = 1000 * static_cast<int>(i + 1);
      const bool relays = i == 0 || (i + 1 < count && random_.chance(0.6));
      if (relays) mission_.relays.push_back(one.name);
      mission_.team.push_back(std::move(one));
    }
  }

  // Everybody hears one who is connected already: the ground station, or a relay before it; and now
  // and then another besides.
  void draw_links() {
    std::vector<std::string> inner{kGround};
    for (const Member& one : mission_.team) {
      const bool is_last = one.name == mission_.team.back().name;
      const std::size_t least = is_last ? 1 : 0;  // not the ground station
      const std::size_t deeper = inner.size() - least;
      add_link(one.name, inner[least + random_.below(deeper)]);
      if (random_.chance(0.4)) add_link(one.name, inner[least + random_.below(deeper)]);
      const auto& relays = mission_.relays;
      if (std::ranges::find(relays, one.name) != relays.end()) inner.push_back(one.name);
    }
  }

  void add_link(const std::string& one, const std::string& other) {
    links_.insert(one < other ? Link{one, other} : Link{other, one});
  }

  bool has_link(const std::string& one, const std::string& other) const {
    return links_.contains(one < other ? Link{one, other} : Link{other, one});
  }

  void cut_the_rest() {
    std::vector<std::string> nodes{kGround};
    for (const Member& one : mission_.team) nodes.push_back(one.name);
    for (auto a = nodes.begin(); a != nodes.end(); ++a)
      for (auto b = std::next(a); b != nodes.end(); ++b)
        if (!has_link(*a, *b))
          mission_.cuts.push_back("{between: [" + *a + ", " + *b +
                                  "], from: 0, until: " + whole(mission_.limit + 1000) + "}");
  }

  // Of the links that there are, so that ways change, and at times there is none.
  void cut_some() {
    const std::vector<Link> links(links_.begin(), links_.end());
    for (std::size_t n = random_.below(4); n > 0; --n) {
      const Link& link = links[random_.below(links.size())];
      mission_.cuts.push_back(draw_cut(random_, link.first, link.second, kLatest));
    }
  }

  void draw_meetings() {
    for (std::size_t n = random_.below(3); n > 0; --n) {
      const std::size_t first = random_.below(mission_.team.size());
      const std::size_t other =
          (first + 1 + random_.below(mission_.team.size() - 1)) % mission_.team.size();
      meetings_.push_back({mission_.team[first].name, mission_.team[other].name});
    }
  }

  std::string a_task(const Member& one) {
    const bool looks = random_.chance(0.6);
    const std::string name = "P" + std::to_string(mission_.places.size() + 1);
    mission_.places.push_back(name + ": [" + whole(random_.uniform(-50, 450)) + ", " +
                              whole(random_.uniform(-50, 450)) + ", " +
                              whole(looks ? 0 : one.altitude) + "]");
    if (!looks) return "[general-gotoxyz, " + name + "]";
    return "[perceive, " + name + ", " + whole(random_.uniform(10, 90)) + "]";
  }

  void draw_work(std::size_t who) {
    const Member& one = mission_.team[who];
    Step step;
    step.name = "first-" + one.name;
    step.when = "{time: " + whole(random_.uniform(12, 40)) + "}";
    step.uav = one.name;
    step.mission = static_cast<int>(who + 1);
    const auto add = [&](std::string words) {
      const int goal = 700 + 1000 * static_cast<int>(who) + static_cast<int>(step.tasks.size());
      step.tasks.push_back({goal, std::move(words), ""});
    };
    add(a_task(one));
    for (std::size_t i = 0; i < meetings_.size(); ++i) {
      const auto& [a, b] = meetings_[i];
      if (one.name != a && one.name != b) continue;
      if (random_.chance(0.5)) add(a_task(one));
      const std::string both = "[" + a + ", " + b + "]";
      add("[synchro, " + std::to_string(kFirstMeeting + static_cast<int>(i)) + ", " + both + ", " +
          both + "]");
    }
    add("[general-land]");
    mission_.steps.push_back(std::move(step));
  }

  Random random_;
  Kinds kinds_;
  Mission mission_;
  std::set<Link> links_;
  std::vector<Link> meetings_;
};

}  // namespace

Mission generate_relays(std::uint64_t seed, const Kinds& kinds) {
  return RelayDrawing(seed, kinds).draw();
}

}  // namespace skein::mission_lab
