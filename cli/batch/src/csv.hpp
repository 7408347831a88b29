// SPDX-License-Identifier: Apache-2.0
// The runs of a batch as a table for other programs.
#pragma once

#include <string>
#include <vector>

#include "row.hpp"

namespace skein::batch_tool {

/// A field of a line of CSV, quoted where it must be (RFC 4180).
std::string csv_field(const std::string& text);

/// A line of names, then one a run: scenario, a column for each key of the sweep, seed, outcome,
/// reason, duration, goals, goals_achieved, goals_failed, expectations_met, expectations, every
/// measure that any run has, and the laws broken, parted by blanks. What could not be measured is
/// left empty. Lines end with \n.
std::string to_csv(const std::vector<Row>& rows);

}  // namespace skein::batch_tool
