// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>

#include "chains.hpp"
#include "skein/auction/task.hpp"
#include "skein/foundation/rounded_seconds.hpp"
#include "start_bounds.hpp"

namespace skein::auction {

namespace {

using Found = std::vector<Contradiction>;

std::string seconds(double value) { return in_seconds(Duration::seconds(value)); }

std::vector<TaskNumber> numbers(const Catalogue& catalogue,
                                const std::vector<std::uint32_t>& chain) {
  std::vector<TaskNumber> all;
  for (const std::uint32_t task : chain) all.push_back(catalogue.task(task).number);
  return all;
}

// "11 begins at 100 s at the earliest and lasts 20 s, then 12 lasts 30 s".
std::string links_of(const Catalogue& catalogue, const std::vector<std::uint32_t>& chain) {
  const Task& first = catalogue.task(chain.front());
  std::string links = to_text(first.number) + " begins at " + seconds(first.earliest) +
                      " at the earliest and lasts " + seconds(first.duration);
  for (std::size_t i = 1; i < chain.size(); ++i) {
    const Task& next = catalogue.task(chain[i]);
    const double least = catalogue.delay(chain[i - 1], chain[i]).least;
    links += ", then " + to_text(next.number);
    if (least > 0) links += " begins " + seconds(least) + " later and";
    links += " lasts " + seconds(next.duration);
  }
  return links;
}

void add_late(const Catalogue& catalogue, const Chains& chains, Found& found) {
  for (std::uint32_t i = 0; i < catalogue.size(); ++i) {
    if (!chains.late(i)) continue;
    const auto chain = chains.leading_to(i);
    found.push_back({numbers(catalogue, chain),
                     "the last cannot end before " + seconds(chains.earliest_end(i)) +
                         ", its deadline is " + seconds(catalogue.task(i).deadline) + ": " +
                         links_of(catalogue, chain)});
  }
}

void add_circle(const Catalogue& catalogue, const Chains& chains, Found& found) {
  if (const auto circle = chains.circle(); !circle.empty())
    found.push_back({numbers(catalogue, circle), "each is to end before the next begins"});
}

void add_mistakes(const Lot& lot, Found& found) {
  std::map<TaskNumber, int> times;
  for (const Task& task : lot.tasks) {
    if (++times[task.number] == 2) found.push_back({{task.number}, "is given twice"});
    if (task.pinned && task.forbidden.contains(*task.pinned)) {
      found.push_back({{task.number}, "is pinned to a member that is forbidden to do it"});
    }
  }
  for (const auto& [first, then, delay] : lot.precedences) {
    for (const TaskNumber task : {first, then}) {
      if (times.contains(task)) continue;
      found.push_back({{first, then}, "task " + to_text(task) + " is not among those to be sold"});
    }
  }
}

}  // namespace

std::vector<Contradiction> contradictions(const Lot& lot) {
  Found found;
  add_mistakes(lot, found);
  const std::size_t mistakes = found.size();
  const Catalogue catalogue(lot);
  const Chains chains(catalogue);
  add_late(catalogue, chains, found);
  add_circle(catalogue, chains, found);
  if (found.size() > mistakes) return found;
  if (const auto tight = tight_circle(catalogue)) found.push_back(*tight);
  return found;
}

}  // namespace skein::auction
