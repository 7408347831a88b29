// SPDX-License-Identifier: Apache-2.0
// What an auctioneer says about its sales.
#include <algorithm>

#include "sale_core.hpp"

namespace skein::auction {

std::vector<MemberNumber> Auctioneer::Core::members_of(const Draft& draft,
                                                       const Placing& placing) const {
  std::vector<MemberNumber> members;
  for (const auto& spot : placing.spots) members.push_back(draft.member(spot.route));
  std::sort(members.begin(), members.end());
  return members;
}

void Auctioneer::Core::tell_sold(const Deal& deal, SaleEffects& effects) const {
  for (const Decided& one : deal.decided) {
    Sold sold{items_[one.placing.item],
              members_of(deal.draft, one.placing),
              round_,
              !selling_,
              one.placing.value,
              std::nullopt};
    if (one.next_best) {
      sold.next_best = Sold::Rival{members_of(deal.draft, *one.next_best), one.next_best->value};
    }
    effects.emplace_back(std::move(sold));
  }
}

// None: it might still be sold.
std::optional<Unsold> Auctioneer::Core::hopeless(const Task& task) const {
  Unsold unsold{task.number, {}, {}};
  Abilities together = 0;
  std::uint32_t willing = 0;
  for (const Member& member : members_) {
    const auto objection = member.objections.find(task.number);
    if (!member.present) {
      unsold.reasons.push_back({member.route.member, "it does not answer"});
    } else if (objection == member.objections.end()) {
      return std::nullopt;  // not asked yet
    } else if (!objection->second.empty()) {
      unsold.reasons.push_back({member.route.member, objection->second});
    } else {
      together |= member.abilities;
      ++willing;
    }
  }
  if (willing == 0) return unsold;
  if ((task.needs & ~together) != 0)
    unsold.together = "those that could lack an ability between them";
  if (willing < task.least_members) unsold.together = "those that could are too few";
  if (unsold.together.empty()) return std::nullopt;
  return unsold;
}

// Said at once: what nobody can do whatever else is sold.
void Auctioneer::Core::tell_hopeless(SaleEffects& effects) {
  std::erase_if(left_over_, [&](TaskNumber number) {
    auto unsold = hopeless(setup_.lot->task(number));
    if (!unsold) return false;
    effects.emplace_back(std::move(*unsold));
    return true;
  });
}

void Auctioneer::Core::finish(SaleEffects& effects) {
  phase_ = Phase::kEnded;
  for (const std::vector<TaskNumber>* tasks : {&to_sell_, &left_over_}) {
    for (const TaskNumber number : *tasks) {
      Unsold unsold{number, {}, {}};
      for (const Member& member : members_) {
        const auto objection = member.objections.find(number);
        std::string why = "it finds no time for it, or no energy, beside what is sold";
        if (!member.present) why = "it does not answer";
        if (objection != member.objections.end() && !objection->second.empty())
          why = objection->second;
        unsold.reasons.push_back({member.route.member, std::move(why)});
      }
      effects.emplace_back(std::move(unsold));
    }
  }
  effects.emplace_back(Ended{});
}

}  // namespace skein::auction
