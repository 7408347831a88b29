// SPDX-License-Identifier: Apache-2.0
// Drawn programs of assignments, conditionals, loops and blocks: their text, and a tree walk over
// them that is the reference for what they give.
#pragma once

#include <rapidcheck.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace skein::htn::test {

/// Integers v0 to v3, and a list `out` that the statements push on. Every loop ends.
class DrawnProgram {
 public:
  static constexpr std::size_t kVariables = 4;

  /// Of all kinds of statements from the first case on, whatever size RapidCheck is at.
  static DrawnProgram drawn() {
    return *rc::gen::resize(rc::kNominalSize, rc::gen::exec([] { return DrawnProgram(); }));
  }

  /// The form that gives (v0 … v3 out).
  std::string text() const {
    return "(let ((v0 1) (v1 2) (v2 3) (v3 -1) (out nil)) " + joined(body_) +
           " (list v0 v1 v2 v3 out))";
  }

  /// What it gives, by walking it.
  std::string expected() const {
    Machine machine;
    machine.run(body_);
    std::string text = "(";
    for (const std::int64_t value : machine.variables) text += std::to_string(value) + " ";
    std::string pushed;
    for (auto at = machine.pushed.rbegin(); at != machine.pushed.rend(); ++at)
      pushed += (pushed.empty() ? "" : " ") + std::to_string(*at);
    return text + (pushed.empty() ? "nil" : "(" + pushed + ")") + ")";
  }

 private:
  DrawnProgram() : body_(drawn_body(3, 0, 0)) {}

  enum class Kind : std::uint8_t {
    kSet,      ///< (setq v (op v k))
    kStep,     ///< (incf v k), (decf v k)
    kPush,     ///< (push v out)
    kPop,      ///< (setq v (or (pop out) k))
    kSwap,     ///< (setq v w w v): one after the other
    kIf,       ///< (if (< v k) (progn …) …)
    kWhen,     ///< (when (oddp v) …), (unless (oddp v) …)
    kCase,     ///< (case (mod v 3) (0 …) ((1 k) …) (t …))
    kTimes,    ///< (dotimes (v k) …): the variable of the loop hides the other
    kEach,     ///< (dolist (v (list k w 5)) …)
    kDo,       ///< (do ((v 0 (1+ v)) (w k v)) ((>= v k)) …): steps at once
    kBlock,    ///< (block b … (when (> v k) (return-from b)) …)
    kLet,      ///< (let ((v w) (w v)) …): values from outside
    kLetStar,  ///< (let* ((v w) (w v)) …): one after the other
    kReturn,   ///< (when (> v k) (return)), in a loop
  };
  struct Statement {
    Kind kind = Kind::kSet;
    std::size_t v = 0, w = 0;
    std::int64_t k = 0;
    std::size_t block = 0;
    std::vector<Statement> one, other;
  };
  using Body = std::vector<Statement>;

  static Body drawn_body(int depth, std::size_t blocks, int loops) {
    Body body;
    for (int left = *rc::gen::inRange(1, 4); left > 0; --left) {
      const int kinds = depth == 0 ? 5 : (loops > 0 ? 15 : 14);
      Statement made;
      made.kind = static_cast<Kind>(*rc::gen::inRange(0, kinds));
      made.v = *rc::gen::inRange<std::size_t>(0, kVariables);
      made.w = (made.v + *rc::gen::inRange<std::size_t>(1, kVariables)) % kVariables;
      made.k = *rc::gen::inRange(-3, 5);
      made.block = blocks;
      const bool loop =
          made.kind == Kind::kTimes || made.kind == Kind::kEach || made.kind == Kind::kDo;
      if (depth > 0) {
        const std::size_t inside = blocks + (made.kind == Kind::kBlock ? 1U : 0U);
        made.one = drawn_body(depth - 1, inside, loops + (loop ? 1 : 0));
        made.other = drawn_body(depth - 1, inside, loops + (loop ? 1 : 0));
      }
      body.push_back(std::move(made));
    }
    return body;
  }

  static std::string name(std::size_t variable) { return "v" + std::to_string(variable); }
  static std::string joined(const Body& body) {
    std::string text;
    for (const Statement& statement : body) text += " " + shown(statement);
    return text;
  }

