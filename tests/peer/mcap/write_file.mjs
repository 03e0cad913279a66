// SPDX-License-Identifier: GPL-3.0-or-later
// write_file.mjs FILE none|zstd|unchunked|json: writes a file as another program does. Prints what is in it: the columns
// of each stream, and the values of each row.
import { open } from "node:fs/promises";
import { core, FileHandleWritable, MessageWriter, parse, require } from "./peers.mjs";

const [, , path, mode] = process.argv;

const header = `
================================================================================
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id
================================================================================
MSG: builtin_interfaces/Time
int32 sec
uint32 nanosec
`;
const definitions = {
  "sensor_msgs/msg/Image": `std_msgs/Header header
uint32 height
uint32 width
string encoding
uint8 is_bigendian
uint32 step
uint8[] data${header}`,
  "sensor_msgs/msg/JointState": `std_msgs/Header header
string[] name
float64[] position
float64[] velocity
float64[] effort${header}`,
  "geometry_msgs/msg/WrenchStamped": `std_msgs/Header header
geometry_msgs/Wrench wrench${header}================================================================================
MSG: geometry_msgs/Wrench
geometry_msgs/Vector3 force
geometry_msgs/Vector3 torque
================================================================================
MSG: geometry_msgs/Vector3
float64 x
float64 y
float64 z
`,
  "std_msgs/msg/String": "string data\n",
};

const options = { writable: new FileHandleWritable(await open(path, "w")), useChunks: mode !== "unchunked", chunkSize: 3000 };
if (mode === "zstd") {
  const zstd = require("@foxglove/wasm-zstd");
  await zstd.isLoaded;
  options.compressChunk = (data) => ({ compression: "zstd", compressedData: new Uint8Array(zstd.compress(data, 3)) });
}
const writer = new core.McapWriter(options);
await writer.start({ profile: mode === "json" ? "" : "ros2", library: "the peer" });

async function addTopic(topic, type) {
  const schemaId = await writer.registerSchema({
    name: type,
    encoding: mode === "json" ? "jsonschema" : "ros2msg",
    data: new TextEncoder().encode(definitions[type]),
  });
  const channelId = await writer.registerChannel({
    schemaId,
    topic,
    messageEncoding: mode === "json" ? "json" : "cdr",
    metadata: new Map(),
  });
  return { channelId, encoder: new MessageWriter(parse(definitions[type], { ros2: true })) };
}

let sequence = 0;
async function add({ channelId, encoder }, time, message) {
  const data = mode === "json" ? new TextEncoder().encode("{}") : encoder.writeMessage(message);
  await writer.addMessage({ channelId, sequence: ++sequence, logTime: time, publishTime: time, data });
}

const columns = {
  mat: ["t0", "t1", "t2", "t3", "t4", "t5"],
  joint_states: ["q1", "q2", "tau1", "tau2"],
  wrist: ["force_x_n", "force_y_n", "force_z_n", "torque_x_nm", "torque_y_nm", "torque_z_nm"],
};
const rows = [];
const chatter = await addTopic("/chatter", "std_msgs/msg/String");
if (mode === "json") {
  await add(chatter, 1n, {});
} else {
  const mat = await addTopic("/mat", "sensor_msgs/msg/Image");
  const joints = await addTopic("/joint_states", "sensor_msgs/msg/JointState");
  const wrist = await addTopic("/wrist", "geometry_msgs/msg/WrenchStamped");
  const start = 1790000000123000000n; // whole milliseconds, where a recording begins
  for (let i = 0; i < 100; ++i) {
    const time = start + BigInt(i) * 5000003n;
    const stamp = { sec: Number(time / 1000000000n), nanosec: Number(time % 1000000000n) };
    const head = { stamp, frame_id: "somewhere" };
    const values = Float32Array.from({ length: 6 }, (_, column) => Math.sin(i + column));
    const q = [Math.cos(i), i / 7];
    const tau = [i * 0.01, -i];
    const force = { x: i, y: -i / 3, z: 0.1 * i };
    const torque = { x: 1 / (i + 1), y: 2, z: -3 };
    await add(mat, time, {
      header: head,
      height: 2,
      width: 3,
      encoding: "32FC1",
      is_bigendian: 0,
      step: 12,
      data: new Uint8Array(values.buffer),
    });
    await add(joints, time, { header: head, name: ["shoulder", "elbow"], position: q, velocity: [], effort: tau });
    await add(wrist, time, { header: head, wrench: { force, torque } });
    await add(chatter, time, { data: `message ${i}` });
    rows.push({
      time_s: Number(time - start) / 1e9,
      mat: [...values],
      joint_states: [...q, ...tau],
      wrist: [force.x, force.y, force.z, torque.x, torque.y, torque.z],
    });
  }
}
await writer.addAttachment({
  name: "note.txt",
  logTime: 1n,
  createTime: 1n,
  mediaType: "text/plain",
  data: new TextEncoder().encode("a note"),
});
await writer.addMetadata({ name: "note", metadata: new Map([["key", "value"]]) });
await writer.end();
console.log(JSON.stringify({ columns, rows }));
