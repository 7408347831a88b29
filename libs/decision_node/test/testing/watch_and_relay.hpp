// SPDX-License-Identifier: Apache-2.0
// A small library of joint tasks: one watches a front, one relays.
#pragma once

#include <memory>
#include <string>

#include "interaction/joint.hpp"
#include "skein/config/parse.hpp"
#include "skein/interaction/read_library.hpp"

namespace skein::decision_node::testing {

inline constexpr const char* kLibrary = R"yaml(
tasks:
  goto: {to: Point, "speed?": Number}
  takeshot-while-waiting: {duration: Time, "target?": Obj}
  synchro: {senders: UAVlist, receivers: UAVlist}
functions:
  valid-position: {takes: [], gives: Point}
  best-view: {takes: [Point, Point], gives: Point}
scms:
  separation:
    parameters: {from: Place, least: Number}
    constraints: [{distance-to: from, is: ">", than: least}]
  near:
    parameters: {target: Place, far: Number}
    constraints: [{distance-to: target, is: "<", than: far}]
roles:
  watch:
    needs: [hovering, {camera: visible}]
    parameters: {front: Obj, duration: Time, uavs: UAVlist}
    automaton:
      block: w10
      local: {place: "valid-position()"}
      content:
        - {task: w1, type: goto, params: {to: place}}
        - block: w11
          pre: [[{componel: w1, state: ended}]]
          content: [{task: w2, type: synchro, params: {senders: uavs, receivers: uavs}}]
        - block: w12
          type: loop
          pre: [[{componel: w11, state: ended}]]
          exit: [[{componel: w3, state: ended}]]
          content: [{task: w3, type: takeshot-while-waiting, params: {duration: duration, target: front}}]
        - block: w13
          pre: [[{componel: w12, state: over}]]
          content: [{task: w4, type: synchro, params: {senders: uavs, receivers: uavs}}]
  relay:
    needs: [hovering, relay]
    parameters: {ground: Point, uavs: UAVlist}
    automaton:
      block: r10
      content:
        - {task: r1, type: goto, params: {to: ground}}
        - block: r11
          pre: [[{componel: r1, state: ended}]]
          content: [{task: r2, type: synchro, params: {senders: uavs, receivers: uavs}}]
        - block: r12
          pre: [[{componel: r11, state: ended}]]
          content: [{task: r3, type: synchro, params: {senders: uavs, receivers: uavs}}]
        - block: r13
          end: immediate
          pre: [[{componel: r12, state: over}]]
          content: [{task: r4, type: goto, params: {to: ground}}]
models:
  watching:
    variants:
      pair:
        parameters: {front: Obj, ground: Point, duration: Time, uavs: UAVlist}
        roles: [watch, relay]
        coordination:
          arity: {watch: 1, relay: 1}
          scms:
            apart: {scm: separation, from: R*, least: 20}
            in-view: {scm: near, target: front, far: 50}
          blocks:
            apart: {watch: [w10], relay: [r10]}
            in-view: {watch: [w12]}
          parameters:
            watch: {front: front, duration: duration, uavs: uavs}
            relay: {ground: ground, uavs: uavs}
)yaml";

inline std::shared_ptr<const interaction::Library> watching_library() {
  const auto value = config::parse_yaml(kLibrary, "watching.yaml");
  auto library = interaction::read_library({{"watching.yaml", value.value()}});
  return std::make_shared<const interaction::Library>(std::move(library.value()));
}

/// As the supervisor asks for it.
inline mission::ElementaryTask watching(const std::string& uavs = "marvin heliv",
                                        double duration = 60) {
  mission::ElementaryTask task;
  task.id = executive::TaskId(7);
  task.type = "joint:watching";
  task.parameters.add("front", std::string("fire"));
  task.parameters.add("ground", {0, 0, 5});
  task.parameters.add("duration", duration);
  task.parameters.add("uavs", uavs);
  return task;
}

inline Joint joint(const std::string& self = "marvin") {
  const std::string other = self == "marvin" ? "heliv" : "marvin";
  return joint_of(watching(), watching_library(), self, {other}).value();
}

}  // namespace skein::decision_node::testing
