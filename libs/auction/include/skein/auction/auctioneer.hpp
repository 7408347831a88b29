// SPDX-License-Identifier: Apache-2.0
// The side of a sale that sells.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "skein/auction/aim.hpp"
#include "skein/auction/message.hpp"
#include "skein/foundation/time.hpp"

namespace skein::auction {

/// How long and how hard a sale is.
struct SaleLimits {
  Duration answer_within = Duration::seconds(2);  ///< who has not answered is left out of the round
  std::uint32_t together = 24;                    ///< tasks sold in one round
  std::uint32_t trade = 6;                        ///< tasks at most put back on sale together
  std::uint32_t called = 8;                       ///< members asked about a trade
  std::uint32_t orders = 8;  ///< orders of sale that winner determination tries
  std::uint32_t patience =
      0;  ///< rounds without gain that end the trades; 0: by the size of the lot
  std::uint32_t most_rounds = 0;  ///< of all; 0: by the size of the lot
};

/// What a member has already when a sale begins.
struct Holding {
  MemberNumber member;
  std::vector<TaskNumber> tasks;  ///< in order
  std::uint32_t fixed = 0;        ///< so many at the beginning are committed: they do not move
};

struct SaleSetup {
  SaleNumber sale;
  std::shared_ptr<const Catalogue> lot;
  std::vector<Holding> holdings;  ///< of all members that take part, one each
  Aim aim;
  SaleLimits limits;
  std::uint64_t seed = 1;  ///< of what is put back on sale
};

struct Send {
  MemberNumber to;
  ToMember message;
};

/// Who takes a task, and why them: what the whole comes to with them and with the next best group.
struct Sold {
  TaskNumber task;
  std::vector<MemberNumber> members;
  std::uint32_t round = 0;
  bool trade = false;  ///< it had members before
  Value value;         ///< of the whole, with the offers on which it was decided
  struct Rival {
    std::vector<MemberNumber> members;
    Value value;
  };
  std::optional<Rival> next_best;  ///< none: nobody else could
};

/// Nobody does it, with the reason of each.
struct Unsold {
  struct Reason {
    MemberNumber member;
    std::string why;
  };
  TaskNumber task;
  std::vector<Reason> reasons;
  std::string together;  ///< why not by several, if that is the question
};

/// Did not answer in time, or refused what it had offered to do.
struct Dropped {
  MemberNumber member;
  std::uint32_t round = 0;
  std::string why;
};

/// The lot contradicts itself: nothing is sold.
struct Rejected {
  std::vector<Contradiction> contradictions;
};

struct Ended {};  ///< nobody gains any more: the books are final

using SaleEffect = std::variant<Send, Sold, Unsold, Dropped, Rejected, Ended>;
using SaleEffects = std::vector<SaleEffect>;

/// Sells a lot by contract net: calls, offers, winners, awards; then puts a few tasks at a time
/// back on sale until nobody gains. What it books, all concerned have taken. Joint tasks have all
/// members or none. One setup and the same answers give the same sale, in whatever order they come
/// in a round. Source: spec 6.3; T VII.2.2.
class Auctioneer {
 public:
  explicit Auctioneer(SaleSetup setup);
  ~Auctioneer();
  Auctioneer(Auctioneer&&) noexcept;
  Auctioneer& operator=(Auctioneer&&) noexcept;

  SaleEffects start(MissionTime now);
  /// Of another sale or round, or said twice: without effect.
  SaleEffects handle(const ToAuctioneer& answer, MissionTime now);
  /// Goes on without who has not answered.
  SaleEffects tick(MissionTime now);
  std::optional<MissionTime> next_wakeup() const;

  bool ended() const;
  std::uint32_t rounds() const;
  struct Route {
    MemberNumber member;
    std::vector<TaskNumber> tasks;
    std::vector<double> starts;  ///< of each task [s]
    double end = 0;              ///< of its plan, the way to its end included [s]
    double cost = 0;
  };
  /// The books, by member.
  std::vector<Route> routes() const;
  Value value() const;

 private:
  class Core;
  std::unique_ptr<Core> core_;
};

}  // namespace skein::auction
