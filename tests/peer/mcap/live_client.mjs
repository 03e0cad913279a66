// SPDX-License-Identifier: GPL-3.0-or-later
// live_client.mjs PORT N: subscribes to every topic of a live view and prints the first N messages of each as JSON.
import { check, FoxgloveClient, MessageReader, parse, WebSocket } from "./peers.mjs";

const [, , port, wanted] = process.argv;
const client = new FoxgloveClient({
  ws: new WebSocket(`ws://127.0.0.1:${port}`, [FoxgloveClient.SUPPORTED_SUBPROTOCOL]),
});
const received = {};
const readers = new Map();

client.on("error", (error) => check(false, error.message ?? String(error)));
client.on("serverInfo", (info) => (received.server = info.name));
client.on("advertise", (channels) => {
  for (const channel of channels) {
    check(channel.encoding === "cdr" && channel.schemaEncoding === "ros2msg", "a channel has CDR of ros2msg");
    const id = client.subscribe(channel.id);
    readers.set(id, { topic: channel.topic, reader: new MessageReader(parse(channel.schema, { ros2: true })) });
    received[channel.topic] = [];
  }
  if (received["/skin/array"] !== undefined) console.log("subscribed");
});
client.on("message", ({ subscriptionId, data }) => {
  const { topic, reader } = readers.get(subscriptionId);
  if (received[topic].length < Number(wanted)) received[topic].push(reader.readMessage(data));
  const topics = Object.keys(received).filter((name) => name.startsWith("/"));
  if (topics.every((name) => received[name].length >= Number(wanted))) {
    const plain = (key, value) => (ArrayBuffer.isView(value) ? [...value] : value);
    console.log(`received ${JSON.stringify(received, plain)}`);
    process.exit(0);
  }
});
