// SPDX-License-Identifier: Apache-2.0
// Plan merging on one UAV: reserves the air of its next way.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "skein/foundation/repeats.hpp"
#include "skein/foundation/rising.hpp"
#include "skein/foundation/time.hpp"
#include "skein/merging/former_life.hpp"
#include "skein/merging/message.hpp"
#include "skein/merging/peers.hpp"
#include "skein/merging/standby.hpp"

namespace skein::merging {

// ---- inputs ----

/// A message arrived from another member, or from the witness.
struct Heard {
  std::string from;
  Message message;
};
/// Whether `peer` is in radio reach. Peers count as reachable until told otherwise.
struct InReach {
  std::string peer;
  bool reachable = true;
};
/// This UAV wants to reserve one of `choices`: the first that can be granted, as a whole, in
/// addition to what it holds. Replaces the previous Want.
struct Want {
  std::vector<Volumes> choices;
  /// For a UAV that moves aside (MoveAside), or comes back from there: the way it will ask for
  /// next. Its waiting time for that way goes on counting meanwhile.
  Volumes afterwards = {};
  /// The way ends in a landing, after which the UAV holds no air. Peers that have waited long do
  /// not take precedence over it, since they gain nothing if it waits.
  bool leaves = false;
};
/// This UAV wants no reservation any more.
struct Withdraw {};
/// What this UAV holds from now on: a part of what it was granted, or the air where it is anyway.
struct Hold {
  Volumes volumes;
};
/// Ways home, one of which the witness shall keep free for when this UAV can ask nobody (Standby);
/// empty: none. Without a witness it has no effect.
struct Need {
  std::vector<Volumes> choices;
};
/// This is the node's first life, so there are no promises of an earlier life that it forgot.
/// Without this input the merger assumes that there may be, and accepts no grant of the witness on
/// behalf of a peer that has not answered it in this life.
struct FirstLife {};
/// Time passes.
struct Tick {};
using Input = std::variant<Heard, InReach, Want, Withdraw, Hold, Need, FirstLife, Tick>;

// ---- effects, in their order ----

struct Tell {
  std::string to;
  Message message;
};
/// The UAV holds this choice of its Want from now on, which is thereby done. The reservation stays
/// valid whatever happens to the radio, until a Hold gives it back.
struct Granted {
  std::size_t choice = 0;
};
/// What a peer has to do before this UAV may fly.
enum class Awaited : std::uint8_t {
  kToLeave,          ///< it holds air that is wanted
  kToTell,           ///< it has not told yet what it holds
  kToComeIntoReach,  ///< the same, and it is out of reach
  kToBeAnswered,     ///< it asked earlier for overlapping air and has precedence
  kToGoFirst         ///< it has waited so long that it takes precedence (Limits::pressing)
};
/// "to leave", "to come into reach", …
std::string_view to_text(Awaited what);

/// Whom the UAV waits for and why; sent whenever that changes.
struct Waits {
  struct Why {
    std::string peer;
    Awaited what = Awaited::kToLeave;
    bool operator==(const Why&) const = default;
  };
  std::vector<Why> whys;
  std::vector<Why> afterwards = {};  ///< who is in the way of what it wants afterwards (Want)

