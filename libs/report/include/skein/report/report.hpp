// SPDX-License-Identifier: Apache-2.0
// The three documents of a run. Pure functions: the same run gives the same bytes.
#pragma once

#include <string>

#include "skein/report/journal.hpp"
#include "skein/report/run_info.hpp"

namespace skein::report {

/// One self-contained page: map, chronology of every UAV's tasks, profiles, links, tables. It needs
/// no other file and no network; scripts only add interaction. Any journal gives a page, also an
/// empty one. Cost: under 2 s and under 10 MB for 20 UAVs and 100,000 lines. Source: spec 8.1.
std::string html_report(const RunInfo& info, const Journal& journal);

/// JUnit XML: one test case per expectation; one more, failed, when no expectation was checked.
std::string junit(const RunInfo& info, const Journal& journal);

/// Verdict, expectations and figures as one JSON document, ended by a newline.
std::string summary_json(const RunInfo& info, const Journal& journal);

}  // namespace skein::report
