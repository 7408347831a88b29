// SPDX-License-Identifier: Apache-2.0
// The outcome of one problem as people read it.
#pragma once

#include <string>

#include "skein/htn/planner.hpp"
#include "skein/htn_tools/plan_json.hpp"
#include "skein/htn_tools/text_style.hpp"

namespace skein::plan_tool {

struct ReportOptions {
  bool internal = true;
  bool tree = false;
  bool states = false;
  htn::TextStyle style = htn::kPlainText;
  std::string bound{};  ///< how much the limit that cut the search allows: " of 5 s"
};

/// Heading, plans, statistics, and why there is no plan if the outcome says so.
std::string report_text(const htn::PlanningReport& report, const htn::Outcome& outcome,
                        const htn::TermStore& store, const ReportOptions& options);

}  // namespace skein::plan_tool
