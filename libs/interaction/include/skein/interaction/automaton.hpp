// SPDX-License-Identifier: Apache-2.0
// The execution automaton of a role: blocks, tasks and coordination actions.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <set>
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
  kLoop,  ///< begins anew when all its content is over; ends only by its exit condition
};

/// Effect of the end of a block on the parent block.
enum class EndMode : std::uint8_t {
  kWait,       ///< none: the parent waits for its other content
  kImmediate,  ///< the parent's other content is interrupted; a plan ends, a loop begins anew
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
  std::vector<std::string> scms;       ///< SCMs that must hold while the block is active
  std::vector<ComponelIndex> content;  ///< not empty
};

/// A high-level or elementary task, carried out by the supervisor. Source: T def. V.7.
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
  ComponelIndex parent = 0;  ///< for the main block: its own index
  std::variant<Block, Task, CoordinationAction> what;
  std::string path;  ///< in its document
  int line = 0;      ///< in its document, from 1; 0: unknown

  const Block* block() const { return std::get_if<Block>(&what); }
  Block* block() { return std::get_if<Block>(&what); }
  const Task* task() const { return std::get_if<Task>(&what); }
  const CoordinationAction* action() const { return std::get_if<CoordinationAction>(&what); }
};

/// Componels in document order; the main block is the first. All content of a block, at any depth,
/// is the range from the index after the block to end_of(). Ids are unique.
class Automaton {
 public:
  /// Appends a componel to the content of its parent, which must be the last block or one around
  /// it. Returns the new index; absent if the id is in use already.
  std::optional<ComponelIndex> add(Componel componel);

  bool empty() const { return componels_.empty(); }
  std::size_t size() const { return componels_.size(); }
  const Componel& operator[](ComponelIndex index) const { return componels_[index]; }
  Componel& operator[](ComponelIndex index) { return componels_[index]; }
  const std::vector<Componel>& componels() const { return componels_; }

  std::optional<ComponelIndex> find(std::string_view id) const;
  std::vector<std::string> ids() const;
  /// Index of the first componel after the content of this one. Cost: depth of the automaton.
  ComponelIndex end_of(ComponelIndex index) const;
  bool contains(ComponelIndex outer, ComponelIndex inner) const {
    return outer < inner && inner < end_of(outer);
  }

 private:
  std::vector<Componel> componels_;
  std::unordered_map<std::string, ComponelIndex> indices_;
};

/// Names of parameters that conditions on time take their seconds from.
std::set<std::string> named_times(const Automaton& automaton);

/// The same automaton with these seconds, by name, in such conditions; beyond what a time can be
/// they count as its ends, no number as none. Names that are not there stay.
Automaton with_times(Automaton automaton, const std::map<std::string, double>& seconds);

}  // namespace skein::interaction
