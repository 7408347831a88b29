// SPDX-License-Identifier: Apache-2.0
// No text, however wrong, may crash the YAML reading or make it take for ever.
#include <cstdint>
#include <string_view>

#include "skein/config/parse.hpp"
#include "skein/config/reader.hpp"

namespace {

void read_everything(const skein::config::Reader& reader, int depth) {
  if (depth > 70) return;
  (void)reader.number(0, {0, 1, "m"});
  (void)reader.natural();
  (void)reader.choice({"one", "two"});
  (void)reader.numbers(3);
  if (reader.is_map()) {
    for (const auto& [key, below] : reader.entries()) read_everything(below, depth + 1);
  }
  if (reader.is_sequence()) {
    for (const auto& item : reader.items()) read_everything(item, depth + 1);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto value = skein::config::parse_yaml(text, "fuzz");
  if (!value) return 0;
  skein::Diagnostics diagnostics;
  read_everything(skein::config::Reader(*value, "fuzz", diagnostics), 0);
  return 0;
}
