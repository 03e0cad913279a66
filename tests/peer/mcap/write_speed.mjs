// SPDX-License-Identifier: GPL-3.0-or-later
// write_speed.mjs FILE tactile|pictures N: writes as many messages as an export of so many frames has, with @mcap/core.
import { open } from "node:fs/promises";
import { randomBytes } from "node:crypto";
import { deflateSync } from "node:zlib";
import { core, FileHandleWritable, MessageWriter, parse, require } from "./peers.mjs";

const [, , path, what, count] = process.argv;
const zstd = require("@foxglove/wasm-zstd");
await zstd.isLoaded;
const writer = new core.McapWriter({
  writable: new FileHandleWritable(await open(path, "w")),
  chunkSize: 4 << 20,
  compressChunk: (data) => ({ compression: "zstd", compressedData: new Uint8Array(zstd.compress(data, 1)) }),
});
await writer.start({ profile: "ros2", library: "peer" });

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
const image = `std_msgs/Header header
uint32 height
uint32 width
string encoding
uint8 is_bigendian
uint32 step
uint8[] data${header}`;
const array = `std_msgs/Header header
uint32 rows
uint32 columns
float64 pitch_m
string unit
string frame_axes
float32[] value${header}`;
const compressed = `std_msgs/Header header
string format
uint8[] data${header}`;

async function addTopic(topic, name, definition) {
  const schemaId = await writer.registerSchema({ name, encoding: "ros2msg", data: new TextEncoder().encode(definition) });
  const channelId = await writer.registerChannel({ schemaId, topic, messageEncoding: "cdr", metadata: new Map() });
  const encoder = new MessageWriter(parse(definition, { ros2: true }));
  return async (sequence, time, message) => {
    const data = encoder.writeMessage(message);
    await writer.addMessage({ channelId, sequence, logTime: time, publishTime: time, data });
  };
}

const head = (time) => ({
  stamp: { sec: Number(time / 1000000000n), nanosec: Number(time % 1000000000n) },
  frame_id: "frames",
});
if (what === "tactile") {
  const addImage = await addTopic("/frames/image", "sensor_msgs/msg/Image", image);
  const addArray = await addTopic("/frames/array", "teleta_msgs/msg/TactileArray", array);
  const frames = Array.from({ length: 256 }, () =>
    Float32Array.from({ length: 84 }, (_, taxel) => Math.round(((taxel % 7) * 0.3 + 0.03 * (Math.random() - 0.5)) * 1000) / 1000),
  );
  for (let i = 0; i < Number(count); ++i) {
    const time = 1790000000000000000n + BigInt(i) * 5000000n;
    const value = frames[i % frames.length];
    const data = new Uint8Array(value.buffer);
    await addImage(i, time, { header: head(time), height: 6, width: 14, encoding: "32FC1", is_bigendian: 0, step: 56, data });
    await addArray(i, time, { header: head(time), rows: 6, columns: 14, pitch_m: 0.0034, unit: "N", frame_axes: "x y z", value });
  }
} else {
  const add = await addTopic("/camera/image/compressed", "sensor_msgs/msg/CompressedImage", compressed);
  const [width, height] = [1640, 1232];
  const noise = randomBytes(1 << 22);
  for (let i = 0; i < Number(count); ++i) {
    const time = 1790000000000000000n + BigInt(i) * 25000000n;
    const rows = Buffer.alloc((width + 1) * height);
    for (let y = 0; y < height; ++y)
      for (let x = 0; x < width; ++x)
        rows[y * (width + 1) + 1 + x] = ((x + i) % 40 < 12 && y % 40 < 12 ? 180 : 40) + (noise[(y * width + x + i * 977) % noise.length] & 1);
    // What a PNG without compression has inside; its head is a few bytes.
    await add(i, time, { header: head(time), format: "png", data: new Uint8Array(deflateSync(rows, { level: 0 })) });
  }
}
await writer.end();
