// SPDX-License-Identifier: Apache-2.0
#include "skein/interaction/read_automaton.hpp"

#include <algorithm>
#include <cctype>
#include <utility>
#include <vector>

#include "skein/config/parse.hpp"
#include "skein/foundation/nearest.hpp"

namespace skein::interaction {

namespace {

using config::Reader;

class AutomatonReader {
 public:
  explicit AutomatonReader(const std::vector<std::string>& times) : times_(times) {}

  Automaton read(const Reader& main_block) {
    if (!main_block.present()) main_block.error("no automaton", "a block");
    if (main_block.optional("task").present() || main_block.optional("action").present()) {
      main_block.error("the main componel is not a block", "block: ID");
    } else {
      read_componel(main_block, 0);
    }
    // Conditions may name what comes later.
    for (const auto& [index, reader] : blocks_) read_conditions(index, reader);
    return std::move(automaton_);
  }

 private:
  void read_componel(const Reader& reader, ComponelIndex parent) {
    if (!reader.is_map()) return reader.error("not a componel", "a map with block, task or action");
    const Reader block = reader.optional("block");
    const Reader task = reader.optional("task");
    const Reader action = reader.optional("action");
    if (block.present() + task.present() + action.present() != 1) {
      return reader.error("not a componel", "exactly one of block, task and action");
    }
    if (block.present()) return read_block(reader, block, parent);
    if (task.present()) {
      reader.keys({"task", "type", "params"});
      Task read{required_text(reader, "type"), map_value(reader, "params")};
      add(task, parent, std::move(read));
    } else {
      reader.keys({"action", "modality", "in", "out"});
      CoordinationAction read{required_text(reader, "modality"), map_value(reader, "in"),
                              map_value(reader, "out")};
      add(action, parent, std::move(read));
    }
  }

  void read_block(const Reader& reader, const Reader& id, ComponelIndex parent) {
    reader.keys({"block", "type", "end", "pre", "exit", "local", "scms", "content"});
    Block block;
    block.type = static_cast<BlockType>(reader.optional("type").choice({"plan", "loop"}));
    block.end = static_cast<EndMode>(reader.optional("end").choice({"wait", "immediate"}));
    for (const auto& [name, value] : reader.optional("local").entries()) {
      block.locals.push_back({name, value.text(), value.line()});
      if (!value.present()) value.error("no initialiser", "a call: valid-position()");
    }
    for (const Reader& one : reader.optional("scms").items()) block.scms.push_back(one.text());
    const bool loop = block.type == BlockType::kLoop;
    const auto index = add(id, parent, std::move(block));
    const Reader content = reader.required("content");
    const std::vector<Reader> items = content.items();
    if (content.is_sequence() && items.empty()) {
      content.error("an empty content", "at least one block, task or action");
    }
    if (!index) return;
    blocks_.emplace_back(*index, reader);
    for (const Reader& item : items) read_componel(item, *index);
    if (loop && !has_work(*index) && !items.empty()) {
      content.error("a loop with nothing to do in it", "a task or an action at some depth");
    }
  }

  bool has_work(ComponelIndex block) const {
    for (ComponelIndex i = block + 1; i < automaton_.size(); ++i) {
      if (automaton_[i].block() == nullptr) return true;
    }
    return false;
  }

  template <class What>
  std::optional<ComponelIndex> add(const Reader& id, ComponelIndex parent, What what) {
    Componel componel;
    componel.id = id.text();
    componel.parent = parent;
    componel.what = std::move(what);
    componel.path = id.path();
    componel.line = id.line();
    if (componel.id.empty()) id.error("an empty id", "a name");
    const std::string name = componel.id;
    const auto index = automaton_.add(std::move(componel));
    if (!index) id.error("the id '" + name + "' is there twice", "an id of its own");
    return index;
  }

  static std::string required_text(const Reader& reader, const char* key) {
    const Reader value = reader.required(key);
    if (value.is_scalar() && value.text().empty()) value.error("empty", "a name");
    return value.text();
  }

  static config::Value map_value(const Reader& reader, const char* key) {
    const Reader value = reader.optional(key);
    if (value.present() && !value.is_map()) value.error("not a map", "names with values");
    return value.is_map() ? value.value() : config::Value();
  }

  // --- conditions --------------------------------------------------------------------------------

  void read_conditions(ComponelIndex index, const Reader& reader) {
    Formula precondition = read_formula(reader.optional("pre"), false, false);
    const bool loop = automaton_[index].block()->type == BlockType::kLoop;
    Formula exit = read_formula(reader.optional("exit"), true, loop);
    automaton_[index].block()->precondition = std::move(precondition);
    automaton_[index].block()->exit = std::move(exit);
  }

  Formula read_formula(const Reader& reader, bool exit, bool loop) {
    Formula formula;
    for (const Reader& clause : reader.items()) {
      formula.emplace_back();
      for (const Reader& literal : clause.items()) {
        formula.back().push_back(read_literal(literal, exit, loop));
      }
      if (!clause.is_sequence()) clause.error("not a clause", "a list of literals");
    }
    return formula;
  }

