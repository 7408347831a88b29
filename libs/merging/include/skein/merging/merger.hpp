// SPDX-License-Identifier: Apache-2.0
// One UAV's part in merging ways.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/merging/message.hpp"
#include "skein/merging/rising.hpp"
#include "skein/merging/standby.hpp"

namespace skein::merging {

// ---- inputs ----

/// A message of another member.
struct Heard {
  std::string from;
  Message message;
};
/// Whether another member can be spoken to; until told, it can.
struct InReach {
  std::string peer;
  bool reachable = true;
};
/// It wants one of these, the first that it can have; before, it wants something else or nothing.
/// Each is taken as a whole, in addition to what it holds. Whoever gets out of the way says what it
/// wants afterwards: it has waited for that all the while, as has who comes back from there.
struct Want {
  std::vector<Volumes> choices;
  Volumes afterwards = {};
  /// It lands: soon it has no air any more, so nobody who has waited long gains by its waiting.
  bool leaves = false;
};
/// It wants nothing any more.
struct Withdraw {};
/// What it holds from now on: no more than it was granted, or where it is anyway.
struct Hold {
  Volumes volumes;
};
/// It would take one of these if it could ask nobody, its way home; empty: nothing. Without a
/// witness it has no effect.
struct Need {
  std::vector<Volumes> choices;
};
/// It never lived before, so it has promised nothing that it does not know of. Who is not told so
/// may have forgotten, and takes no witness's word for a member that has not answered it yet.
struct FirstLife {};
/// Time passes.
struct Tick {};
using Input = std::variant<Heard, InReach, Want, Withdraw, Hold, Need, FirstLife, Tick>;

// ---- effects, in their order ----

struct Tell {
  std::string to;
  Message message;
};
/// It has this choice of what it wanted, and wants nothing more. It stays so whatever becomes of
/// the radio, until it holds less.
struct Granted {
  std::size_t choice = 0;
};
/// What a peer has to do before one may fly.
enum class Awaited : std::uint8_t {
  kToLeave,          ///< the air is its own
  kToTell,           ///< what it has
  kToComeIntoReach,  ///< likewise
  kToBeAnswered,     ///< it has asked for the same before
  kToGoFirst         ///< it has waited long
};
/// "to leave", "to come into reach", …
std::string_view to_text(Awaited what);

/// It waits, for these, when that is not as it was.
struct Waits {
  struct Why {
    std::string peer;
    Awaited what = Awaited::kToLeave;
    bool operator==(const Why&) const = default;
  };
  std::vector<Why> whys;
};
/// They wait for each other in a circle, and it is this one that has to get out of the way: it
/// wants something else, and then what it wanted again.
struct MoveAside {
  std::vector<std::string> circle;  ///< from itself on
  /// One of them is out of reach and gains nothing: only where its own way is free then.
  bool for_itself = false;
};
using Effect = std::variant<Tell, Granted, Waits, MoveAside>;
using Effects = std::vector<Effect>;

struct Limits {
  Duration patience = Duration::milliseconds(2'000);  ///< for an answer
  Duration repeat = Duration::milliseconds(300);      ///< who has not answered is asked again
  Duration again = Duration::milliseconds(250);       ///< after a refusal
  Duration beat = Duration::milliseconds(1'000);      ///< what is held or wanted is said again
  Duration circle = Duration::milliseconds(400);      ///< a circle is one when it has stood so long
  Duration next = Duration::milliseconds(300);        ///< until the next of a circle has to move
  Duration moves = Duration::milliseconds(1'000);     ///< who was asked to move is not asked again
  /// Whoever has waited so long presses: others do not come to stay where it wants to go.
  Duration pressing = Duration::milliseconds(240'000);
  Duration clearly = Duration::milliseconds(5'000);  ///< by which one has waited longer

  /// Whoever wants something since then, if it does.
  bool presses(const std::optional<MissionTime>& since, MissionTime now) const {
    return since && now >= *since + pressing;
  }
};

/// Reserves air so that no two members ever have the same. In every pair of members the earlier in
/// the roster decides between the two: it takes what it has not granted the later, and grants the
/// later what it neither has nor asks for; the later asks it. A way is taken as a whole or not at
/// all, and what has been refused by one is given back to all, so nobody waits with half of
/// something: who flies never waits, and only those who stay somewhere can wait in a circle.
///
/// Holds for any delay, loss, order and repetition of messages, and for any cuts: what is held, and
/// what was granted the later, changes by the word of its owner only. A cut between two keeps the
/// later from new ways (what it has it keeps), never the earlier. A member that comes back without
/// what it knew takes nothing until all have told what they have. One that never comes at all is
/// waited for.
///
/// With a witness (witness.hpp) two of three must agree, the two of a pair and the witness: each
/// asks the other and the witness, and the word of one of them is enough. So nobody waits for one
/// that is dead, late or cut off while the witness is in reach, except for air which that one may
/// have; who reaches neither takes nothing new, but what the witness keeps free for it (Need). The
/// witness passes on to who waits for one out of reach what that one has told it since.
/// docs/decisions/0052-two-of-three.md, 0058-the-way-home-is-kept-free.md.
///
/// `now` never decreases. Deterministic. Cost of an input: O(volumes held × volumes wanted).
/// Source: I III.B.3 (Alami et al. 1995, 1997: plan merging); the mutual exclusion is by pairs, not
/// by a token, so that it outlives cuts. docs/decisions/0019-plan-merging.md.
class Merger {
 public:
  /// Precondition: `self` is in `members`, nobody is twice; the same roster for all.
  /// `witness`: its name, no member's; empty: there is none.
  Merger(std::vector<std::string> members, const std::string& self, Limits limits = {},
         const std::string& witness = "");

  Effects handle(const Input& input, MissionTime now);
  std::optional<MissionTime> next_wakeup() const;

  const Volumes& held() const { return held_; }
  bool waits() const { return !choices_.empty(); }
  /// For each other one there is somebody who can say whether it may have air.
  bool can_ask() const;
  /// What others hold, were granted, or want (with a request or not), as far as it knows.
  Volumes others() const;
  /// What others hold, and what they have asked for, granted or not; of `wanting` what they want,
  /// asked for or not.
  Volumes taken(const std::vector<std::string>& wanting = {}) const;
  /// Those whom it waits for to leave.
  std::vector<std::string> awaited() const;
  /// These, and those who go first since they have waited long.
  std::vector<std::string> in_its_way() const;
  /// Another one waits for this one to leave.
  struct Waiter {
    std::string peer;
    bool for_its_place = false;  ///< where it stays at last, not only on the way there
  };
  std::vector<Waiter> waiters() const;
  /// Where each of them will stay, or stays, as far as it knows.
  Volumes ends() const;

 private:
  struct Peer {
    bool earlier = false;  ///< it decides
    bool reachable = true;
    bool heard = false;
    std::uint64_t number = 0;  ///< of its last message
    Claim claim;
    std::uint64_t answered = 0;  ///< the last of its requests that was answered
    bool granted = false;
    bool agreed = false;  ///< to the request that is open
    /// It has answered a request of this life, or this is the first: nothing that was promised to
    /// it is forgotten.
    bool known = false;
    std::optional<MissionTime> wants_since;
  };
  struct Third {
    std::string name;
    bool reachable = true;
    std::uint64_t number = 0;
    bool agreed = false;                ///< to the request that is open
    std::vector<std::string> refusers;  ///< who has what was asked for last, as it has it
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
  bool needs(const Peer& peer) const { return peer.earlier || third_; }
  bool may_agree(const Peer& peer) const;
  bool may_have_been_promised(std::uint64_t request) const;
  void advance();
  bool ask();
  bool take_what_is_kept();
  void close(Duration pause);
  void grant();
  std::vector<Waits::Why> whys() const;
  std::vector<std::string> waits_for() const;
  void say_waits();
  void look_for_circle();
  bool has(const Peer& peer, const Volumes& volumes) const;
  bool asks_for(const Peer& peer, const Volumes& volumes) const;
  bool yields_to(const Peer& peer, const Volumes& volumes) const;
  bool waits_longer(const Peer& peer) const;
  void tell(const std::string& name, bool asks);
  void tell_witness(bool asks);
  bool follows() const;
  void tell_all();
  void ask_again();
  Claim claim() const;

  std::vector<std::string> members_;
  std::string self_;
  std::size_t place_ = 0;
  Limits limits_;
  std::map<std::string, Peer> peers_;
  std::optional<Third> third_;  ///< the witness
  Standby standby_;
  bool first_life_ = false;
  std::optional<MissionTime> begun_;

  Volumes held_;
  std::vector<Volumes> choices_;
  std::uint64_t request_ = 0;
  Rising requests_, numbers_;     ///< of requests, of messages
  std::size_t choice_ = 0;        ///< that it asks for
  MissionTime deadline_;          ///< of the request
  MissionTime pause_;             ///< it asks for nothing before
  std::vector<Waits::Why> told_;  ///< why it waits
  std::optional<MissionTime> wants_since_;
  Volumes afterwards_;   ///< it wants, once it has come where it gets out of the way
  bool leaves_ = false;  ///< what it wants is to land
  std::optional<MissionTime> circle_since_;
  MissionTime moved_aside_;  ///< it is not asked to again before

  bool changed_ = false;  ///< what it claims, since it was told
  MissionTime now_, said_, asked_;
  Effects out_;
};

}  // namespace skein::merging
