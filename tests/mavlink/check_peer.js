// SPDX-License-Identifier: Apache-2.0
// Reads the lines of say_messages with node-mavlink: it must find our frames, read what we wrote,
// and write the same bytes.   node check_peer.js < lines
'use strict';
const { MavLinkPacketParser, MavLinkPacketSplitter, MavLinkProtocolV2 } = require('node-mavlink');
const { minimal, standard, common } = require('mavlink-mappings');

const registry = { ...minimal.REGISTRY, ...standard.REGISTRY, ...common.REGISTRY };
const lines = require('fs').readFileSync(0, 'utf8').trim().split('\n').map((line) => JSON.parse(line));
const problems = [];
const expect = (holds, what) => { if (!holds && problems.length < 10) problems.push(what); };
const plain = (value) => (typeof value === 'bigint' ? Number(value) : value);
const same = (ours, theirs) => Math.fround(plain(ours)) === Math.fround(plain(theirs));

// What we hold as characters it holds as a text.
function check_field(name, type, ours, theirs) {
  if (type === 'char[]') return expect(theirs === String.fromCharCode(...ours), `${name}: '${theirs}'`);
  if (!Array.isArray(ours)) return expect(same(ours, theirs), `${name}: ${ours}, not ${theirs}`);
  ours.forEach((one, i) => expect(same(one, theirs[i]), `${name}[${i}]: ${one}, not ${theirs[i]}`));
}

const splitter = new MavLinkPacketSplitter();
const parser = splitter.pipe(new MavLinkPacketParser());
let read = 0;
parser.on('data', (packet) => {
  const line = lines[read++];
  const type = registry[packet.header.msgid];
  expect(type && packet.header.msgid === line.id && type.MSG_NAME === line.name, `type of ${line.name}`);
  expect(type.MAGIC_NUMBER === line.crc_extra, `CRC_EXTRA of ${line.name}`);
  expect(type.PAYLOAD_LENGTH === line.length, `length of ${line.name}`);
  expect(packet.header.sysid === 7 && packet.header.compid === 191, `sender of ${line.name}`);
  const message = packet.protocol.data(packet.payload, type);
  const names = Object.keys(line.fields);
  expect(names.join() === type.FIELDS.map((field) => field.source).join(), `fields of ${line.name}`);
  for (const field of type.FIELDS) {
    check_field(`${line.name}.${field.source}`, field.type, line.fields[field.source], message[field.name]);
  }
  // Of a payload of zeros it leaves nothing, where the protocol keeps the first byte.
  if (Object.values(line.fields).flat().every((value) => value === 0)) return;
  const again = new MavLinkProtocolV2(7, 191).serialize(message, line.sequence);
  expect(again.toString('hex') === line.frame, `${line.name} written again`);
});
parser.on('end', () => {
  expect(read === lines.length, `${read} of ${lines.length} frames were found`);
  problems.forEach((problem) => console.error(problem));
  console.log(`${read} frames of ${new Set(lines.map((line) => line.id)).size} types read, compared and written again`);
  process.exit(problems.length ? 1 : 0);
});
splitter.end(Buffer.concat(lines.map((line) => Buffer.from(line.frame, 'hex'))));
