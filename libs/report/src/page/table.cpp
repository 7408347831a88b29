// SPDX-License-Identifier: Apache-2.0
#include "page/table.hpp"

#include "page/views.hpp"

namespace skein::report {

void open_table(Markup& out, std::string_view title, std::initializer_list<const char*> columns,
                Cells cells) {
  out.open("section", {{"class", "card"}});
  out.element("h2", {}, title);
  const char* name = cells == Cells::kSentences ? "figures sentences" : "figures";
  out.open("div", {{"class", "scroll"}}).open("table", {{"class", name}}).open("thead");
  out.open("tr");
  for (const char* column : columns) out.element("th", {}, column);
  out.close().close().open("tbody");
}

void close_table(Markup& out) { out.close().close().close().close().line_break(); }

void write_cells(Markup& out, std::initializer_list<std::string> cells) {
  for (const std::string& cell : cells) out.element("td", {}, cell);
}

void write_uav_name(Markup& out, std::size_t index, const std::string& name) {
  out.open("td");
  out.element("i", {{"class", "dot " + colour_class(index)}}, "").text(name).close();
}

}  // namespace skein::report
