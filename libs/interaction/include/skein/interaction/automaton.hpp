// SPDX-License-Identifier: Apache-2.0
// The execution automaton of a role: blocks, tasks and coordination actions.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <variant>
#include <vector>

#include "skein/config/value.hpp"
#include "skein/interaction/condition.hpp"

namespace skein::interaction {

enum class BlockType : std::uint8_t {
  kPlan,  ///< ends when all its content is over
  kLoop,  ///< begins anew when all its content is over; only its exit ends it
};

/// What the end of a block means to the block around it.
enum class EndMode : std::uint8_t {
  kWait,       ///< nothing: the others are waited for
  kImmediate,  ///< the rest is interrupted; a plan ends, a loop begins anew
};

/// A parameter computed when its block is activated. Source: T V.4.2 (PL).
struct LocalParameter {
  std::string name;
  std::string initialiser;  ///< "valid-position()"
  int line = 0;
};

/// Source: T def. V.9.
struct Block {
  BlockType type = BlockType::kPlan;
  EndMode end = EndMode::kWait;
  Formula precondition, exit;
  std::vector<LocalParameter> locals;
  std::vector<std::string> scms;       ///< hold while it is active
  std::vector<ComponelIndex> content;  ///< not empty
};

/// High-level or elementary, carried out by the supervisor. Source: T def. V.7.
struct Task {
  std::string type;
  config::Value parameters;  ///< a map, or nothing
};

/// A negotiation to take part in. Source: T def. V.8.
struct CoordinationAction {
  std::string modality;
  config::Value in, out;  ///< maps, or nothing
};

/// One element of an automaton.
struct Componel {
  std::string id;
  ComponelIndex parent = 0;  ///< of the main block: itself
  std::variant<Block, Task, CoordinationAction> what;
  std::string path;  ///< in its document
  int line = 0;      ///< in its document, from 1; 0: unknown

  const Block* block() const { return std::get_if<Block>(&what); }
  Block* block() { return std::get_if<Block>(&what); }
  const Task* task() const { return std::get_if<Task>(&what); }
  const CoordinationAction* action() const { return std::get_if<CoordinationAction>(&what); }
};

/// Componels in document order; the main block is the first. The content of a block, whatever its
/// depth, is the range from behind it to end_of(). Ids are unique.
class Automaton {
 public:
  /// Appends a componel behind the content so far of `parent`, itself the last block begun that is
  /// not finished. The index of the new one; absent if its id is there already.
  std::optional<ComponelIndex> add(Componel componel);

  bool empty() const { return componels_.empty(); }
  std::size_t size() const { return componels_.size(); }
  const Componel& operator[](ComponelIndex index) const { return componels_[index]; }
  Componel& operator[](ComponelIndex index) { return componels_[index]; }
  const std::vector<Componel>& componels() const { return componels_; }

  std::optional<ComponelIndex> find(std::string_view id) const;
  std::vector<std::string> ids() const;
  /// The first componel after everything in this one. Cost: depth of the automaton.
  ComponelIndex end_of(ComponelIndex index) const;
  bool contains(ComponelIndex outer, ComponelIndex inner) const {
    return outer < inner && inner < end_of(outer);
  }

 private:
  std::vector<Componel> componels_;
  std::unordered_map<std::string, ComponelIndex> indices_;
};

}  // namespace skein::interaction
