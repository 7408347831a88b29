// SPDX-License-Identifier: Apache-2.0
#include "held_sale.hpp"

#include <algorithm>
#include <cmath>

#include "skein/foundation/overloaded.hpp"
#include "skein/foundation/whole.hpp"

namespace skein::auction {

namespace {

std::string worth(const Value& value) {
  if (!std::isfinite(value.first)) return "what nobody could do it for";
  return to_text(Duration::milliseconds(whole(value.first * 1e3)));
}

}  // namespace

std::string MemberNames::of(MemberNumber member) const {
  const auto found = names.find(member);
  return found == names.end() ? to_text(member) : found->second;
}

std::string MemberNames::of(const std::vector<MemberNumber>& members) const {
  std::string text;
  for (const MemberNumber member : members) text += (text.empty() ? "" : ", ") + of(member);
  return text;
}

void HeldSale::explain(const SaleEffect& effect, const MemberNames& names) {
  std::visit(Overloaded{
                 [&](const Sold& sold) {
                   std::string& text = why[sold.task];
                   text = std::string(sold.trade ? "traded" : "sold") + " to " +
                          names.of(sold.members) + " for " + worth(sold.value);
                   text += sold.next_best ? "; next best " + names.of(sold.next_best->members) +
                                                " for " + worth(sold.next_best->value)
                                          : "; nobody else could";
                 },
                 [&](const Unsold& unsold) {
                   std::string& text = why[unsold.task];
                   text = unsold.together;
                   for (const auto& [member, reason] : unsold.reasons) {
                     text += (text.empty() ? "" : "; ") + names.of(member) + ": " + reason;
                   }
                 },
                 [&](const Rejected& rejected) {
                   for (const Contradiction& wrong : rejected.contradictions) {
                     for (const TaskNumber task : wrong.chain) why[task] = wrong.why;
                   }
                 },
                 [](const auto&) {},
             },
             effect);
}

void HeldSale::book(Ledger& next) const {
  std::map<TaskNumber, std::vector<MemberNumber>> owners;
  for (const Auctioneer::Route& route : auctioneer.routes()) {
    auto& own = next.routes[route.member];
    const std::vector<TaskNumber> before = std::move(own);
    own = route.tasks;
    for (const TaskNumber task : before) {
      if (std::find(own.begin(), own.end(), task) == own.end()) own.push_back(task);
    }
    for (const TaskNumber task : route.tasks) owners[task].push_back(route.member);
  }
  for (auto& [task, entry] : next.entries) {
    if (entry.revision > revision) continue;
    const auto sold = owners.find(task);
    const auto told = why.find(task);
    const bool open = entry.stage == Stage::kForSale || entry.stage == Stage::kOwned;
    if (!open) continue;
    if (sold == owners.end()) {
      if (entry.stage != Stage::kForSale || told == why.end()) continue;
      entry.stage = Stage::kUnsold;
    } else {
      std::sort(sold->second.begin(), sold->second.end());
      if (entry.stage == Stage::kOwned && entry.owners == sold->second) continue;
      entry.stage = Stage::kOwned;
      entry.owners = sold->second;
      entry.sale = number.value();
    }
    entry.finished.clear();
    entry.stopped.clear();
    entry.revision = next.revision;
    if (told != why.end()) entry.why = told->second;
  }
}

}  // namespace skein::auction
