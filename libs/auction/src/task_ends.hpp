// SPDX-License-Identifier: Apache-2.0
// When tasks ended, as far as the holder of the token can tell, and what is to follow them in time.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "skein/auction/ledger.hpp"
#include "skein/foundation/time.hpp"

namespace skein::auction {

/// Bounds on the end of each task that is done. A member says that it is done from then on until
/// the ledger says so, so it has ended between the last time when it did not, and the first when it
/// did. Times are of the senders, so nothing depends on how long a message took.
class TaskEnds {
 public:
  struct End {
    std::optional<MissionTime> after;  ///< none: nobody who heard it knows
    MissionTime by;
  };
  /// A status that `member` sent at `sent`. Idempotent, and in any order.
  void heard(MemberNumber member, MissionTime sent, const std::vector<Claim>& done);
  /// This member has ended its own task now.
  void ended(TaskNumber task, MissionTime now);
  /// The ledger says from now on that it is done.
  void settled(TaskNumber task, MissionTime now) { ends_[task].by = now; }
  End of(TaskNumber task, MissionTime now) const;

 private:
  void not_before(TaskNumber task, MissionTime at);

  std::map<MemberNumber, MissionTime> last_;  ///< when each sent its last status
  std::set<std::pair<MemberNumber, Claim>> said_;
  std::map<TaskNumber, End> ends_;
};

/// The window of a task that begins some time after one that has ended: from the latest that it may
/// have ended, to the earliest. Without an earliest, a delay with a greatest leaves no time.
void bound_start(Task& then, const Delay& delay, const TaskEnds::End& first);

/// The sold tasks that are to begin within some time after this one ends.
std::vector<const LedgerEntry*> followers(const Ledger& ledger, TaskNumber first);

/// Tasks granted to each member that are not over. Who is to follow one of them in time counts as
/// having `ahead`, as many as there may be: it is free when that ends.
using Load = std::map<MemberNumber, std::uint32_t>;
Load granted_load(const Ledger& ledger, std::uint32_t ahead);
/// The load with this entry granted too.
void add_grant(Load& load, const Ledger& ledger, const LedgerEntry& entry, std::uint32_t ahead);

/// Whether everybody who is to follow the task in time has no granted task, and, if `routes_count`,
/// nothing before it in its route either.
bool may_be_followed(const Ledger& ledger, const LedgerEntry& first, const Load& load,
                     bool routes_count);

}  // namespace skein::auction
