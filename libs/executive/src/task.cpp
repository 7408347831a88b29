// SPDX-License-Identifier: Apache-2.0
// The words of the vocabulary, and the small members of its types.
#include "skein/executive/task.hpp"

#include <array>
#include <utility>

#include "skein/executive/input.hpp"

namespace skein::executive {

namespace {

template <class E, std::size_t N>
using Words = std::array<std::pair<E, std::string_view>, N>;

constexpr Words<InsertionMode, 4> kModes{{{InsertionMode::kSeq, "SEQ"},
                                          {InsertionMode::kVut, "VUT"},
                                          {InsertionMode::kDep, "DEP"},
                                          {InsertionMode::kNut, "NUT"}}};
constexpr Words<RequestKind, 5> kRequests{{{RequestKind::kStart, "START"},
                                           {RequestKind::kAbort, "ABORT"},
                                           {RequestKind::kProcessMessage, "PROCESS-MSG"},
                                           {RequestKind::kUpdateConditions, "UPDATE-COND"},
                                           {RequestKind::kSuppress, "SUPPRESS"}}};

constexpr Words<SyncWord, 3> kSyncWords{
    {{SyncWord::kThere, "there"}, {SyncWord::kDone, "done"}, {SyncWord::kWithdrawn, "withdrawn"}}};

template <class E, std::size_t N>
std::string_view word_of(const Words<E, N>& words, E value) {
  for (const auto& [one, word] : words) {
    if (one == value) return word;
  }
  return "?";
}

template <class E, std::size_t N>
std::optional<E> value_of(const Words<E, N>& words, std::string_view text) {
  for (const auto& [one, word] : words) {
    if (word == text) return one;
  }
  return std::nullopt;
}

}  // namespace

std::string_view to_text(InsertionMode mode) { return word_of(kModes, mode); }
std::optional<InsertionMode> insertion_mode_from(std::string_view text) {
  return value_of(kModes, text);
}

std::string_view to_text(SyncWord word) { return word_of(kSyncWords, word); }
std::optional<SyncWord> sync_word_from(std::string_view text) { return value_of(kSyncWords, text); }

std::string_view to_text(RequestKind kind) { return word_of(kRequests, kind); }
std::optional<RequestKind> request_kind_from(std::string_view text) {
  return value_of(kRequests, text);
}

std::string_view to_text(Modality modality) {
  return modality == Modality::kMandatory ? "mandatory" : "optional";
}

bool is_joint(std::string_view type) { return type.substr(0, kJointPrefix.size()) == kJointPrefix; }

}  // namespace skein::executive
