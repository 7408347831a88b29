// SPDX-License-Identifier: Apache-2.0
// The witness of plan merging: the ground station's vote in every pair of UAVs.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "skein/foundation/rising.hpp"
#include "skein/foundation/time.hpp"
#include "skein/merging/message.hpp"

namespace skein::merging {

/// Answers the requests of members; holds and wants nothing itself. It grants what no other member
/// holds or was promised, as far as it knows. A promise lasts until the member that asked sends a
/// newer claim. A member with the witness's grant needs no grant of peers that it cannot reach
/// (Merger): of each pair, what one member holds is known to the other one or to the witness.
///
/// Safe for any delay, loss, order and repetition of messages, for cuts, and for members that are
/// dead. A witness that restarted without its memory grants nothing until it has heard every
/// member, and takes requests that were open then for promised. A request is granted or refused
/// between its member and each other one; a grant lasts until that member asks for something else.
/// `now` never decreases. Deterministic. Cost of a message: O(volumes wanted × volumes of all).
/// Source: J.-F. Pâris, "Voting with witnesses", 1986; docs/decisions/0052-two-of-three.md.
class Witness {
 public:
  explicit Witness(const std::vector<std::string>& members);

  /// To be called before anything else. `first`: this is the witness's first life; otherwise it may
  /// have forgotten promises.
  void begin(bool first, MissionTime now);
  struct Answer {
    std::string to;
    Message message;
  };
  /// The messages that follow from a member's message: the answer to its request; if it asked for
  /// them, the claims of those it waits for; its claim to those that wait for it and asked; and, to
  /// a member for which some of that air is kept free (Standby), that another wants to fly there.
  /// Messages of non-members have no effect.
  std::vector<Answer> hear(const std::string& from, const Message& message, MissionTime now);

 private:
  struct Record {
    bool heard = false;
    std::uint64_t number = 0;
    Claim claim;
    std::uint64_t answered = 0;  ///< its last request that was looked at
    /// Members that may have some of what it asks for. To all others the request was granted.
    std::vector<std::string> refusers = {};
    bool follows = false;      ///< it is sent the claims of those it waits for
    std::uint64_t unsure = 0;  ///< its request that may have been promised in an earlier life
  };

  void take(Record& record, const Message& message);
  void answer(const std::string& from, Record& record);
  std::vector<Answer> replies_to(const std::string& from, const Record& record, MissionTime now);
  void pass_on(const std::string& of, const std::string& to, std::vector<Answer>& answers) const;
  Answer answer_to(const std::string& to, std::uint64_t request, bool granted, MissionTime now);
  bool is_kept_for(const Record& record, const Volumes& volumes) const;
  bool may_have(const Record& record, const std::string& asker, const Claim& asks) const;
  bool remembers() const;

  std::map<std::string, Record> records_;
  bool first_life_ = false;
  MissionTime begun_;
  Rising numbers_;
};

}  // namespace skein::merging
