// SPDX-License-Identifier: Apache-2.0
// A term of the SHOP2 language: four bytes; what it stands for lives in a TermStore.
#pragma once

#include <cstdint>
#include <functional>

namespace skein::htn {

enum class TermKind : std::uint32_t {
  kSymbol,    ///< a name, kept in lower case; `nil` is the symbol kNil and the empty list
  kNumber,    ///< integer, ratio, single or double float
  kString,    ///< text, case kept
  kPair,      ///< (car . cdr); lists end in kNil
  kObject,    ///< opaque value of the host
  kSlot,      ///< variable of a clause (operator, method, axiom), by its position in the clause
  kVariable,  ///< variable of a search, by its cell
  kLocal      ///< variable of a stored answer, renamed to a fresh cell when the answer is used
};

/// Handle of a term. Equal handles are equal terms (Lisp `equal`), because a store keeps each term
/// once. Cheap to copy; meaningless without its store.
class Term {
 public:
  constexpr Term() = default;  ///< nil
  constexpr Term(TermKind kind, std::uint32_t index)
      : bits_((index << kKindBits) | static_cast<std::uint32_t>(kind)) {}
  constexpr TermKind kind() const { return static_cast<TermKind>(bits_ & kKindMask); }
  constexpr std::uint32_t index() const { return bits_ >> kKindBits; }
  constexpr std::uint32_t bits() const { return bits_; }
  constexpr bool is(TermKind kind) const { return this->kind() == kind; }
  constexpr bool operator==(const Term&) const = default;

 private:
  static constexpr std::uint32_t kKindBits = 3;
  static constexpr std::uint32_t kKindMask = (1U << kKindBits) - 1;
  std::uint32_t bits_ = 0;
};

/// The symbol `nil`: false, and the empty list.
inline constexpr Term kNil{TermKind::kSymbol, 0};
/// The symbol `t`: true.
inline constexpr Term kTrue{TermKind::kSymbol, 1};

}  // namespace skein::htn

template <>
struct std::hash<skein::htn::Term> {
  std::size_t operator()(skein::htn::Term term) const noexcept {
    return static_cast<std::size_t>(term.bits() * 0x9E3779B97F4A7C15ULL >> 16U);
  }
};
