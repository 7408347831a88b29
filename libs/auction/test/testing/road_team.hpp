// SPDX-License-Identifier: Apache-2.0
// Tasks and vehicles on a straight road, and sales among them without a network.
#pragma once

#include <cmath>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "skein/auction/auctioneer.hpp"
#include "skein/auction/bidder.hpp"
#include "skein/auction/catalogue.hpp"

namespace skein::auction {

inline MissionTime at(double seconds) { return MissionTime::seconds(seconds); }

/// Builder of a task on the road.
class RoadTask {
 public:
  explicit RoadTask(std::uint32_t number) { task_.number = TaskNumber(number); }
  RoadTask& at(double metres) { return task_.at = {metres, 0}, *this; }
  RoadTask& lasting(double seconds) { return task_.duration = seconds, *this; }
  RoadTask& from(double earliest) { return task_.earliest = earliest, *this; }
  RoadTask& by(double deadline) { return task_.deadline = deadline, *this; }
  RoadTask& needing(Abilities abilities) { return task_.needs = abilities, *this; }
  RoadTask& of_each(Abilities abilities) { return task_.needs_each = abilities, *this; }
  RoadTask& members(std::uint32_t least) { return task_.least_members = least, *this; }
  RoadTask& pinned(std::uint32_t member) { return task_.pinned = MemberNumber(member), *this; }
  RoadTask& not_for(std::uint32_t member) {
    return task_.forbidden.insert(MemberNumber(member)), *this;
  }
  RoadTask& repeatable() { return task_.repeatable = true, *this; }
  operator Task() const { return task_; }  // NOLINT: builders are what they build

 private:
  Task task_;
};

inline RoadTask a_task(std::uint32_t number) { return RoadTask(number); }

/// Drives at 1 m/s and 1 J/m; a plan ends where it began.
class RoadCraft : public Craft {
 public:
  RoadCraft(double begin, std::shared_ptr<const Catalogue> lot)
      : begin_(begin), lot_(std::move(lot)) {}
  Abilities abilities() const override { return able; }
  double free_from() const override { return free; }
  double energy() const override { return joules; }
  double energy_of(const Task&) const override { return work; }
  std::optional<Leg> leg(Stopover from, Stopover to) const override {
    for (const Stopover place : {from, to}) {
      if (!place.is_begin() && !place.is_end() && cut_off.contains(place.task())) return {};
    }
    const double way = std::abs(x(from) - x(to));
    return Leg{way, way, way};
  }
  std::optional<std::string> objection(const Task& task) const override {
    const auto found = objections.find(task.number);
    return found == objections.end() ? std::nullopt : std::optional(found->second);
  }

  Abilities able = 1;
  double free = 0;
  double joules = 1e6;
  double work = 0;
  std::set<TaskNumber> cut_off;
  std::map<TaskNumber, std::string> objections;

 private:
  double x(Stopover place) const {
    return place.is_begin() || place.is_end() ? begin_ : lot_->task(place.task()).at.x;
  }
  double begin_;
  std::shared_ptr<const Catalogue> lot_;
};

/// A sale among vehicles on the road: member i is crafts[i].
class RoadSale {
 public:
  RoadSale(Lot lot, std::vector<double> begins)
      : catalogue(std::make_shared<const Catalogue>(std::move(lot))) {
    for (std::uint32_t i = 0; i < begins.size(); ++i) {
      crafts.emplace_back(begins[i], catalogue);
      holdings.push_back({MemberNumber(i), {}, 0});
    }
  }

  std::unique_ptr<Auctioneer> auctioneer() const {
    return std::make_unique<Auctioneer>(
        SaleSetup{SaleNumber(7), catalogue, holdings, aim, limits, seed});
  }
  ToAuctioneer answer(const Send& send) const {
    return Bidder(send.to, crafts.at(send.to.value())).handle(send.message);
  }
  /// To the end. What `silent` members are sent is lost; time passes only where nobody speaks.
  void hold() {
    sale = auctioneer();
    now_ = at(0);
    carry_out(sale->start(now_));
    for (int step = 0; step < 100000 && !sale->ended(); ++step) {
      if (open_.empty()) {
        now_ = *sale->next_wakeup();
        carry_out(sale->tick(now_));
        continue;
      }
      const Send next = open_.front();
      open_.pop_front();
      if (!silent(next)) carry_out(sale->handle(answered(next), now_));
    }
  }
  std::vector<TaskNumber> route(std::size_t member) const { return sale->routes()[member].tasks; }

  std::shared_ptr<const Catalogue> catalogue;
  std::deque<RoadCraft> crafts;
  std::vector<Holding> holdings;
  Aim aim;
  SaleLimits limits;
  std::uint64_t seed = 1;
  std::function<bool(const Send&)> silent = [](const Send&) { return false; };
  std::function<ToAuctioneer(const Send&)> answered = [this](const Send& s) { return answer(s); };

  std::unique_ptr<Auctioneer> sale;
  std::vector<Send> sent;
  std::vector<Sold> sold;
  std::vector<Unsold> unsold;
  std::vector<Dropped> dropped;
  std::vector<Rejected> rejected;
  std::size_t ends = 0;

 private:
  void carry_out(const SaleEffects& effects) {
    for (const SaleEffect& effect : effects) {
      if (const auto* send = std::get_if<Send>(&effect)) open_.push_back(*send);
      keep(effect, sent), keep(effect, sold), keep(effect, unsold);
      keep(effect, dropped), keep(effect, rejected);
      ends += std::holds_alternative<Ended>(effect) ? 1 : 0;
    }
  }
  template <class Effect>
  static void keep(const SaleEffect& effect, std::vector<Effect>& where) {
    if (const auto* one = std::get_if<Effect>(&effect)) where.push_back(*one);
  }
  std::deque<Send> open_;
  MissionTime now_;
};

}  // namespace skein::auction
