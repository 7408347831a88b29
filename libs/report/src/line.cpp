// SPDX-License-Identifier: Apache-2.0
#include "line.hpp"

#include "chronology.hpp"
#include "field_reader.hpp"

namespace skein::report {

std::string Line::text(const char* key) const {
  const auto found = keys.find(key);
  return found != keys.end() && found->is_string() ? found->get<std::string>() : "";
}

double Line::number(const char* key) const {
  const auto found = keys.find(key);
  return found != keys.end() && found->is_number() ? found->get<double>() : 0.0;
}

std::optional<std::int64_t> Line::whole(const char* key) const {
  const auto found = keys.find(key);
  if (found == keys.end() || !found->is_number_integer()) return std::nullopt;
  return found->get<std::int64_t>();
}

std::optional<Line> line_of(const OtherRecord& record) {
  if (record.stamp.extra.empty()) return std::nullopt;
  Diagnostics faults;
  auto keys = parse_json(record.stamp.extra, {}, faults);
  if (!keys || !keys->is_object()) return std::nullopt;
  return Line{seconds(record.stamp), std::move(*keys)};
}

}  // namespace skein::report
