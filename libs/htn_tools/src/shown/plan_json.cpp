// SPDX-License-Identifier: Apache-2.0
#include "skein/htn_tools/plan_json.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string_view>
#include <vector>

#include "shown/step_numbers.hpp"
#include "skein/htn/utf8.hpp"

namespace skein::htn {

namespace {

// Bytes that do not stand for themselves in JSON, or may not.
constexpr std::array<std::uint8_t, 256> kOther = [] {
  std::array<std::uint8_t, 256> other{};
  for (std::size_t code = 0; code < other.size(); ++code) {
    const bool as_it_is = code >= 0x20 && code < 0x80 && code != '"' && code != '\\';
    other[code] = as_it_is ? 0 : 1;
  }
  return other;
}();

// Characters that JSON cannot hold as they are; bytes that are no UTF-8 become U+FFFD.
void append_escaped(std::string_view text, std::string& out) {
  std::uint8_t other = 0;
  for (const char byte : text) other |= kOther[static_cast<unsigned char>(byte)];
  if (other == 0) {
    out += text;
    return;
  }
  const bool valid = valid_utf8(text);
  for (const char byte : text) {
    const auto code = static_cast<unsigned char>(byte);
    if (byte == '"' || byte == '\\') {
      out += '\\';
      out += byte;
    } else if (byte == '\n') {
      out += "\\n";
    } else if (code < 0x20) {
      constexpr std::string_view kDigits = "0123456789abcdef";
      out += "\\u00";
      out += kDigits[code >> 4U];
      out += kDigits[code & 0xFU];
    } else if (code >= 0x80 && !valid) {
      out += "\xEF\xBF\xBD";
    } else {
      out += byte;
    }
  }
}

void append_string(std::string_view text, std::string& out) {
  out += '"';
  append_escaped(text, out);
  out += '"';
}

void append_atom(Term term, const TermStore& store, std::string& out) {
  if (term.is(TermKind::kSymbol)) {
    append_string(store.name(term), out);
  } else if (term.is(TermKind::kString)) {
    out += "\"\\\"";
    append_escaped(store.text(term), out);
    out += "\\\"\"";
  } else if (term.is(TermKind::kNumber) && store.value(term).kind != NumberKind::kRatio) {
    out += to_text(store.value(term));
  } else {
    append_string(store.to_text(term), out);
  }
}

void append_number(const Number& number, std::string& out) {
  if (number.kind == NumberKind::kRatio) return append_string(to_text(number), out);
  out += to_text(number);
}

// In the shortest form that keeps six decimals.
void append_real(double value, std::string& out) {
  std::array<char, 64> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                 std::chars_format::fixed, 6);
  std::string_view text(digits.data(), static_cast<std::size_t>(end.ptr - digits.data()));
  while (text.ends_with('0')) text.remove_suffix(1);
  if (text.ends_with('.')) text.remove_suffix(1);
  out += text;
}

// Puts a comma before every item but the first.
class Commas {
 public:
  explicit Commas(std::string& out) : out_(out) {}
  void item() {
    if (!first_) out_ += ',';
    first_ = false;
  }
  void key(std::string_view name) {
    item();
    out_ += '"';
    out_ += name;
    out_ += "\":";
  }

 private:
  std::string& out_;
  bool first_ = true;
};

std::string_view kind_name(TreeNodeKind kind) {
  switch (kind) {
    case TreeNodeKind::kOrdered:
      return "ordered";
    case TreeNodeKind::kUnordered:
      return "unordered";
    case TreeNodeKind::kStep:
      return "step";
    default:
      return "task";
  }
}

void append_json(Term term, const TermStore& store, std::string& out, std::vector<Term>& rests);

void append_terms(const std::vector<Term>& terms, const TermStore& store, std::string& out) {
  out += '[';
  Commas commas(out);
  for (const Term term : terms) {
    commas.item();
    append_json(term, store, out);
  }
  out += ']';
}

class PlanWriter {
 public:
  PlanWriter(const Plan& plan, const TermStore& store, const PlanJsonOptions& options,
             std::string& out)
      : plan_(plan), store_(store), numbers_(plan, options.internal), out_(out) {}

