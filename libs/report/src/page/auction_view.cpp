// SPDX-License-Identifier: Apache-2.0
// The table of auctions: who offered what for each task of the team, who did not and why, and what
// came of it. Source: spec 6.3.
#include <algorithm>
#include <map>
#include <utility>

#include "page/table.hpp"
#include "page/views.hpp"
#include "skein/foundation/joined.hpp"
#include "text.hpp"

namespace skein::report {

namespace {

/// The bids for one task in the first round of one sale.
struct Offers {
  double from = 0, until = 0;  ///< [s] until the task's next sale
  std::uint64_t task = 0;
  std::vector<std::pair<double, std::string>> added;  ///< [s], of whom
  std::vector<std::string> refusals;
};

std::vector<Offers> offers_of(const Run& run) {
  std::map<std::pair<std::uint64_t, std::uint64_t>, std::size_t> places;
  std::map<std::uint64_t, std::size_t> last_of;
  std::vector<Offers> all;
  for (const auto& [stamp, bid] : run.journal.bids) {
    const auto [at, is_new] = places.try_emplace({bid.sale, bid.task}, all.size());
    if (is_new) {
      const auto [last, first] = last_of.try_emplace(bid.task, all.size());
      if (!first) all[std::exchange(last->second, all.size())].until = seconds(stamp);
      all.push_back({seconds(stamp), run.story.time.to + 1, bid.task, {}, {}});
    }
    Offers& offers = all[at->second];
    if (bid.added)
      offers.added.emplace_back(*bid.added, bid.uav);
    else
      offers.refusals.push_back(bid.uav + ": " + bid.why);
  }
  for (Offers& one : all) std::sort(one.added.begin(), one.added.end());
  return all;
}

std::string outcome_of(const journal::lines::Sale& sale) {
  std::string text = sale.state;
  if (!sale.to.empty()) text += " to " + sale.to;
  if (sale.value) text += " for " + fixed_number(*sale.value, 1);
  if (!sale.next_best.empty()) text += ", next best " + sale.next_best;
  if (sale.next_value) text += " " + fixed_number(*sale.next_value, 1);
  return sale.to.empty() || sale.why.empty() ? text : text + ", " + sale.why;
}

std::string in_a_row(const std::vector<std::string>& texts, std::string_view between) {
  return texts.empty() ? "–" : joined(texts, between);
}

std::string outcomes_of(const Run& run, const Offers& offers) {
  std::vector<std::string> texts;
  for (const auto& [stamp, sale] : run.journal.sales) {
    const double at = seconds(stamp);
    if (sale.task != offers.task || at < offers.from || at >= offers.until) continue;
    texts.push_back(clock_text(at) + " " + outcome_of(sale));
  }
  return in_a_row(texts, "; ");
}

std::string statement_of(const Run& run, std::uint64_t task) {
  for (const auto& [stamp, owner] : run.journal.owners)
    if (owner.task == task) return std::to_string(task) + " " + owner.statement;
  return std::to_string(task);
}

std::string offers_text(const Offers& offers) {
  std::vector<std::string> texts;
  for (const auto& [added, who] : offers.added) texts.push_back(who + " " + fixed_number(added, 1));
  return in_a_row(texts, ", ");
}

}  // namespace

void write_auction_table(Markup& out, const Run& run) {
  const std::vector<Offers> all = offers_of(run);
  if (all.empty()) return;
  open_table(out, "Auctions: by how many seconds a task makes each one's route longer",
             {"time", "task", "offers [s]", "no offer", "outcome [s of the whole team's aim]"},
             Cells::kSentences);
  for (const Offers& one : all) {
    out.open("tr");
    write_cells(out, {clock_text(one.from), statement_of(run, one.task), offers_text(one),
                      in_a_row(one.refusals, "; "), outcomes_of(run, one)});
    out.close();
  }
  close_table(out);
}

}  // namespace skein::report
