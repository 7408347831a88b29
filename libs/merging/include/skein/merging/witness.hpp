// SPDX-License-Identifier: Apache-2.0
// The third of any two that merge their ways.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/merging/message.hpp"
#include "skein/merging/rising.hpp"

namespace skein::merging {

/// Answers what members ask for, and has, wants and decides nothing itself: yes to what no other
/// member has, or was promised, as far as it knows. What it has promised stays so until the one
/// that asked tells something newer. A member that is told "yes" needs no word of those that it
/// cannot reach (Merger): any two of a pair and the witness know of all that either of them has.
///
/// Holds for any delay, loss, order and repetition of messages, for cuts, and for members that are
/// dead. One that forgot answers nobody until it has heard all, and what was asked for then may
/// have been promised. `now` never decreases. Deterministic. Cost of a message: O(volumes wanted ×
/// volumes of all). Source: J.-F. Pâris, "Voting with witnesses", 1986;
/// docs/decisions/0052-two-of-three.md.
class Witness {
 public:
  explicit Witness(const std::vector<std::string>& members);

  /// First of its life. Not `first`: it may have forgotten what it promised.
  void begin(bool first, MissionTime now);
  struct Answer {
    std::string to;
    Message message;
  };
  /// The answer to who asked, if he asked, or what those told last for whom he waits; to those who
  /// wait for this one, what it tells, if they asked; and who is kept some of that air, to take
  /// when it is out of reach, is told that another wants to fly there. Of strangers nothing is
  /// heard.
  std::vector<Answer> hear(const std::string& from, const Message& message, MissionTime now);

 private:
  struct Record {
    bool heard = false;
    std::uint64_t number = 0;
    Claim claim;
    std::uint64_t answered = 0;
    bool granted = false;
    bool follows = false;      ///< it is to be told what those have for whom it waits
    std::uint64_t unsure = 0;  ///< its request that may have been promised in a life before
  };

  void take(Record& record, const Message& message);
  void answer(const std::string& from, Record& record);
  std::vector<Answer> replies_to(const std::string& from, const Record& record, MissionTime now);
  void pass_on(const std::string& of, const std::string& to, std::vector<Answer>& answers) const;
  Answer answer_to(const std::string& to, std::uint64_t request, bool granted, MissionTime now);
  bool is_kept_for(const Record& record, const Volumes& volumes) const;
  bool may_have(const Record& record, const Claim& asks) const;
  bool remembers() const;

  std::map<std::string, Record> records_;
  bool first_life_ = false;
  MissionTime begun_;
  std::vector<std::string> refusers_;  ///< of the last answer
  Rising numbers_;
};

}  // namespace skein::merging
