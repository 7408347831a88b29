// SPDX-License-Identifier: Apache-2.0
#include "elsewhere.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <string_view>
#include <system_error>

#include "skein/foundation/contract.hpp"
#include "skein/foundation/exit_code.hpp"

namespace skein::cli {

namespace {

struct CarriedOut {
  std::string_view command;
  const char* by;
};
constexpr std::array kElsewhere{
    CarriedOut{"run", "skein-run"},         CarriedOut{"report", "skein-run"},
    CarriedOut{"functional", "skein-live"}, CarriedOut{"operate", "skein-live"},
    CarriedOut{"replay", "skein-live"},     CarriedOut{"spy", "skein-live"},
    CarriedOut{"state", "skein-live"},      CarriedOut{"status", "skein-live"},
    CarriedOut{"batch", "skein-lab"},       CarriedOut{"compare", "skein-lab"},
    CarriedOut{"export", "skein-lab"},      CarriedOut{"import", "skein-lab"},
    CarriedOut{"judge", "skein-lab"},       CarriedOut{"series", "skein-lab"},
    CarriedOut{"storm", "skein-lab"},       CarriedOut{"allocate", "skein-tools"},
    CarriedOut{"mastn", "skein-tools"},     CarriedOut{"mle", "skein-tools"},
    CarriedOut{"model", "skein-tools"},     CarriedOut{"stn", "skein-tools"},
    CarriedOut{"refine", "skein-refine"},   CarriedOut{"terrain", "skein-refine"},
};

const char* program_of(std::string_view command, std::string_view verb) {
  if (command == "model" && verb == "edit") return "skein-lab";  // it serves a page
  const auto found = std::find_if(kElsewhere.begin(), kElsewhere.end(),
                                  [&](const CarriedOut& one) { return one.command == command; });
  SKEIN_ENSURES(found != kElsewhere.end());
  return found->by;
}

// Becomes that program, with the same arguments; returns only if that cannot be.
int become(const char* program, char** argv) {
  std::error_code none;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", none);
  const std::string other = (self.parent_path() / program).string();
  execv(other.c_str(), argv);
  std::cerr << "skein: " << other << " cannot be started: " << std::strerror(errno) << '\n';
  if (errno == ENOENT) std::cerr << "skein: to build it: scripts/build release " << program << '\n';
  return kExitSystem;
}

}  // namespace

int carry_out_elsewhere(int argc, char** argv) {
  return become(program_of(argv[1], argc > 2 ? argv[2] : ""), argv);
}

}  // namespace skein::cli
