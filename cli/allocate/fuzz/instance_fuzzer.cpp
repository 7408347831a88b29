// SPDX-License-Identifier: Apache-2.0
// Any bytes as instances: errors and nothing sold, or an answer for each.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>

#include "instance.hpp"
#include "skein/allocate_tool/allocate.hpp"

namespace {

using namespace skein;
using namespace skein::allocate_tool;

constexpr std::size_t kMostSold = 12;  // tasks and vehicles: sales of more take the fuzzer's time

void require(bool holds) {
  if (!holds) std::abort();
}

void check(const Instance& instance) {
  const auto& tasks = instance.lot.tasks;
  const auto known = [&](auction::TaskNumber number) {
    return std::any_of(tasks.begin(), tasks.end(),
                       [&](const auction::Task& task) { return task.number == number; });
  };
  require(!instance.vehicles.empty());
  for (const auction::Task& task : tasks) {
    require(std::isfinite(task.at.x) && std::isfinite(task.at.y) && task.duration >= 0);
  }
  for (const auction::Precedence& pair : instance.lot.precedences) {
    require(known(pair.first) && known(pair.then));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  std::istringstream lines(text);
  std::size_t sold = 0;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    Diagnostics problems;
    const auto instance = read_instance(line, "fuzz", ++number, problems);
    require(instance.has_value() == problems.empty());
    if (!instance) continue;
    check(*instance);
    sold += instance->lot.tasks.size() + instance->vehicles.size();
  }
  if (sold > kMostSold) return 0;
  std::istringstream in(text);
  std::ostringstream out, err;
  const int code = allocate({}, in, out, err);
  require(code >= 0 && code <= 2);
  require((code == 2) == !err.str().empty() && (code != 2 || out.str().empty()));
  return 0;
}