  Literal read_literal(const Reader& reader, bool exit, bool loop) {
    Literal literal;
    literal.condition = read_condition(reader);
    literal.negated = reader.optional("not").boolean();
    literal.modality =
        static_cast<Modality>(reader.optional("modality").choice({"mandatory", "optional"}));
    const Reader effect = reader.optional("effect");
    literal.effect = static_cast<ExitEffect>(effect.choice({"exit", "continue"}));
    if (effect.present() && !exit) {
      effect.error("a precondition has no effect", "effect only in an exit");
    } else if (literal.effect == ExitEffect::kContinue && !loop) {
      effect.error("only a loop can continue", "type: loop, or effect: exit");
    }
    return literal;
  }

  std::variant<ComponelIs, MessagePending, TimeIs> read_condition(const Reader& reader) {
    const Reader componel = reader.optional("componel");
    const Reader message = reader.optional("message");
    const Reader time = reader.optional("time");
    if (componel.present() + message.present() + time.present() != 1) {
      reader.error("not a literal", "exactly one of componel, message and time");
      return MessagePending{};
    }
    if (componel.present()) {
      reader.keys({"componel", "state", "not", "modality", "effect"});
      return ComponelIs{named(componel, componel.text()), asked(reader.required("state"))};
    }
    if (message.present()) {
      reader.keys({"message", "not", "modality", "effect"});
      return MessagePending{message.text()};
    }
    reader.keys({"time", "since", "is", "not", "modality", "effect"});
    TimeIs is;
    read_after(time, is);
    is.since = read_since(reader.optional("since"));
    is.passed = reader.required("is").choice({"passed", "not-yet-passed"}) == 0;
    return is;
  }

  void read_after(const Reader& time, TimeIs& is) const {
    const std::string word = time.is_scalar() ? time.text() : "";
    if (std::ranges::find(times_, word) != times_.end()) {
      is.named = word;
    } else if (!times_.empty() && !word.empty() && std::isalpha(word[0] & 0x7f) != 0) {
      time.error("'" + word + "' is no time", "seconds, or a parameter of the role of type Time",
                 nearest_name(word, times_));
    } else {
      is.after = Duration::seconds(time.number(0, {-kLatestTime, kLatestTime, "s"}));
    }
  }

  decltype(TimeIs::since) read_since(const Reader& reader) {
    const std::string text = reader.text("epoch");
    if (text == "epoch") return TimeIs::Epoch{};
    if (text == "start") return TimeIs::ModelStart{};
    const std::size_t colon = text.rfind(':');
    if (colon == std::string::npos) {
      reader.error("'" + text + "' is no instant", "epoch, start or COMPONEL:STATE");
      return TimeIs::Epoch{};
    }
    const ComponelIndex componel = named(reader, text.substr(0, colon));
    const std::string state = text.substr(colon + 1);
    for (const AskedState one : kAskedStates) {
      if (to_text(one) == state) return TimeIs::Event{componel, one};
    }
    reader.error("unknown state '" + state + "'", "a state", nearest_name(state, state_names()));
    return TimeIs::Epoch{};
  }

  ComponelIndex named(const Reader& reader, const std::string& id) const {
    if (const auto found = automaton_.find(id)) return *found;
    reader.error("unknown componel '" + id + "'", "an id of this automaton",
                 nearest_name(id, automaton_.ids()));
    return 0;
  }

  static AskedState asked(const Reader& reader) {
    return kAskedStates[reader.choice(
        {"scheduled", "running", "aborting", "aborted", "ended", "over"})];
  }

  static std::vector<std::string> state_names() {
    std::vector<std::string> names;
    for (const AskedState one : kAskedStates) names.emplace_back(to_text(one));
    return names;
  }

  static constexpr AskedState kAskedStates[] = {AskedState::kScheduled, AskedState::kRunning,
                                                AskedState::kAborting,  AskedState::kAborted,
                                                AskedState::kEnded,     AskedState::kOver};

  const std::vector<std::string>& times_;
  Automaton automaton_;
  std::vector<std::pair<ComponelIndex, Reader>> blocks_;
};

}  // namespace

Automaton read_automaton(const config::Reader& main_block, const std::vector<std::string>& times) {
  return AutomatonReader(times).read(main_block);
}

Result<Automaton, Diagnostics> read_automaton(std::string_view text, const std::string& file) {
  const auto value = config::parse_yaml(text, file);
  if (!value) return tl::unexpected<Diagnostics>(value.error());
  Diagnostics problems;
  Automaton automaton = read_automaton(Reader(*value, file, problems));
  if (!problems.empty()) return tl::unexpected<Diagnostics>(std::move(problems));
  return automaton;
}

}  // namespace skein::interaction
