// SPDX-License-Identifier: Apache-2.0
// Whether two UAVs have the same version of an interaction model.
#pragma once

#include <cstdint>
#include <string>

#include "skein/interaction/model.hpp"

namespace skein::interaction {

/// Hash of a model's meaning. Independent of how the model is written (files, lines, comments,
/// order of map keys, spelling of numbers) and of definitions that none of its roles uses;
/// dependent on the order of lists (content, variants, parameters of a task).
struct ModelHash {
  std::uint64_t value = 0;
  bool operator==(const ModelHash&) const = default;
};

/// Hash of the model for that type of joint task, including its roles and their automata, SCMs,
/// tables, and the tasks and functions that these use. Precondition: the library has the model.
/// Source: spec 7.3.
ModelHash hash_of(const Library& library, const std::string& task);
/// Hashes of all models of the library, by task type.
std::map<std::string, ModelHash> hashes_of(const Library& library);

/// Sixteen hexadecimal digits.
std::string to_text(ModelHash hash);

}  // namespace skein::interaction
