// SPDX-License-Identifier: Apache-2.0
// Laws that every run keeps, judged by truth: the log and the scenario, never a plan.
#pragma once

#include <string>
#include <vector>

#include "skein/laws/history.hpp"
#include "skein/laws/violation.hpp"

namespace skein::laws {

/// A law: a name, one sentence, and what breaks it.
struct Law {
  std::string name;
  std::string says;
  std::vector<Violation> (*broken)(const History&);
};

/// All laws, in the order of the documentation (README).
const std::vector<Law>& all_laws();

/// Every violation of every law (or of `only`), in the order of time.
std::vector<Violation> broken_laws(const scenario::Scenario& scenario,
                                   const std::vector<journal::Record>& records,
                                   const std::vector<std::string>& only = {});

/// When UAVs in the air were nearer to each other than their models ask for, in the order of time,
/// whether the scenario asks for it or not: what law `separation` says where it does.
std::vector<Violation> too_near(const scenario::Scenario& scenario,
                                const std::vector<journal::Record>& records);

/// The least distance [m] between two UAVs while both fly; nothing when they never do.
struct Nearest {
  double distance = kNever;
  double at = 0;
  std::string first, second;
};
std::optional<Nearest> nearest(const History& history);

}  // namespace skein::laws
