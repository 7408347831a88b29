// SPDX-License-Identifier: Apache-2.0
// The auctioneer of a contract-net sale.
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

/// Time and effort spent on a sale.
struct SaleLimits {
  Duration answer_within = Duration::seconds(2);  ///< members without an answer miss the round
  std::uint32_t together = 24;                    ///< most tasks sold in one round
  std::uint32_t trade = 6;                        ///< most tasks put back on sale together
  std::uint32_t called = 8;                       ///< members asked about a trade
  std::uint32_t orders = 8;  ///< orders of the tasks that winner determination tries
  std::uint32_t patience =
      0;  ///< trading ends after so many rounds without gain; 0: by the size of the lot
  std::uint32_t most_rounds = 0;  ///< of the whole sale; 0: by the size of the lot
};

/// The tasks a member already has when the sale begins.
struct Holding {
  MemberNumber member;
  std::vector<TaskNumber> tasks;  ///< in order
  std::uint32_t fixed = 0;        ///< the first `fixed` of them are committed and stay
};

struct SaleSetup {
  SaleNumber sale;
  std::shared_ptr<const Catalogue> lot;
  std::vector<Holding> holdings;  ///< of all members that take part, one each
  Aim aim;
  SaleLimits limits;
  std::uint64_t seed = 1;  ///< of the random choice of tasks put back on sale
};

struct Send {
  MemberNumber to;
  ToMember message;
};

/// Who takes a task and why: the value of the whole allocation with the winners, and with the next
/// best group.
struct Sold {
  TaskNumber task;
  std::vector<MemberNumber> members;
  std::uint32_t round = 0;
  bool trade = false;  ///< the task was sold before
  Value value;         ///< of the whole allocation, from the offers of this round
  struct Rival {
    std::vector<MemberNumber> members;
    Value value;
  };
  std::optional<Rival> next_best;  ///< none: nobody else could
};

/// No member can do the task; with each member's reason.
struct Unsold {
  struct Reason {
    MemberNumber member;
    std::string why;
  };
  TaskNumber task;
  std::vector<Reason> reasons;
  std::string together;  ///< of a joint task: why no group can do it
};

/// A member that did not answer in time, or refused an award after its own offer.
struct Dropped {
  MemberNumber member;
  std::uint32_t round = 0;
  std::string why;
};

/// The lot contradicts itself (contradictions()): nothing is sold.
struct Rejected {
  std::vector<Contradiction> contradictions;
};

struct Ended {};  ///< no trade gains any more: the allocation is final

using SaleEffect = std::variant<Send, Sold, Unsold, Dropped, Rejected, Ended>;
using SaleEffects = std::vector<SaleEffect>;

/// Sells a lot by contract net: calls, offers, winner determination, awards. Then trades: puts a
/// few tasks at a time back on sale until no exchange gains. A route is booked once every member
/// concerned has accepted its award. A joint task gets all of its members or none. Deterministic:
/// the same setup and answers give the same sale, in whatever order answers arrive within a round.
/// Source: spec 6.3; T VII.2.2.
class Auctioneer {
 public:
  explicit Auctioneer(SaleSetup setup);
  ~Auctioneer();
  Auctioneer(Auctioneer&&) noexcept;
  Auctioneer& operator=(Auctioneer&&) noexcept;

  SaleEffects start(MissionTime now);
  /// An answer of another sale or round, or a repeated one, has no effect.
  SaleEffects handle(const ToAuctioneer& answer, MissionTime now);
  /// Closes the round without the members that have not answered, once its time is over.
  SaleEffects tick(MissionTime now);
  std::optional<MissionTime> next_wakeup() const;

  bool ended() const;
  std::uint32_t rounds() const;
  struct Route {
    MemberNumber member;
    std::vector<TaskNumber> tasks;
    std::vector<double> starts;  ///< of each task [s]
    double end = 0;              ///< when its plan ends, the way to its final place included [s]
    double cost = 0;
  };
  /// The current allocation, by member.
  std::vector<Route> routes() const;
  Value value() const;

 private:
  class Core;
  std::unique_ptr<Core> core_;
};

}  // namespace skein::auction
