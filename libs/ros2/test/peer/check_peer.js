// SPDX-License-Identifier: Apache-2.0
// Reads what skein_ros2_say_messages prints by the message definitions that distributions of ROS 2 publish, with a reader of
// ROS 2's bytes that is not ours, and compares every field; then how that writes the same message, byte for byte.
"use strict";
const distributions = require("@foxglove/rosmsg-msgs-common");
const {MessageReader, MessageWriter} = require("@foxglove/rosmsg2-serialization");

/** A definition with all that it is made of, as the reader wants them: the first is the message. */
function closure(all, name, found = new Map()) {
  if (found.has(name)) return found;
  const of = all[name];
  if (!of) throw new Error(`${name} is not among the definitions`);
  found.set(name, of);
  for (const field of of.definitions) if (field.isComplex) closure(all, field.type, found);
  return found;
}

/** Fields in the order of the definition; its constants are no fields. */
function flat(value, type, known) {
  const fields = known.get(type).definitions.filter((field) => !field.isConstant);
  return fields.map((field) => {
    const one = value[field.name];
    if (field.type === "time") return [one.sec, one.nanosec];
    const inner = (item) => (field.isComplex ? flat(item, field.type, known) : item);
    return field.isArray ? Array.from(one, inner) : inner(one);
  });
}

/** Numbers of four bytes came as the shortest text that gives them back. */
const same = (ours, theirs) => Array.isArray(ours)
  ? ours.length === theirs.length && ours.every((one, i) => same(one, theirs[i]))
  : ours === theirs || (typeof ours === "number" && Math.fround(ours) === theirs);

const lines = require("fs").readFileSync(0, "utf8").trim().split("\n").map((line) => JSON.parse(line));
const names = Object.keys(distributions).filter((name) => /^ros2(humble|iron|jazzy)$/.test(name));
if (!names.length) throw new Error("no definitions of ROS 2");
let wrong = 0;
for (const distribution of names) {
  const read = new Map();
  for (const {type, fields, bytes} of lines) {
    const name = type.replace(/::msg::dds_::(\w+)_$/, "/$1");
    if (!read.has(name)) {
      const known = closure(distributions[distribution], name);
      read.set(name, {known, reader: new MessageReader([...known.values()]), writer: new MessageWriter([...known.values()]), count: 0});
    }
    const {known, reader, writer} = read.get(name);
    const buffer = Buffer.from(bytes, "hex");
    const theirs = reader.readMessage(buffer);
    const back = Buffer.from(writer.writeMessage(theirs));
    read.get(name).count += 1;
    if (same(fields, flat(theirs, name, known)) && back.equals(buffer)) continue;
    wrong += 1;
    if (wrong < 5) console.log(`${distribution} ${name}: said ${JSON.stringify(fields)}, read ${JSON.stringify(flat(theirs, name, known))}\n  ${bytes}\n  ${back.toString("hex")}`);
  }
  console.log(`${distribution}: ${[...read].map(([name, {count}]) => `${count} ${name}`).join(", ")}`);
}
console.log(`${wrong} otherwise`);
process.exit(wrong ? 1 : 0);
