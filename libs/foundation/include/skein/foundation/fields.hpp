// SPDX-License-Identifier: Apache-2.0
// The fields of an aggregate, one after the other.
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

namespace skein {

namespace detail {

/// Becomes whatever a field is; only for counting.
struct AnyField {
  template <class T>
  operator T() const;  // NOLINT(google-explicit-constructor): that is what it is for
};

template <class T, std::size_t... I>
constexpr bool has_fields(std::index_sequence<I...> /*numbers*/) {
  return requires { T{(void(I), AnyField{})...}; };
}

inline constexpr std::size_t kMostFields = 24;

template <class T, std::size_t N = kMostFields + 1>
constexpr std::size_t count_fields() {
  if constexpr (N == 0 || has_fields<T>(std::make_index_sequence<N>{})) {
    return N;
  } else {
    return count_fields<T, N - 1>();
  }
}

template <std::size_t N>
using Count = std::integral_constant<std::size_t, N>;

template <class Visit, class... Fields>
void visit_all(Visit& visit, const Fields&... fields) {
  (visit(fields), ...);
}

template <class T, class Visit>
void visit_fields(const T& /*whole*/, Visit& /*visit*/, Count<0> /*fields*/) {}
template <class T, class Visit>
void visit_fields(const T& whole, Visit& visit, Count<1> /*fields*/) {
  const auto& [f1] = whole;
  visit_all(visit, f1);
}
template <class T, class Visit>
void visit_fields(const T& whole, Visit& visit, Count<2> /*fields*/) {
  const auto& [f1, f2] = whole;
  visit_all(visit, f1, f2);
}
template <class T, class Visit>
void visit_fields(const T& whole, Visit& visit, Count<3> /*fields*/) {
  const auto& [f1, f2, f3] = whole;
  visit_all(visit, f1, f2, f3);
}
template <class T, class Visit>
void visit_fields(const T& whole, Visit& visit, Count<4> /*fields*/) {
  const auto& [f1, f2, f3, f4] = whole;
  visit_all(visit, f1, f2, f3, f4);
}
template <class T, class Visit>
void visit_fields(const T& whole, Visit& visit, Count<5> /*fields*/) {
  const auto& [f1, f2, f3, f4, f5] = whole;
  visit_all(visit, f1, f2, f3, f4, f5);
}
template <class T, class Visit>
void visit_fields(const T& whole, Visit& visit, Count<6> /*fields*/) {
  const auto& [f1, f2, f3, f4, f5, f6] = whole;
  visit_all(visit, f1, f2, f3, f4, f5, f6);
}
template <class T, class Visit>
void visit_fields(const T& whole, Visit& visit, Count<7> /*fields*/) {
  const auto& [f1, f2, f3, f4, f5, f6, f7] = whole;
  visit_all(visit, f1, f2, f3, f4, f5, f6, f7);
}
template <class T, class Visit>
void visit_fields(const T& whole, Visit& visit, Count<8> /*fields*/) {
  const auto& [f1, f2, f3, f4, f5, f6, f7, f8] = whole;
  visit_all(visit, f1, f2, f3, f4, f5, f6, f7, f8);
}
template <class T, class Visit>
void visit_fields(const T& whole, Visit& visit, Count<9> /*fields*/) {
  const auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9] = whole;
  visit_all(visit, f1, f2, f3, f4, f5, f6, f7, f8, f9);
}
template <class T, class Visit>
void visit_fields(const T& whole, Visit& visit, Count<10> /*fields*/) {
  const auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9, f10] = whole;
  visit_all(visit, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10);
}
template <class T, class Visit>
void visit_fields(const T& whole, Visit& visit, Count<11> /*fields*/) {
  const auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11] = whole;
  visit_all(visit, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11);
}
template <class T, class Visit>
void visit_fields(const T& whole, Visit& visit, Count<12> /*fields*/) {
  const auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12] = whole;
  visit_all(visit, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12);
}
template <class T, class Visit>
void visit_fields(const T& whole, Visit& visit, Count<13> /*fields*/) {
  const auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13] = whole;
  visit_all(visit, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13);
}
template <class T, class Visit>
void visit_fields(const T& whole, Visit& visit, Count<14> /*fields*/) {
  const auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14] = whole;
  visit_all(visit, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14);
}
template <class T, class Visit>
void visit_fields(const T& whole, Visit& visit, Count<15> /*fields*/) {
  const auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15] = whole;
  visit_all(visit, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15);
}
template <class T, class Visit>
void visit_fields(const T& whole, Visit& visit, Count<16> /*fields*/) {
  const auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16] = whole;
  visit_all(visit, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16);
}
template <class T, class Visit>
void visit_fields(const T& whole, Visit& visit, Count<17> /*fields*/) {
  const auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17] = whole;
  visit_all(visit, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17);
}
template <class T, class Visit>
void visit_fields(const T& whole, Visit& visit, Count<18> /*fields*/) {
  const auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18] =
      whole;
  visit_all(visit, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18);
}
template <class T, class Visit>
void visit_fields(const T& whole, Visit& visit, Count<19> /*fields*/) {
  const auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18,
               f19] = whole;
  visit_all(visit, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18,
            f19);
}
template <class T, class Visit>
void visit_fields(const T& whole, Visit& visit, Count<20> /*fields*/) {
  const auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
               f20] = whole;
  visit_all(visit, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18,
            f19, f20);
}
template <class T, class Visit>
void visit_fields(const T& whole, Visit& visit, Count<21> /*fields*/) {
  const auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
               f20, f21] = whole;
  visit_all(visit, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18,
            f19, f20, f21);
}
template <class T, class Visit>
void visit_fields(const T& whole, Visit& visit, Count<22> /*fields*/) {
  const auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
               f20, f21, f22] = whole;
  visit_all(visit, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18,
            f19, f20, f21, f22);
}
template <class T, class Visit>
void visit_fields(const T& whole, Visit& visit, Count<23> /*fields*/) {
  const auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
               f20, f21, f22, f23] = whole;
  visit_all(visit, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18,
            f19, f20, f21, f22, f23);
}
template <class T, class Visit>
void visit_fields(const T& whole, Visit& visit, Count<24> /*fields*/) {
  const auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
               f20, f21, f22, f23, f24] = whole;
  visit_all(visit, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18,
            f19, f20, f21, f22, f23, f24);
}

}  // namespace detail

/// Calls `visit` with every field of an aggregate without base classes, in order; of at most 24
/// fields, else it does not compile. So what is made of "all that a struct says" holds for a field
/// that is added later, too.
template <class T, class Visit>
requires std::is_aggregate_v<T>
void for_each_field(const T& whole, Visit&& visit) {
  constexpr std::size_t kFields = detail::count_fields<T>();
  static_assert(kFields <= detail::kMostFields, "too many fields");
  detail::visit_fields(whole, visit, detail::Count<kFields>{});
}

}  // namespace skein
