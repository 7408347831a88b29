// SPDX-License-Identifier: Apache-2.0
// Tables of the page.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "markup.hpp"

namespace skein::report {

/// Cells that are figures stay on one line; those of `kSentences` wrap from the third column on.
enum class Cells { kFigures, kSentences };
void open_table(Markup& out, std::string_view title, std::initializer_list<const char*> columns,
                Cells cells = Cells::kFigures);
void close_table(Markup& out);
/// Cells of the open row.
void write_cells(Markup& out, std::initializer_list<std::string> cells);
/// A cell with the UAV's colour and name.
void write_uav_name(Markup& out, std::size_t index, const std::string& name);

}  // namespace skein::report
