// SPDX-License-Identifier: GPL-3.0-or-later
// check_export.mjs FILE.mcap CSV_FOLDER: reads an exported file with two readers and compares every value with the CSV
// export of the same recording. Prints what was compared.
import { open, readFile } from "node:fs/promises";
import { existsSync } from "node:fs";
import { inflateSync } from "node:zlib";
import { check, core, FileHandleReadable, loadDecompressHandlers, MessageReader, parse } from "./peers.mjs";

const [, , path, folder] = process.argv;
const decompressHandlers = await loadDecompressHandlers();

// Every CRC, from the first to the last byte.
const stream = new core.McapStreamReader({ validateCrcs: true, decompressHandlers, includeChunks: true });
stream.append(await readFile(path));
let streamed = 0;
for (let record; (record = stream.nextRecord()); ) streamed += record.type === "Message" ? 1 : 0;
check(stream.done(), "the stream reader reaches the end");

const file = await open(path, "r");
const reader = await core.McapIndexedReader.Initialize({ readable: new FileHandleReadable(file), decompressHandlers });
check(reader.header.profile === "ros2", "the profile is ros2");
check(reader.statistics.messageCount === BigInt(streamed), "the statistics count the messages");

let note;
let streamsNote;
for await (const metadata of reader.readMetadata()) {
  if (metadata.name === "teleta") note = metadata.metadata;
  if (metadata.name === "teleta_streams") streamsNote = metadata.metadata;
}
check(note !== undefined && streamsNote !== undefined, "the metadata records are there");
for (const key of ["anchors", "app_version", "scene", "start_utc", "units"])
  check(note.has(key), `the metadata have ${key}`);
const [, second, nanoseconds] = note.get("start_utc").match(/^(.*)\.(\d{9})Z$/);
const start = BigInt(Date.parse(`${second}Z`)) * 1000000n + BigInt(nanoseconds);

let attachments = 0;
for await (const attachment of reader.readAttachments()) {
  ++attachments;
  if (attachment.mediaType === "application/json") JSON.parse(new TextDecoder().decode(attachment.data));
}

const rows = new Map();
async function csv(name) {
  if (!rows.has(name)) {
    const text = await readFile(`${folder}/${name}.csv`, "utf8");
    const [head, ...lines] = text.trimEnd().split("\n");
    rows.set(name, { columns: head.split(","), lines: lines.map((line) => line.split(",")) });
  }
  return rows.get(name);
}

const number = (text) => (text === "NA" || text === "nan" ? NaN : Number(text));
const same = (a, b) => a === b || (Number.isNaN(a) && Number.isNaN(b));

/// The rows of the PNG, by the format's definition; only what needs no filter.
function pixelsOf(png) {
  const view = new DataView(png.buffer, png.byteOffset, png.byteLength);
  check(view.getUint32(0) === 0x89504e47, "a picture is a PNG");
  let at = 8;
  let size;
  const parts = [];
  while (at < png.byteLength) {
    const length = view.getUint32(at);
    const type = String.fromCharCode(...png.subarray(at + 4, at + 8));
    if (type === "IHDR") size = [view.getUint32(at + 8), view.getUint32(at + 12)];
    if (type === "IDAT") parts.push(png.subarray(at + 8, at + 8 + length));
    at += 12 + length;
  }
  check(inflateSync(Buffer.concat(parts)).length === (size[0] + 1) * size[1], "a picture has all of its pixels");
  return size;
}

