// SPDX-License-Identifier: GPL-3.0-or-later
// live_latency.mjs PORT TOPICS SECONDS: subscribes to that many topics of a live view and prints how late their messages
// came, from the time that they carry, over these seconds.
import { check, FoxgloveClient, WebSocket } from "./peers.mjs";

const [port, topics, seconds] = process.argv.slice(2).map(Number);
const client = new FoxgloveClient({
  ws: new WebSocket(`ws://127.0.0.1:${port}`, [FoxgloveClient.SUPPORTED_SUBPROTOCOL]),
});
const delays_ms = [];
const names = new Map();
const seen = new Set();

function report() {
  check(delays_ms.length > 0, "a message came");
  delays_ms.sort((a, b) => a - b);
  const at = (share) => delays_ms[Math.min(Math.floor(share * delays_ms.length), delays_ms.length - 1)].toFixed(2);
  console.log(
    `received ${delays_ms.length} messages of ${seen.size} topics: median ${at(0.5)} ms, ` +
      `99 % under ${at(0.99)} ms, latest ${at(1)} ms`,
  );
  process.exit(0);
}

client.on("error", (error) => check(false, error.message ?? String(error)));
client.on("advertise", (channels) => {
  for (const channel of channels) names.set(client.subscribe(channel.id), channel.topic);
  if (names.size < topics) return;
  console.log("subscribed");
  setTimeout(report, 1000 * seconds);
});
client.on("message", ({ subscriptionId, timestamp }) => {
  const now_ms = performance.timeOrigin + performance.now();
  delays_ms.push(now_ms - Number(timestamp / 1000n) / 1000);
  seen.add(names.get(subscriptionId));
});
