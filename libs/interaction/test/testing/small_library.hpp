// SPDX-License-Identifier: Apache-2.0
// A library that is right, to be made wrong in one place.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "skein/config/parse.hpp"
#include "skein/interaction/read_library.hpp"

namespace skein::interaction::testing {

inline const std::string kSmallLibrary = R"yaml(tasks:
  goto: {to: Point, "speed?": Number}
  look: {at: Obj, duration: Time}
functions:
  between: {takes: [Point, Point], gives: Point}
scms:
  near: {parameters: {place: Place, most: Number}, constraints: [{distance-to: place, is: "<", than: most}]}
  ring:
    parameters: {place: Place, aside: Place, near: Number, far: Number}
    constraints:
      - {distance-to: place, is: ">", than: near}
      - {distance-to: place, is: "<", than: far}
      - {azimuth: [place, aside], is: "=", than: 0, tolerance: 0.1}
roles:
  looker:
    needs: [hovering, {camera: visible}, "endurance >= 900"]
    parameters: {target: Obj, home: Point, span: Time}
    automaton:
      block: l0
      local: {spot: "between(target, home)"}
      content:
        - {task: l1, type: goto, params: {to: spot, speed: 5}}
        - {block: l2, pre: [[{message: ring violated}]], content: [{action: l3, modality: role-allocation}]}
        - {block: l4, end: immediate, pre: [[{componel: l1, state: ended}]], content: [{task: l5, type: look, params: {at: target, duration: span}}]}
  helper:
    parameters: {home: Point}
    automaton: {block: h0, content: [{action: h1, modality: role-allocation}, {task: h2, type: goto, params: {to: [1, 2, 3]}}]}
models:
  looking:
    variants:
      pair:
        parameters: {what: Obj, base: Point, time: Time}
        roles: [looker, helper]
        coordination:
          arity: {looker: 1, helper: {between: [1, 3]}}
          actions:
            - {role: looker, action: l3, with: helper, target: h1, who: 1}
            - {role: helper, action: h1, with: looker, target: l3, who: everyone}
          scms:
            ring: {scm: ring, place: what, aside: base, near: 25, far: 50}
            close: {scm: near, place: looker, most: 100}
          blocks: {ring: {looker: [l0]}, close: {helper: [h0]}}
          parameters:
            looker: {target: what, home: base, span: time}
            helper: {home: base}
)yaml";

/// The small library with one piece of text in place of another.
inline std::string small_library(const std::string& old = "", const std::string& put = "") {
  std::string text = kSmallLibrary;
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  if (old.empty() || at == std::string::npos) return text;
  return text.replace(at, old.size(), put);
}

inline Result<Library, Diagnostics> library_of(const std::string& text) {
  auto value = config::parse_yaml(text, "lib.yaml");
  if (!value) return tl::unexpected<Diagnostics>(value.error());
  return read_library({Document{"lib.yaml", std::move(*value)}});
}

}  // namespace skein::interaction::testing
