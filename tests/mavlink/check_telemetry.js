// SPDX-License-Identifier: Apache-2.0
// Plays a scenario with --mavlink-out, hears it by UDP, and holds what node-mavlink reads against the event log.
//   node check_telemetry.js SKEIN SCENARIO FOLDER
'use strict';
const { MavLinkPacketParser, MavLinkPacketSplitter } = require('node-mavlink');
const { minimal, standard, common } = require('mavlink-mappings');
const { spawn } = require('child_process');
const fs = require('fs');

const [skein, scenario, folder] = process.argv.slice(2);
const registry = { ...minimal.REGISTRY, ...standard.REGISTRY, ...common.REGISTRY };
const problems = [];
const expect = (holds, what) => { if (!holds && problems.length < 20) problems.push(what); };

const systems = new Map();  // id: messages by name, in order
const splitter = new MavLinkPacketSplitter();
let packets = 0, sequences = new Map();
splitter.pipe(new MavLinkPacketParser()).on('data', (packet) => {
  const type = registry[packet.header.msgid];
  expect(type, `message ${packet.header.msgid}`);
  const id = packet.header.sysid;
  const before = sequences.get(id);
  expect(before === undefined || packet.header.seq === (before + 1) % 256, `sequence of ${id}: ${before}, ${packet.header.seq}`);
  sequences.set(id, packet.header.seq);
  if (!systems.has(id)) systems.set(id, {});
  const messages = systems.get(id);
  (messages[type.MSG_NAME] ||= []).push(packet.protocol.data(packet.payload, type));
  packets++;
});

// Degrees of a place near the origin, by the radii of curvature of WGS 84.
function on_earth(origin, [x, y]) {
  const rad = Math.PI / 180, a = 6378137, e2 = 6.69437999014e-3, phi = origin.latitude * rad;
  const w = 1 - e2 * Math.sin(phi) ** 2;
  return [origin.latitude + y / (a * (1 - e2) / w ** 1.5 + origin.altitude) / rad,
          origin.longitude + x / ((a / Math.sqrt(w) + origin.altitude) * Math.cos(phi)) / rad];
}

function truth_at(track, at) {
  const next = track.findIndex((one) => one.at >= at);
  if (next <= 0) return null;
  const [a, b] = [track[next - 1], track[next]];
  if (b.at - a.at > 1.5) return null;
  const part = (at - a.at) / (b.at - a.at);
  return a.position.map((value, i) => value + part * (b.position[i] - value));
}

function check_positions(name, positions, track, origin) {
  let compared = 0, worst = 0;
  for (const one of positions) {
    const truth = truth_at(track, one.timeBootMs / 1000);
    if (!truth) continue;
    const [latitude, longitude] = on_earth(origin, truth);
    const north = (one.lat / 1e7 - latitude) * 111000;
    const east = (one.lon / 1e7 - longitude) * 111000 * Math.cos(latitude * Math.PI / 180);
    const up = one.alt / 1000 - (origin.altitude + truth[2]);
    worst = Math.max(worst, Math.hypot(north, east, up));
    compared++;
  }
  expect(compared >= 20, `${name}: only ${compared} positions to compare`);
  expect(worst < 5, `${name}: ${worst.toFixed(1)} m from the truth`);
  return `${name}: ${compared} positions, ${worst.toFixed(1)} m from the truth at most`;
}

function judge() {
  const info = JSON.parse(fs.readFileSync(`${folder}/run.json`, 'utf8'));
  const records = fs.readFileSync(`${folder}/events.jsonl`, 'utf8').trim().split('\n').map((line) => JSON.parse(line));
  const said = [];
  info.uavs.forEach((uav, index) => {
    const messages = systems.get(index + 1) || {};
    for (const name of ['HEARTBEAT', 'SYS_STATUS', 'BATTERY_STATUS', 'EXTENDED_SYS_STATE', 'GLOBAL_POSITION_INT', 'ATTITUDE'])
      expect((messages[name] || []).length > 0, `${uav.name}: no ${name}`);
    const beats = messages.HEARTBEAT || [];
    expect(beats.some((one) => one.baseMode & 128) && beats.some((one) => !(one.baseMode & 128)), `${uav.name}: armed and not`);
    const left = (messages.BATTERY_STATUS || []).map((one) => one.batteryRemaining);
    expect(left.every((one, i) => one >= 0 && one <= 100 && (i === 0 || one <= left[i - 1])), `${uav.name}: battery ${left}`);
    const track = records.filter((one) => one.kind === 'telemetry' && one.uav === uav.name);
    said.push(check_positions(uav.name, messages.GLOBAL_POSITION_INT || [], track, info.origin));
  });
  expect([...systems.keys()].every((id) => id >= 1 && id <= info.uavs.length), `systems ${[...systems.keys()]}`);
  const texts = [...systems.values()].flatMap((one) => (one.STATUSTEXT || []).map((text) => text.text));
  for (const alarm of records.filter((one) => one.kind === 'alarm'))
    expect(texts.includes(`alarm ${alarm.alarm} ${alarm.state}`), `alarm ${alarm.alarm} ${alarm.state} was not said`);
  expect(records.some((one) => one.kind === 'alarm'), 'no alarm in this mission');
  console.log(`${packets} packets of ${systems.size} systems, ${texts.length} texts; ${said.join('; ')}`);
}

const socket = require('dgram').createSocket('udp4');
socket.on('message', (bytes) => splitter.write(bytes));
socket.bind(0, '127.0.0.1', () => {
  const child = spawn(skein, ['run', scenario, '--rate', '25', '--quiet', '--out', folder,
    '--mavlink-out', `udp:127.0.0.1:${socket.address().port}`], { stdio: ['ignore', 'ignore', 'inherit'] });
  child.on('exit', (code) => {
    expect(code === 0, `skein run ended with ${code}`);
    setImmediate(() => {
      socket.close();
      splitter.end(() => setImmediate(() => {
        if (fs.existsSync(`${folder}/run.json`)) judge();
        problems.forEach((problem) => console.error(problem));
        process.exit(problems.length ? 1 : 0);
      }));
    });
  });
});
