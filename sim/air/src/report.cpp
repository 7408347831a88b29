// SPDX-License-Identifier: Apache-2.0
#include "report.hpp"

#include <nlohmann/json.hpp>

namespace skein::air {

std::string report_of(const Air& air, const std::vector<std::string>& names, double seconds) {
  nlohmann::ordered_json document{{"seconds", seconds},
                                  {"channels", nlohmann::ordered_json::array()}};
  for (std::size_t from = 0; from < names.size(); ++from) {
    for (std::size_t to = 0; to < names.size(); ++to) {
      if (from == to) continue;
      const Counts& counts = air.counts(from, to);
      document["channels"].push_back({{"from", names[from]},
                                      {"to", names[to]},
                                      {"carried", counts.carried},
                                      {"bytes", counts.bytes},
                                      {"lost", counts.lost},
                                      {"cut", counts.cut},
                                      {"overflowed", counts.overflowed},
                                      {"pieces", counts.pieces}});
    }
  }
  return document.dump(1) + "\n";
}

}  // namespace skein::air
