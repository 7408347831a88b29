// SPDX-License-Identifier: Apache-2.0
// Any bytes as a library: errors, or a library that can be drawn.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "skein/config/parse.hpp"
#include "skein/interaction/draw_model.hpp"
#include "skein/interaction/read_library.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace skein::interaction;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  auto value = skein::config::parse_yaml(text, "fuzz");
  if (!value) return 0;
  const Document document{"fuzz", std::move(*value)};
  (void)uses_of(document);
  const auto library = read_library({document});
  if (library ? draw_svg(*library).empty() : library.error().empty()) std::abort();
  return 0;
}
