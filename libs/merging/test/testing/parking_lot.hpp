// SPDX-License-Identifier: Apache-2.0
// Vehicles that change places of which few are free.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "testing/net.hpp"

namespace skein::merging::testing {

/// Each vehicle stands at a place of its own and is sent to four others, one after the other; who
/// stands in whose way, and for how long, is judged from where they truly are.
class ParkingLot {
 public:
  ParkingLot(std::size_t vehicles, std::size_t places, Random& random)
      : places_(places), random_(random), net_(names_of(vehicles)) {
    for (std::size_t i = 0; i < vehicles; ++i) {
      cars_.push_back({names_of(vehicles)[i], i});
      net_.stands(cars_.back().name, place(i));
    }
    net_.run_for(0.1);
  }

  void step() {
    net_.step();
    now_ += 0.01;
    for (Car& car : cars_) drive(car);
    answer_those_asked_aside();
    look_for_circles();
  }

  bool is_done() const {
    return std::all_of(cars_.begin(), cars_.end(),
                       [](const Car& one) { return one.sent == kTrips && !one.aim && !one.flies; });
  }
  std::string both() const { return both_; }
  double longest_circle() const { return longest_circle_; }
  /// How often one went to stay where another had wanted to for long, and for longer than it.
  int passed() const { return passed_; }

 private:
  static constexpr int kTrips = 4;
  struct Car {
    std::string name;
    std::size_t at;
    int sent = 0;
    std::optional<std::size_t> aim = {};
    double since = 0;                       ///< it has wanted to get there
    std::vector<std::size_t> choices = {};  ///< as it told its merger
    std::optional<std::size_t> flies = {};  ///< to there
    double lands = 0, leaves = 0, circle = 0;
    std::optional<double> aside = {};  ///< it wants to get out of the way, since then
  };

  static std::vector<std::string> names_of(std::size_t vehicles) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < vehicles; ++i) names.push_back("u" + std::to_string(i));
    return names;
  }
  static Volume place(std::size_t i) {
    const double x = 100 * static_cast<double>(i);
    return {{x, 0}, {x, 0}, 5, 30, 50};
  }

  void want(Car& car, const std::vector<std::size_t>& places, bool aside) {
    car.choices = places;
    car.aside.reset();
    if (aside) car.aside = now_;
    std::vector<Volumes> choices;
    for (const std::size_t one : places) choices.push_back({place(one)});
    net_.forget_grant(car.name);
    net_.give(car.name, Want{choices, aside && car.aim ? Volumes{place(*car.aim)} : Volumes{}});
  }

  void drive(Car& car) {
    if (car.flies && now_ >= car.lands) {
      car.at = *car.flies;
      car.flies.reset();
      net_.give(car.name, Hold{{place(car.at)}});
      if (car.aim && *car.aim == car.at) car.aim.reset();
      if (car.aim) want(car, {*car.aim}, false);
      car.leaves = now_ + random_.uniform(0, 20);
    }
    if (!car.choices.empty() && net_.has_what_it_wanted(car.name)) {
      car.flies = car.choices[net_.choice_of(car.name)];
      car.aside.reset();
      car.choices.clear();
      car.lands = now_ + random_.uniform(5, 60);
      count_the_passed(car);
      if (both_.empty()) both_ = net_.both();
    }
    if (car.aside && !car.flies && now_ > *car.aside + 3) give_up_aside(car);
    if (car.flies || car.aim || car.sent == kTrips || now_ < car.leaves) return;
    car.aim = (car.at + 1 + random_.below(places_ - 1)) % places_;
    car.since = now_;
    ++car.sent;
    want(car, {*car.aim}, false);
  }

  void count_the_passed(const Car& goes) {
    constexpr double kLong = 250, kClearly = 10;  // [s]
    for (const Car& one : cars_) {
      if (one.flies || one.aim != goes.flies || now_ < one.since + kLong) continue;
      if (!goes.aim || one.since + kClearly < goes.since) ++passed_;
    }
  }

  void give_up_aside(Car& car) {
    if (car.aim) return want(car, {*car.aim}, false);
    car.choices.clear();
    car.aside.reset();
    net_.give(car.name, Withdraw{});
  }

  bool is_free(std::size_t at) const {
    return std::none_of(cars_.begin(), cars_.end(), [&](const Car& one) {
      return one.at == at || one.flies == at || one.aim == at;
    });
  }

  void answer_those_asked_aside() {
    const auto asked = net_.asked_aside();
    for (; answered_ < asked.size(); ++answered_) {
      Car& car = *std::find_if(cars_.begin(), cars_.end(),
                               [&](const Car& one) { return one.name == asked[answered_]; });
      std::vector<std::size_t> free;
      for (std::size_t i = 0; i < places_; ++i)
        if (is_free(i)) free.push_back(i);
      if (!free.empty() && car.aim && !car.flies) want(car, free, true);
    }
    make_room();
  }

  void make_room() {
    // Whoever has done all stays with nothing to do, and makes room.
    for (Car& car : cars_) {
      if (car.aim || car.flies || !car.choices.empty()) continue;
      const bool in_the_way = std::any_of(cars_.begin(), cars_.end(), [&](const Car& one) {
        return one.aim == car.at && !one.flies;
      });
      std::vector<std::size_t> free;
      for (std::size_t i = 0; i < places_; ++i)
        if (is_free(i)) free.push_back(i);
      if (in_the_way && !free.empty()) want(car, free, true);
    }
  }

  /// Along who stands where whom wants to go; it counts while a place is free to everybody.
  void look_for_circles() {
    const bool room = free_to_all();
    for (Car& car : cars_) {
      const Car* one = &car;
      bool circle = room;
      for (std::size_t n = 0; circle && n <= cars_.size(); ++n) {
        if (!one->aim || one->flies) circle = false;
        const auto next = std::find_if(cars_.begin(), cars_.end(), [&](const Car& other) {
          return circle && other.at == *one->aim && !other.flies;
        });
        if (next == cars_.end()) circle = false;
        if (circle) one = &*next;
        if (one == &car) break;
      }
      car.circle = circle && one == &car ? car.circle + 0.01 : 0;
      longest_circle_ = std::max(longest_circle_, car.circle);
    }
  }
  bool free_to_all() const {
    for (std::size_t i = 0; i < places_; ++i)
      if (is_free(i)) return true;
    return false;
  }

  std::size_t places_;
  Random& random_;
  Net net_;
  std::vector<Car> cars_;
  double now_ = 0.1, longest_circle_ = 0;
  int passed_ = 0;
  std::size_t answered_ = 0;
  std::string both_;
};

}  // namespace skein::merging::testing
