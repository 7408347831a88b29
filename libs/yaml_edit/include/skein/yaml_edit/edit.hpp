// SPDX-License-Identifier: Apache-2.0
// Changes of a YAML text that leave alone whatever they are not about. Entry header.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "skein/config/value.hpp"
#include "skein/foundation/result.hpp"

namespace skein::yaml_edit {

/// From the top of a document: keys of maps and indices of lists.
using Step = std::variant<std::string, std::size_t>;
using Path = std::vector<Step>;

/// "roles.perceive.content[2]"
std::string to_text(const Path& path);

/// The path, once the item is gone.
Path path_without(Path path, const Path& item);

/// The value there becomes another; it must be there.
struct Set {
  Path path;
  config::Value value;
};
/// A list gets an item at `index` (the end, if it has no such), or a map an entry of that key.
struct Insert {
  Path into;
  std::size_t index = static_cast<std::size_t>(-1);
  std::string key;  ///< of a map
  config::Value value;
};
/// An item or an entry goes, and the lines of comment that stand right above it.
struct Remove {
  Path path;
};
/// An entry gets another key.
struct Rename {
  Path path;
  std::string key;
};
/// An item of a list goes to another place, with its comments. `index` counts in `into` as it is
/// without the item.
struct Move {
  Path path;
  Path into;  ///< as the document is before the move
  std::size_t index = static_cast<std::size_t>(-1);
};
using Edit = std::variant<Set, Insert, Remove, Rename, Move>;

/// What the edit makes of the values of a document; or why there is no such place.
Result<config::Value, Failure> applied(const config::Value& document, const Edit& edit);

/// The text with the edit made. Laws: read again, the text says applied(); every line that the edit
/// is not about is there as it was, byte for byte, in its place. Written as one would by hand: what
/// is short in one line, the rest in lines of their own, as deep as what is around. Refused, with
/// the reason, when the text is no YAML, there is no such place, or the laws cannot be kept there
/// (anchors, several lines of flow style with comments). Cost: O(text).
Result<std::string, Failure> edited(std::string_view text, const Edit& edit);

/// One after the other; all or none.
Result<std::string, Failure> edited(std::string_view text, const std::vector<Edit>& edits);

/// Of two values, whether they say the same: quotes, the order of entries and places do not count.
bool says_same(const config::Value& a, const config::Value& b);

}  // namespace skein::yaml_edit