  void steps() {
    out_ += "\"steps\":[";
    Commas commas(out_);
    for (StepIndex at = 0; at < plan_.steps.size(); ++at) {
      if (numbers_[at] == kNoStep) continue;
      commas.item();
      append_json(plan_.steps[at].action, store_, out_, rests_);
    }
    out_ += "],\"costs\":[";
    Commas cost_commas(out_);
    std::optional<Number> last;  // many steps cost the same
    std::string last_text;
    for (StepIndex at = 0; at < plan_.steps.size(); ++at) {
      if (numbers_[at] == kNoStep) continue;
      cost_commas.item();
      if (last != plan_.steps[at].cost) {
        last = plan_.steps[at].cost;
        last_text.clear();
        append_number(*last, last_text);
      }
      out_ += last_text;
    }
    out_ += ']';
  }

  void changes() {
    out_ += ",\"changes\":[";
    Commas commas(out_);
    for (StepIndex at = 0; at < plan_.changes.size(); ++at) {
      if (numbers_[at] == kNoStep) continue;
      commas.item();
      out_ += "{\"deleted\":";
      append_terms(plan_.changes[at].deleted, store_, out_);
      out_ += ",\"added\":";
      append_terms(plan_.changes[at].added, store_, out_);
      out_ += '}';
    }
    out_ += ']';
  }

  void tree() {
    out_ += ",\"tree\":[";
    Commas commas(out_);
    for (const TreeNode& node : plan_.tree) {
      commas.item();
      write(node);
    }
    out_ += ']';
  }

 private:
  void write(const TreeNode& node) {
    out_ += '{';
    Commas commas(out_);
    commas.key("kind");
    append_string(kind_name(node.kind), out_);
    if (node.kind == TreeNodeKind::kTask || node.kind == TreeNodeKind::kStep) {
      commas.key("task");
      append_json(node.task, store_, out_);
    }
    if (!node.method.empty()) {
      commas.key("method");
      append_string(node.method, out_);
    }
    if (node.immediate) {
      commas.key("immediate");
      out_ += "true";
    }
    if (!node.children.empty()) {
      commas.key("children");
      write(node.children);
    }
    if (numbers_[node.step] != kNoStep) {
      commas.key("step");
      out_ += std::to_string(numbers_[node.step]);
    }
    if (!node.support.empty()) {
      commas.key("support");
      write(node.support);
    }
    out_ += '}';
  }

  void write(const std::vector<TreeIndex>& children) {
    out_ += '[';
    Commas commas(out_);
    for (const TreeIndex child : children) {
      commas.item();
      out_ += std::to_string(child);
    }
    out_ += ']';
  }

  void write(const std::vector<CausalLink>& support) {
    out_ += '[';
    Commas commas(out_);
    for (const CausalLink& link : support) {
      commas.item();
      out_ += "{\"fact\":";
      append_json(link.fact, store_, out_);
      out_ += ",\"step\":";
      if (link.step == kInitialState) {
        out_ += "\"initial\"";
      } else if (link.step == kOutside) {
        out_ += "\"outside\"";
      } else if (numbers_[link.step] == kNoStep) {
        out_ += "\"internal\"";
      } else {
        out_ += std::to_string(numbers_[link.step]);
      }
      out_ += '}';
    }
    out_ += ']';
  }