/// [column, value] pairs for each row of the CSV that a message stands for.
const converters = {
  "sensor_msgs/msg/Image": (m) => {
    check(m.encoding === "32FC1" && m.is_bigendian === 0 && m.step === 4 * m.width, "an image is 32FC1");
    const values = new Float32Array(m.data.slice().buffer);
    check(values.length === m.width * m.height, "an image has all of its values");
    return [[...values].map((value, i) => [`t${i}`, value])];
  },
  "teleta_msgs/msg/TactileArray": (m) => {
    check(m.value.length === m.rows * m.columns && m.pitch_m > 0, "an array has all of its values and a pitch");
    return [[...m.value].map((value, i) => [`t${i}`, value])];
  },
  "teleta_msgs/msg/TactileFeatures": (m) => [
    Object.entries(m)
      .filter(([key]) => key !== "header")
      .map(([key, value]) => [key, key === "contact_type" ? ["none", "point", "edge"][value] : value]),
  ],
  "teleta_msgs/msg/Touch": (m) => [Object.entries(m).filter(([key]) => key !== "header")],
  "teleta_msgs/msg/Contacts": (m, turned) =>
    m.contacts.map((contact) =>
      Object.entries(contact).map(([key, value]) => [key, turned && (key === "y_m" || key === "dy_m") ? -value : value]),
    ),
  "sensor_msgs/msg/JointState": (m, turned, topic) => [
    topic.endsWith("/joint_references")
      ? [...m.position].map((value, i) => [`ref${i + 1}`, value])
      : [
          ...[...m.position].map((value, i) => [`q${i + 1}`, value]),
          ...[...m.effort].map((value, i) => [`tau${i + 1}`, value]),
        ],
  ],
  "sensor_msgs/msg/CompressedImage": (m) => {
    const [width, height] = pixelsOf(m.data);
    return [[["width_px", width], ["height_px", height]]];
  },
  "teleta_msgs/msg/Tactors": (m) => [[...m.intensity].map((value, i) => [`t${i + 1}`, value])],
  "foxglove_msgs/msg/Log": (m) => [[["event", m.name], ["text", m.message]]],
};

const readers = new Map();
const used = new Map();
let values = 0;
let messages = 0;
let last = 0n;
const topics = new Map();
const parsedStreams = [...streamsNote].map(([name, text]) => ({ name, ...JSON.parse(text) }));
for await (const message of reader.readMessages()) {
  const channel = reader.channelsById.get(message.channelId);
  const schema = reader.schemasById.get(channel.schemaId);
  check(channel.messageEncoding === "cdr" && schema.encoding === "ros2msg", "messages are CDR of ros2msg");
  check(channel.metadata.get("offered_qos_profiles") === "", "a channel offers no QoS");
  check(message.logTime === message.publishTime, "both times are the same");
  check(message.logTime >= last, "times never go back");
  last = message.logTime;
  if (!readers.has(schema.id)) {
    const definition = parse(new TextDecoder().decode(schema.data), { ros2: true });
    readers.set(schema.id, new MessageReader(definition));
  }
  const decoded = readers.get(schema.id).readMessage(message.data);
  const stamp = decoded.header?.stamp ?? decoded.timestamp;
  check(BigInt(stamp.sec) * 1000000000n + BigInt(stamp.nanosec ?? stamp.nsec) === message.logTime, "the stamp is the time");
  ++messages;
  topics.set(channel.topic, (topics.get(channel.topic) ?? 0) + 1);
  if (schema.name === "geometry_msgs/msg/WrenchStamped") {
    check(decoded.wrench.force.z <= 0, "an array is pressed");
    continue;
  }
  const stream =
    schema.name === "foxglove_msgs/msg/Log"
      ? { name: "events" }
      : parsedStreams.find(({ topic }) => channel.topic.startsWith(`/${topic}/`));
  check(stream !== undefined && existsSync(`${folder}/${stream.name}.csv`), `${channel.topic} is a stream`);
  const table = await csv(stream.name);
  for (const row of converters[schema.name](decoded, stream.turns_y, channel.topic)) {
    const at = used.get(channel.topic) ?? 0;
    used.set(channel.topic, at + 1);
    const expected = table.lines[at];
    check(same(Number(message.logTime - start) / 1e9, number(expected[0])), `${channel.topic}: time of row ${at}`);
    for (const [column, value] of row) {
      const text = expected[table.columns.indexOf(column)];
      check(text !== undefined, `${channel.topic}: there is a column ${column}`);
      const isEqual =
        typeof value === "string"
          ? value === text
          : schema.name.endsWith("Image") || schema.name.endsWith("TactileArray") || schema.name.endsWith("Tactors")
            ? same(value, Math.fround(number(text)))
            : same(value, number(text));
      check(isEqual, `${channel.topic}: row ${at}, ${column} is ${value}, not ${text}`);
      ++values;
    }
  }
}
check(messages === streamed, "both readers find the same messages");
for (const [topic, count] of used) {
  const name = topic === "/events" ? "events" : parsedStreams.find((each) => topic.startsWith(`/${each.topic}/`)).name;
  check(count === rows.get(name).lines.length, `${topic}: all ${rows.get(name).lines.length} rows, not ${count}`);
}
await file.close();
console.log(JSON.stringify({ messages, values, attachments, topics: Object.fromEntries(topics) }));
