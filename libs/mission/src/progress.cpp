// SPDX-License-Identifier: Apache-2.0
#include "skein/mission/progress.hpp"

#include <cmath>

#include "skein/foundation/shortest_text.hpp"

namespace skein::mission {

Duration Progress::looked() const {
  Duration all;
  for (const Look& look : looks) all = all + look.lasted;
  return all;
}

std::string to_text(const Progress& progress) {
  std::string text;
  const auto say = [&](const std::string& what) { text += (text.empty() ? "" : ", ") + what; };
  const auto seconds = [](Duration time) {
    return shortest_text(std::round(10 * time.to_seconds()) / 10) + " s";
  };
  if (progress.looked() > Duration()) say("perceived " + seconds(progress.looked()));
  if (progress.waited > Duration()) say("waited " + seconds(progress.waited));
  if (const std::size_t places = progress.reached.size(); places > 0)
    say(std::to_string(places) + (places == 1 ? " place" : " places") + " reached");
  for (const std::uint64_t id : progress.synchronised) say("synchronised " + std::to_string(id));
  return text;
}

}  // namespace skein::mission
