// SPDX-License-Identifier: Apache-2.0
// Progress line of a search on a terminal, overwritten each second.
#pragma once

#include <functional>
#include <iosfwd>
#include <optional>
#include <string>

#include "skein/htn/plan.hpp"

namespace skein::plan_tool {

class Progress {
 public:
  /// Without a clock, or when not shown, nothing is ever written.
  Progress(std::ostream& err, std::function<double()> cpu_seconds, bool shown)
      : err_(err), cpu_seconds_(std::move(cpu_seconds)), shown_(shown && cpu_seconds_) {}

  void begin(const std::string& problem);
  void see(const htn::Plan& plan);
  /// To call often.
  void tick();
  /// Erases the line.
  void end();

 private:
  std::ostream& err_;
  std::function<double()> cpu_seconds_;
  bool shown_;
  bool visible_ = false;
  std::string problem_;
  double began_ = 0;
  double next_ = 0;
  std::size_t plans_ = 0;
  std::optional<htn::Number> best_;
};

}  // namespace skein::plan_tool
