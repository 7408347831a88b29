// SPDX-License-Identifier: Apache-2.0
#include "skein/foundation/shortest_text.hpp"

#include <charconv>

namespace skein {

std::string shortest_text(double number) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, number == 0 ? 0.0 : number).ptr};
}

}  // namespace skein
