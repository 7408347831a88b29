// SPDX-License-Identifier: Apache-2.0
// Implementation of Auctioneer.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "draft.hpp"
#include "skein/auction/auctioneer.hpp"
#include "trade_picker.hpp"
#include "winners.hpp"

namespace skein::auction {

/// | from     | when                                    | to                                    |
/// |----------|-----------------------------------------|---------------------------------------|
/// | idle     | start, the lot is sound                 | calling                               |
/// | calling  | all called have answered, or time is up | awarding if it gains, else next round |
/// | awarding | all winners took their routes           | books changed, next round             |
/// | awarding | one refused or is silent                | books as before, next round           |
/// | any      | next round, and nobody gains any more   | ended                                 |
class Auctioneer::Core {
 public:
  explicit Core(SaleSetup setup);
  void start(MissionTime now, SaleEffects& effects);
  void on_offer(const Offer& offer, MissionTime now, SaleEffects& effects);
  void on_answer(const Answer& answer, MissionTime now, SaleEffects& effects);
  void tick(MissionTime now, SaleEffects& effects);

  bool ended() const { return phase_ == Phase::kEnded; }
  std::uint32_t rounds() const { return round_; }
  Value value() const { return value_; }
  std::optional<MissionTime> next_wakeup() const;
  SaleNumber number() const { return setup_.sale; }
  std::vector<Auctioneer::Route> routes() const;

 private:
  enum class Phase { kIdle, kCalling, kAwarding, kEnded };
  // The allocation that a round would lead to, not booked before all winners accept.
  struct Deal {
    Draft draft;
    std::vector<std::size_t> routes;  ///< for each route of the draft, its index in members_
    std::vector<Decided> decided;
    std::map<std::size_t, Answer> taken;  ///< acceptances, by index in members_
    std::set<std::size_t> awaited;        ///< members that have not answered their award
  };
  struct Member {
    BookedRoute route;
    std::vector<double> starts;
    double cost = 0, end = 0, ends = 0;
    bool present = true;                           ///< false: did not answer a call or an award
    std::map<TaskNumber, std::string> objections;  ///< reasons why it cannot do a task
    std::set<TaskNumber> vetoes;                   ///< it bid for them, won and refused the award
    Abilities abilities = 0;
  };

  bool makes_sense(const Offer& offer, std::size_t member) const;
  bool has_legs(const Answer& answer, std::size_t member) const;
  void next_round(MissionTime now, SaleEffects& effects);
  void call(MissionTime now, SaleEffects& effects);
  void decide(MissionTime now, SaleEffects& effects);
  Deal draft_deal();
  void add_routes(Deal& deal);
  void award(Deal deal, MissionTime now, SaleEffects& effects);
  void close_deal(MissionTime now, SaleEffects& effects);
  void drop_deal(MissionTime now, SaleEffects& effects);
  void book(const Deal& deal);
  void tell_sold(const Deal& deal, SaleEffects& effects) const;
  void tell_hopeless(SaleEffects& effects);
  std::optional<Unsold> hopeless(const Task& task) const;
  void finish(SaleEffects& effects);
  void open_answers(MissionTime now);
  void sell_all_anew();
  void send(std::size_t member, ToMember message, SaleEffects& effects);
  std::set<std::size_t>& awaited() { return phase_ == Phase::kCalling ? awaited_ : deal_->awaited; }
  void drop(std::size_t member, const char* why, SaleEffects& effects);
  std::size_t last_to_end() const;
  std::vector<TaskNumber> held() const;
  std::vector<BookedRoute> books() const;
  std::vector<MemberNumber> members_of(const Draft& draft, const Placing& placing) const;

  SaleSetup setup_;
  TradePicker picker_;
  Phase phase_ = Phase::kIdle;
  std::vector<Member> members_;
  std::map<MemberNumber, std::size_t> index_;
  std::vector<TaskNumber> to_sell_;    ///< on sale in a later round, in order
  std::vector<TaskNumber> left_over_;  ///< on sale before and not sold
  std::set<TaskNumber> had_members_;   ///< sold before, or held when the sale began
  std::uint32_t round_ = 0, without_gain_ = 0;
  MissionTime closes_, say_again_;
  std::map<std::size_t, ToMember> said_;  ///< last message of this phase by member, for repetition
  std::vector<TaskNumber> items_;         ///< on sale in this round
  bool selling_ = false;                  ///< the round sells tasks without members; else it trades
  std::set<std::size_t> awaited_;
  std::map<std::size_t, Offer> offers_;
  std::map<std::size_t, BookedRoute> without_items_;
  std::optional<Deal> deal_;
  Value value_;
};

}  // namespace skein::auction
