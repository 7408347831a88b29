// SPDX-License-Identifier: Apache-2.0
// Reads a recording by another's reader and judges it; see check_recordings.py.
import assert from "node:assert";
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import * as published from "@foxglove/schemas/jsonschema.js";
import Ajv from "ajv";

const [file, log] = process.argv.slice(2);
const bytes = fs.readFileSync(file);
const by = (command) => (buffer) => execFileSync(command, ["-dc"], { input: buffer, maxBuffer: 1 << 30 });
const decompressHandlers = { zstd: by("zstd"), lz4: by("lz4") };
const readable = {
  size: async () => BigInt(bytes.length),
  read: async (offset, size) => new Uint8Array(bytes.subarray(Number(offset), Number(offset + size))),
};

const indexed = await McapIndexedReader.Initialize({ readable, decompressHandlers });
const ajv = new Ajv({ strict: false });
const judges = new Map(["LocationFix", "GeoJSON", "Log"].map((name) => ["foxglove." + name, ajv.compile(published[name])]));
const own = new Map();  // our schemas, judged by themselves
let count = 0, judged = 0;
const records = [];
for await (const message of indexed.readMessages({ validateCrcs: true })) {
  ++count;
  const channel = indexed.channelsById.get(message.channelId);
  if (channel.messageEncoding !== "json") continue;
  const schema = indexed.schemasById.get(channel.schemaId);
  const text = new TextDecoder().decode(message.data);
  const content = JSON.parse(text);
  if (!own.has(schema.name)) own.set(schema.name, ajv.compile(JSON.parse(new TextDecoder().decode(schema.data))));
  for (const judge of [judges.get(schema.name), own.get(schema.name)]) {
    if (!judge) continue;
    assert(judge(content), `${channel.topic}: ${ajv.errorsText(judge.errors)}: ${text}`);
    ++judged;
  }
  if (schema.name === "foxglove.GeoJSON") {
    const map = JSON.parse(content.geojson);
    assert.equal(map.type, "FeatureCollection");
    for (const feature of map.features) assert.equal(feature.type, "Feature");
  }
  if (schema.name.startsWith("skein.") && schema.name !== "skein.Sample") records.push(text);
}
assert.equal(BigInt(count), indexed.statistics.messageCount);
if (records.length > 0) {
  const lines = fs.readFileSync(log, "utf8").trim().split("\n");
  assert.deepEqual(records.sort(), lines.sort(), "every line of the event log, as it is");
}

function streamed(part) {
  const reader = new McapStreamReader({ decompressHandlers, validateCrcs: true });
  let messages = 0;
  reader.append(new Uint8Array(part));
  for (let record; (record = reader.nextRecord()) != undefined; ) messages += record.type === "Message" ? 1 : 0;
  return messages;
}
assert.equal(streamed(bytes), count);
const cut = streamed(bytes.subarray(0, Math.floor(bytes.length * 0.6)));
assert(cut > 0 && cut < count, `a cut file gives some of the messages: ${cut} of ${count}`);
console.log(`${count} messages on ${indexed.channelsById.size} channels, ${judged} judged by schemas, ${cut} of a cut file`);
