// SPDX-License-Identifier: Apache-2.0
// YAML values and edits in the JSON format of the page.
#pragma once

#include <nlohmann/json.hpp>

#include "skein/config/value.hpp"
#include "skein/foundation/result.hpp"
#include "skein/yaml_edit/edit.hpp"

namespace skein::designer {

using Json = nlohmann::ordered_json;

/// A scalar is a text, or, with quotes, {"\"": text}; entries of maps keep their order.
Json to_json(const config::Value& value);
/// Numbers and truth values are scalars without quotes.
config::Value value_of(const Json& json);
/// {"set": PATH, "value": …}, {"insert": PATH, "index"?, "key"?, "value"}; instead of a value,
/// "yaml": a text. {"remove": PATH},
/// {"rename": PATH, "key"}, {"move": PATH, "into": PATH, "index"?}.
Result<yaml_edit::Edit, Failure> edit_of(const Json& json);

}  // namespace skein::designer
