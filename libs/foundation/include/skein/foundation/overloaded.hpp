// SPDX-License-Identifier: Apache-2.0
// One visitor of a variant from several lambdas.
#pragma once

namespace skein {

/// `std::visit(Overloaded{[](const A&) {…}, [](const B&) {…}}, variant)`.
template <class... Handlers>
struct Overloaded : Handlers... {
  using Handlers::operator()...;
};
template <class... Handlers>
Overloaded(Handlers...) -> Overloaded<Handlers...>;

}  // namespace skein
