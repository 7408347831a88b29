// SPDX-License-Identifier: Apache-2.0
#include "watch/refusals.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>

#include "skein/foundation/repeats.hpp"

namespace skein::supervisor {

namespace {

std::string without_figures(const std::string& text) {
  std::string result;
  std::copy_if(text.begin(), text.end(), std::back_inserter(result),
               [](unsigned char c) { return std::isdigit(c) == 0 && c != '.' && c != '-'; });
  return result;
}

}  // namespace

int Refusals::count(const std::string& type, const std::string& why, MissionTime now) {
  Row& row = rows_[{type, without_figures(why)}];
  if (row.times > 0 && now > row.last + pause_after(row.times) + kRefusedAgain) row.times = 0;
  row.last = now;
  return ++row.times;
}

void Refusals::did(const std::string& type) {
  for (auto row = rows_.lower_bound({type, ""}); row != rows_.end() && row->first.first == type;)
    row = rows_.erase(row);
}

Duration pause_after(int times) {
  constexpr Duration kFirst = Duration::milliseconds(5'000), kMost = Duration::milliseconds(60'000);
  return times < 2 ? Duration() : doubled(kFirst, times - 2, kMost);
}

}  // namespace skein::supervisor