  /// Peers that have to leave.
  std::vector<std::string> to_leave() const;
  /// The same, and those that have precedence since they have waited long.
  std::vector<std::string> in_its_way() const;
  bool operator==(const Waits&) const = default;
};
/// Members wait for each other in a circle, and this UAV has to break it: it should want to move
/// somewhere else first, and then its original way again.
struct MoveAside {
  std::vector<std::string> circle;  ///< beginning with this UAV
  /// A member of the circle is out of reach and would not notice: moving aside makes sense only if
  /// this UAV's own way becomes free by it.
  bool for_itself = false;
};
using Effect = std::variant<Tell, Granted, Waits, MoveAside>;
using Effects = std::vector<Effect>;

struct Limits {
  Duration patience = Duration::milliseconds(2'000);  ///< until an unanswered request is given up
  Duration repeat =
      Duration::milliseconds(300);               ///< until a request is repeated; doubled each time
  Duration again = Duration::milliseconds(250);  ///< from a refusal to the next request
  /// Until the own claim is told again to a peer that has not said that it has it; then twice as
  /// long each time, at most `pause`.
  Duration beat = Duration::milliseconds(1'000);
  Duration pause = Duration::milliseconds(8'000);
  Duration circle = Duration::milliseconds(400);   ///< a circle of waits counts after this time
  Duration next = Duration::milliseconds(300);     ///< until its next member has to move aside
  Duration moves = Duration::milliseconds(1'000);  ///< between two MoveAside to the same member
  /// After waiting this long a member takes precedence: others do not come to stay in air that it
  /// wants.
  Duration pressing = Duration::milliseconds(240'000);
  Duration clearly = Duration::milliseconds(5'000);  ///< differences of waiting times that count

  /// Whether a member that has wanted something since `since` (nothing: it wants nothing) takes
  /// precedence.
  bool presses(const std::optional<MissionTime>& since, MissionTime now) const {
    return since && now >= *since + pressing;
  }
  /// Of two that want something since then and press, the first has waited longer; where that is
  /// not clear to both, the earlier of the roster has.
  bool longer(const std::optional<MissionTime>& since, bool is_earlier,
              const std::optional<MissionTime>& other, MissionTime now) const;
};

/// Reserves air such that no two members ever hold overlapping volumes. In every pair of members
/// the one that is earlier in the roster decides: it may reserve whatever it has not granted to the
/// later one, and grants the later one whatever it neither holds nor asks for; the later one has to
/// ask. A way is granted as a whole or not at all, and after one refusal the grants of the others
/// are given back, so no member waits while it holds half of a way: a UAV in flight along its way
/// never waits, and only UAVs that hold at a place can be in a circle of waits.
///
/// Safe for any delay, loss, order and repetition of messages, and for any cuts: a reservation, and
/// a grant to the later member, ends only when its owner says so. While a pair is cut the later
/// member of it gets no new ways (it keeps what it holds); the earlier one is not affected. A
/// member that restarts without its memory reserves nothing until every peer has told what it
/// holds. A peer that never starts is waited for.
///
/// With a witness (witness.hpp), two of three must agree: a request goes to the peer and to the
/// witness, and a grant of either is enough. While the witness is in reach, a peer that is dead,
/// late or cut off blocks only the air that it may itself hold. A member that reaches neither gets
/// nothing new but the way home that the witness keeps free for it (Need). To a member that waits
/// for a peer out of reach the witness forwards what that peer has told it.
/// docs/decisions/0052-two-of-three.md, 0058-the-way-home-is-kept-free.md, 0064-words-passed-on.md.
///
/// `now` never decreases. Deterministic. Cost of an input: O(volumes held × volumes wanted).
/// Source: I III.B.3 (Alami et al. 1995, 1997: plan merging); mutual exclusion works by pairs
/// instead of a token, so that it survives cuts. docs/decisions/0019-plan-merging.md.
class Merger {
 public:
  /// Precondition: `members` has no duplicates and contains `self`; all members are given the same
  /// list in the same order. `witness`: its name, which is no member's; empty: there is none.
  Merger(const std::vector<std::string>& members, const std::string& self, Limits limits = {},
         const std::string& witness = "");

  Effects handle(const Input& input, MissionTime now);
  std::optional<MissionTime> next_wakeup() const;

  const Volumes& held() const { return held_; }
  bool waits() const { return !choices_.empty(); }
  /// For every peer either the peer itself or the witness is in reach.
  bool can_ask() const;
  const Peers& peers() const { return peers_; }
  /// Whom it waits for, as it was said last.
  const Waits& awaited() const { return told_; }
  /// A peer that waits for this UAV to leave.
  struct Waiter {
    std::string peer;
    bool for_its_place = false;  ///< it wants the place where this UAV stays, not only its way
    bool presses = false;        ///< it has waited long, and longer than this UAV
  };
  std::vector<Waiter> waiters() const;

 private:
  struct Third {
    std::string name;
    bool reachable = true;
    std::uint64_t number = 0;
    bool answered = false;              ///< the open request
    std::vector<std::string> refusers;  ///< members that block the last request, by its answer

    /// Between this member and `peer` it has granted the open request.
    bool agrees(const std::string& peer) const {
      return answered && std::find(refusers.begin(), refusers.end(), peer) == refusers.end();
    }
  };

  void on(const Heard& heard);
  void on(const InReach& reach);
  void on(const Want& want);
  void on(const Withdraw&);
  void on(const Hold& hold);
  void on(const Need& need);
  void on(const FirstLife&);
  void on(const Tick&) {}
  void hear_witness(const Message& message);
  void answer(Peer& peer);
  bool may_agree(const Peer& peer) const;
  void advance();
  bool ask();
  bool take_what_is_kept();
  void close(Duration pause);
  void grant();
  std::vector<Waits::Why> whys() const;
  std::vector<Waits::Why> whys_afterwards() const;
  std::vector<std::string> waits_for() const;
  void say_waits();
  void look_for_circle();
  bool has(const Peer& peer, const Volumes& volumes) const;
  bool asks_for(const Peer& peer, const Volumes& volumes) const;
  bool yields_to(const Peer& peer, const Volumes& volumes) const;
  bool waits_longer(const Peer& peer) const;
  void tell(const std::string& name, bool asks);
  void tell_witness(bool asks);
  void tell_again();
  void tell_all();
  void ask_again();
  Claim claim() const;

  std::string self_;
  Limits limits_;
  Peers peers_;
  std::optional<Third> third_;  ///< the witness
  Standby standby_;
  FormerLife former_life_;

  Volumes held_;
  std::vector<Volumes> choices_;
  std::uint64_t request_ = 0;
  Rising requests_, numbers_;  ///< numbers of requests, of messages
  std::size_t choice_ = 0;     ///< of `choices_`: the one that the open request asks for
  MissionTime deadline_;       ///< of the open request
  MissionTime pause_;          ///< no new request before
  Waits told_;                 ///< the last
  std::optional<MissionTime> wants_since_;
  Volumes afterwards_;   ///< Want::afterwards
  bool leaves_ = false;  ///< Want::leaves
  std::optional<MissionTime> circle_since_;
  MissionTime moved_aside_;  ///< no further MoveAside before

  bool changed_ = false;  ///< the claim differs from what peers were told last
  MissionTime now_;
  Repeats asked_;  ///< the open request
  Effects out_;
};

}  // namespace skein::merging
