// SPDX-License-Identifier: Apache-2.0
#include "kept_back.hpp"

namespace skein::auction {

void KeptBack::forget_others_than_owned(const Ledger& ledger) {
  std::erase_if(since_, [&](const auto& kept) {
    const LedgerEntry& entry = ledger.entries.at(kept.first.task);
    return entry.sale != kept.first.sale || entry.stage != Stage::kOwned;
  });
}

bool KeptBack::lets_go(const LedgerEntry& entry, const GrantLoad& load, MissionTime now,
                       Duration lease) {
  const Claim claim{entry.task.number, entry.sale};
  const auto kept = since_.find(claim);
  const bool waited = kept != since_.end() && now - kept->second > lease;
  const bool is_time = load.may_be_followed(entry.task.number, !waited);
  if (!is_time) since_.emplace(claim, now);
  return is_time;
}

}  // namespace skein::auction
