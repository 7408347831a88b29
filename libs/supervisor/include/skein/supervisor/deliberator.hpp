// SPDX-License-Identifier: Apache-2.0
// Runs jobs of deliberation one after another.
#pragma once

#include <functional>
#include <memory>

#include "skein/supervisor/deliberation.hpp"

namespace skein::supervisor {

class Plans;  // private: src/planning/plans.hpp

/// Keeps the compiled planning domain from one job to the next. Each result equals that of
/// deliberate(), whatever jobs came before. Thread rule: one job at a time, in any thread; shares
/// nothing with others except the immutable data that the request points to.
class Deliberator {
 public:
  Deliberator();
  ~Deliberator();
  Deliberator(const Deliberator&) = delete;
  Deliberator& operator=(const Deliberator&) = delete;

  /// `time_is_up`: as in deliberate(), and polled equally often, whatever jobs came before.
  DeliberationResult deliberate(const DeliberationRequest& request,
                                const std::function<bool()>& time_is_up = {});

 private:
  std::unique_ptr<Plans> plans_;
};

}  // namespace skein::supervisor
