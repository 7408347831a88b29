// SPDX-License-Identifier: Apache-2.0
// A run as an MCAP file.
#pragma once

#include <vector>

#include "skein/journal/record.hpp"
#include "skein/mcap/writer.hpp"
#include "skein/report/run_info.hpp"

namespace skein::foxglove {

/// Writes the records, which are in the order of time, as messages (README). The writer is not
/// closed. Cost: linear in the records; for each change of a plan, in its ways.
void export_run(const report::RunInfo& info, const std::vector<journal::Record>& records,
                mcap::Writer& writer);

}  // namespace skein::foxglove
