// SPDX-License-Identifier: Apache-2.0
// Jobs of deliberation one after another.
#pragma once

#include <functional>
#include <memory>

#include "skein/supervisor/deliberation.hpp"

namespace skein::supervisor {

class Plans;  // private: src/planning/plans.hpp

/// Carries out one job after another, and keeps the planning domain compiled between them; a result
/// is that of deliberate(), whatever came before. Thread rule: one job at a time, in any thread;
/// touches nothing shared but what the request points to, which nobody changes.
class Deliberator {
 public:
  Deliberator();
  ~Deliberator();
  Deliberator(const Deliberator&) = delete;
  Deliberator& operator=(const Deliberator&) = delete;

  /// `time_is_up` as of deliberate(): asked as often as there, whatever came before.
  DeliberationResult deliberate(const DeliberationRequest& request,
                                const std::function<bool()>& time_is_up = {});

 private:
  std::unique_ptr<Plans> plans_;
};

}  // namespace skein::supervisor
