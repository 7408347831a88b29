// SPDX-License-Identifier: Apache-2.0
#include "proof/answers.hpp"

#include <algorithm>
#include <span>

#include "skein/htn/term_map.hpp"

namespace skein::htn {

void Answers::clear() {
  cells.clear();
  values.clear();
  locals.clear();
  support.clear();
}

void Answers::record(Bindings& bindings, std::uint32_t younger) {
  TermStore& store = bindings.store();
  std::vector<Term> renamed;
  const auto rename = [&](Term variable) {
    if (variable.index() < younger) return variable;
    const auto known = std::find(renamed.begin(), renamed.end(), variable);
    const auto index = static_cast<std::uint32_t>(known - renamed.begin());
    if (known == renamed.end()) renamed.push_back(variable);
    return Term(TermKind::kLocal, index);
  };
  for (const Term cell : cells) {
    const Term value = bindings.instance(cell, 0);
    values.push_back(bindings.plain(value) ? value
                                           : map_leaves(store, value, kHasVariable, rename));
  }
  locals.push_back(static_cast<std::uint32_t>(renamed.size()));
}

void Answers::apply(std::size_t row, Bindings& bindings) const {
  const Base base = locals[row] == 0 ? 0 : bindings.open(locals[row]);
  for (std::size_t at = 0; at < cells.size(); ++at) {
    Term value = values[row * cells.size() + at];
    if (locals[row] != 0) {
      value = map_leaves(bindings.store(), value, kHasLocal, [base](Term local) {
        return Term(TermKind::kVariable, base + local.index());
      });
    }
    if (value != cells[at]) bindings.bind(cells[at], value);
  }
}

void Answers::rotate(std::size_t first, std::size_t middle) {
  const auto offset = [](auto& rows, std::size_t row) {
    return rows.begin() + static_cast<std::ptrdiff_t>(row);
  };
  const std::size_t width = cells.size();
  std::rotate(offset(values, first * width), offset(values, middle * width), values.end());
  std::rotate(offset(locals, first), offset(locals, middle), locals.end());
  if (!support.empty()) {
    std::rotate(offset(support, first), offset(support, middle), support.end());
  }
}

void Answers::reorder(const std::vector<std::size_t>& order) {
  Answers ordered;
  ordered.cells = cells;
  for (const std::size_t row : order) {
    for (std::size_t at = 0; at < cells.size(); ++at) {
      ordered.values.push_back(values[row * cells.size() + at]);
    }
    ordered.locals.push_back(locals[row]);
    if (!support.empty()) ordered.support.push_back(std::move(support[row]));
  }
  *this = std::move(ordered);
}

void Answers::move_row(std::size_t from, std::size_t to) {
  if (from == to) return;
  const std::size_t width = cells.size();
  for (std::size_t at = 0; at < width; ++at) values[to * width + at] = values[from * width + at];
  locals[to] = locals[from];
  if (!support.empty()) support[to] = std::move(support[from]);
}

void Answers::finish(RowSet& seen) {
  const std::size_t width = cells.size();
  const std::size_t rows = count();
  if (rows < 2) return;
  for (std::size_t low = 0, high = rows - 1; low < high; ++low, --high) {
    std::swap_ranges(values.begin() + static_cast<std::ptrdiff_t>(low * width),
                     values.begin() + static_cast<std::ptrdiff_t>((low + 1) * width),
                     values.begin() + static_cast<std::ptrdiff_t>(high * width));
    std::swap(locals[low], locals[high]);
    if (!support.empty()) std::swap(support[low], support[high]);
  }
  const auto row_at = [this, width](std::size_t row) {
    return std::span<const Term>(values).subspan(row * width, width);
  };
  seen.begin(rows);
  std::size_t kept = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    move_row(row, kept);
    if (seen.add(kept, row_at)) ++kept;
  }
  values.resize(kept * width);
  locals.resize(kept);
  if (!support.empty()) support.resize(kept);
}

}  // namespace skein::htn
