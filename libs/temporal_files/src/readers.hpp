// SPDX-License-Identifier: Apache-2.0
// One reader for each format; read_network() chooses. Their results are valid only if no problem
// was found.
#pragma once

#include <string_view>

#include "json_document.hpp"
#include "problems.hpp"
#include "skein/foundation/result.hpp"
#include "skein/temporal/dispatchable_network.hpp"
#include "skein/temporal/network.hpp"
#include "xml_document.hpp"

namespace skein::temporal {

Stnu read_own_json(const JsonNode& root, Problems& problems);
Stnu read_heatlab(const JsonNode& root, Problems& problems);
Mastn read_mastn_json(const JsonNode& root, Problems& problems);
Stnu read_graphml(std::string_view text, Problems& problems, XmlEncoding encoding);
Stnu read_plain(std::string_view text, Problems& problems);

std::string write_own_json(const Stnu& network);
Result<std::string, Failure> write_heatlab(const Stnu& network);
Result<std::string, Failure> write_graphml(const Stnu& network);
Result<std::string, Failure> write_graphml(const DispatchableNetwork& network);
Result<std::string, Failure> write_plain(const Stnu& network);

/// The nodes of a network for a format in which the origin has the name `origin`; fails when
/// another node bears it.
Result<std::vector<std::string>, Failure> names_with_origin(const Stnu& network,
                                                            const std::string& origin);

}  // namespace skein::temporal
