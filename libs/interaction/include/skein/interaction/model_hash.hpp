// SPDX-License-Identifier: Apache-2.0
// Whether two UAVs have the same version of an interaction model.
#pragma once

#include <cstdint>
#include <string>

#include "skein/interaction/model.hpp"

namespace skein::interaction {

/// Of what a model says. Not of how it is written: files, lines, comments, the order of the keys of
/// a map, and spellings of one number are no matter; nor is what no role of it uses. The order of
/// lists is (of content, of variants, of the parameters of a task).
struct ModelHash {
  std::uint64_t value = 0;
  bool operator==(const ModelHash&) const = default;
};

/// Of the model for that type of joint task, with its roles and their automata, SCMs, tables, and
/// the tasks and functions that these name. Precondition: the library has it. Source: spec 7.3.
ModelHash hash_of(const Library& library, const std::string& task);
/// Of all its models, by task.
std::map<std::string, ModelHash> hashes_of(const Library& library);

/// Sixteen hexadecimal digits.
std::string to_text(ModelHash hash);

}  // namespace skein::interaction