  const Plan& plan_;
  const TermStore& store_;
  StepNumbers numbers_;
  std::string& out_;
  std::vector<Term> rests_;
};

std::string_view verdict_name(Verdict verdict) {
  switch (verdict) {
    case Verdict::kPlan:
      return "plan";
    case Verdict::kNoPlan:
      return "no-plan";
    case Verdict::kLimit:
      return "limit";
    default:
      return "error";
  }
}

void append_failure(const FailurePoint& failure, const TermStore& store, std::string& out) {
  out += "{\"steps\":";
  std::vector<Term> actions;
  for (const Step& step : failure.steps) actions.push_back(step.action);
  append_terms(actions, store, out);
  out += ",\"open_tasks\":";
  append_terms(failure.open_tasks, store, out);
  out += ",\"attempts\":[";
  Commas commas(out);
  for (const Attempt& attempt : failure.attempts) {
    commas.item();
    out += "{\"task\":";
    append_json(attempt.task, store, out);
    out += ",\"label\":";
    append_string(attempt.label, out);
    out += ",\"condition\":";
    append_string(attempt.condition, out);
    out += ",\"nearest\":";
    append_terms(attempt.nearest, store, out);
    out += '}';
  }
  out += "]}";
}

void append_plans(const Outcome& outcome, const TermStore& store, const PlanJsonOptions& options,
                  std::string& out) {
  out += '[';
  Commas commas(out);
  for (const Plan& plan : outcome.plans) {
    commas.item();
    append_json(plan, store, options, out);
  }
  out += ']';
}

}  // namespace

void append_json(Term term, const TermStore& store, std::string& out) {
  std::vector<Term> rests;
  append_json(term, store, out, rests);
}

namespace {

// `rests`: what remains of each list that is open; empty before and after.
void append_json(Term term, const TermStore& store, std::string& out, std::vector<Term>& rests) {
  while (true) {
    if (term.is(TermKind::kPair)) {
      out += '[';
      rests.push_back(store.cdr(term));
      term = store.car(term);
      continue;
    }
    append_atom(term, store, out);
    while (!rests.empty() && !rests.back().is(TermKind::kPair)) {
      if (rests.back() != kNil) {
        out += ",\".\",";
        append_atom(rests.back(), store, out);
      }
      out += ']';
      rests.pop_back();
    }
    if (rests.empty()) return;
    out += ',';
    term = store.car(rests.back());
    rests.back() = store.cdr(rests.back());
  }
}

}  // namespace

void append_json(const Plan& plan, const TermStore& store, const PlanJsonOptions& options,
                 std::string& out) {
  out += "{\"cost\":";
  append_number(plan.cost, out);
  out += ',';
  if (!options.internal) out += "\"internal\":false,";
  PlanWriter writer(plan, store, options, out);
  writer.steps();
  if (options.states) writer.changes();
  if (options.tree) writer.tree();
  out += '}';
}

std::string to_json(const PlanningReport& report, const Outcome& outcome, const TermStore& store,
                    const PlanJsonOptions& options) {
  std::string out = "{";
  Commas commas(out);
  const auto text = [&](std::string_view key, std::string_view value) {
    commas.key(key);
    append_string(value, out);
  };
  const auto count = [&](std::string_view key, std::uint64_t value) {
    commas.key(key);
    out += std::to_string(value);
  };
  const auto real = [&](std::string_view key, double value) {
    commas.key(key);
    append_real(value, out);
  };
  text("problem", report.problem);
  text("domain", report.domain);
  text("result", verdict_name(outcome.verdict));
  if (!outcome.why.empty()) text("why", outcome.why);
  commas.key("plans");
  append_plans(outcome, store, options, out);
  count("expansions", outcome.statistics.expansions);
  count("inferences", outcome.statistics.inferences);
  count("deepest", outcome.statistics.deepest);
  real("seconds", report.seconds);
  real("reading_seconds", report.reading_seconds);
  real("memory_mb", report.memory_mb);
  if (outcome.standing) {
    commas.key("standing");
    append_failure(*outcome.standing, store, out);
  }
  if (outcome.repeats_left_out > 0 && outcome.plans.size() > 1) {
    commas.key("repeats_left_out");
    out += std::to_string(outcome.repeats_left_out);
  }
  if (outcome.failure) {
    commas.key("failure");
    append_failure(*outcome.failure, store, out);
  }
  out += '}';
  return out;
}

}  // namespace skein::htn