  static std::string shown(const Statement& statement) {
    const std::string v = name(statement.v), w = name(statement.w), k = std::to_string(statement.k);
    const std::string one = joined(statement.one), other = joined(statement.other);
    const std::string block = "b" + std::to_string(statement.block);
    switch (statement.kind) {
      case Kind::kSet:
        return "(setq " + v + " (rem (- (* 3 " + w + ") " + k + ") 100))";
      case Kind::kStep:
        return statement.k > 0 ? "(incf " + v + " " + k + ")" : "(decf " + v + ")";
      case Kind::kPush:
        return "(push " + v + " out)";
      case Kind::kPop:
        return "(setq " + v + " (or (pop out) " + k + "))";
      case Kind::kSwap:
        return "(setq " + v + " " + w + " " + w + " " + v + ")";
      case Kind::kIf:
        return "(if (< " + v + " " + k + ") (progn" + one + ") (progn" + other + "))";
      case Kind::kWhen:
        return "(progn (when (oddp " + v + ")" + one + ") (unless (oddp " + v + ")" + other + "))";
      case Kind::kCase:
        return "(case (mod " + v + " 3) (0" + one + ") ((1 " + k + ")" + other + ") (t (incf " + v +
               ")))";
      case Kind::kTimes:
        return "(dotimes (" + v + " " + k + ")" + one + ")";
      case Kind::kEach:
        return "(dolist (" + v + " (list " + k + " " + w + " 5))" + one + ")";
      case Kind::kDo:
        return "(do ((" + v + " 0 (1+ " + v + ")) (n 0 (1+ n)) (" + w + " " + k + " " + v +
               ")) ((or (>= n 4) (>= " + v + " " + k + ")) (push n out))" + one + ")";
      case Kind::kBlock:
        return "(block " + block + one + " (when (> " + v + " " + k + ") (return-from " + block +
               "))" + other + ")";
      case Kind::kLet:
        return "(let ((" + v + " " + w + ") (" + w + " " + v + "))" + one + ")";
      case Kind::kLetStar:
        return "(let* ((" + v + " " + w + ") (" + w + " (- " + v + ")))" + one + ")";
      case Kind::kReturn:
        return "(when (> " + v + " " + k + ") (return))";
    }
    return {};
  }

  /// Walks the tree; what leaves a block is a number: 0 the innermost loop, n + 1 block n.
  struct Machine {
    std::array<std::int64_t, kVariables> variables{1, 2, 3, -1};
    std::vector<std::int64_t> pushed;
    using Left = std::optional<std::size_t>;

    Left run(const Body& body) {
      for (const Statement& statement : body)
        if (const Left left = run(statement)) return left;
      return std::nullopt;
    }
    /// The body with values of its own for some variables.
    Left inside(const Body& body, std::size_t variable, std::int64_t value) {
      const std::int64_t outside = variables[variable];
      variables[variable] = value;
      const Left left = run(body);
      variables[variable] = outside;
      return left;
    }
    Left run(const Statement& statement) {
      std::int64_t& v = variables[statement.v];
      std::int64_t& w = variables[statement.w];
      const std::int64_t k = statement.k;
      switch (statement.kind) {
        case Kind::kSet:
          v = (3 * w - k) % 100;
          return std::nullopt;
        case Kind::kStep:
          v += k > 0 ? k : -1;
          return std::nullopt;
        case Kind::kPush:
          pushed.push_back(v);
          return std::nullopt;
        case Kind::kPop:
          v = pushed.empty() ? k : pushed.back();
          if (!pushed.empty()) pushed.pop_back();
          return std::nullopt;
        case Kind::kSwap:
          v = w;
          return std::nullopt;
        case Kind::kIf:
          return run(v < k ? statement.one : statement.other);
        case Kind::kReturn:
          return v > k ? Left(0) : std::nullopt;
        default:
          return run_nested(statement);
      }
    }
    Left run_nested(const Statement& statement) {
      std::int64_t& v = variables[statement.v];
      std::int64_t& w = variables[statement.w];
      switch (statement.kind) {
        case Kind::kWhen: {
          if (v % 2 != 0)
            if (const Left left = run(statement.one)) return left;
          return v % 2 == 0 ? run(statement.other) : std::nullopt;
        }
        case Kind::kCase: {
          const std::int64_t rest = (v % 3 + 3) % 3;
          if (rest == 0) return run(statement.one);
          if (rest == 1 || rest == statement.k) return run(statement.other);
          ++v;
          return std::nullopt;
        }
        case Kind::kBlock: {
          Left left = run(statement.one);
          if (!left && v <= statement.k) left = run(statement.other);
          return left == Left(statement.block + 1) ? std::nullopt : left;
        }
        case Kind::kLet:
          return both_inside(statement, w, v);
        case Kind::kLetStar:
          return both_inside(statement, w, -w);
        default:
          return loop(statement);
      }
    }
    Left both_inside(const Statement& statement, std::int64_t new_v, std::int64_t new_w) {
      const auto outside = variables;
      variables[statement.v] = new_v;
      variables[statement.w] = new_w;
      const Left left = run(statement.one);
      variables[statement.v] = outside[statement.v];
      variables[statement.w] = outside[statement.w];
      return left;
    }
    Left loop(const Statement& statement) {
      if (statement.kind == Kind::kDo) return loop_at_once(statement);
      std::vector<std::int64_t> values;
      if (statement.kind == Kind::kTimes)
        for (std::int64_t count = 0; count < statement.k; ++count) values.push_back(count);
      else
        values = {statement.k, variables[statement.w], 5};
      for (const std::int64_t value : values)
        if (const Left left = inside(statement.one, statement.v, value))
          return left == Left(0) ? std::nullopt : left;
      return std::nullopt;
    }
    Left loop_at_once(const Statement& statement) {
      const auto outside = variables;
      std::int64_t& v = variables[statement.v];
      std::int64_t& w = variables[statement.w];
      Left left;
      v = 0;
      w = statement.k;
      std::int64_t rounds = 0;
      for (; !left && rounds < 4 && v < statement.k; ++rounds) {
        left = run(statement.one);
        if (left) break;
        w = v;
        ++v;
      }
      if (!left) pushed.push_back(rounds);
      v = outside[statement.v];
      w = outside[statement.w];
      return left == Left(0) ? std::nullopt : left;
    }
  };

  Body body_;
};

}  // namespace skein::htn::test
