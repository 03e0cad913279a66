// SPDX-License-Identifier: GPL-3.0-or-later
// A server of the package "ws" that sends what xela_server sends. It prints "ready PORT" and obeys lines:
//   raw N M       messages N to M with hexadecimal data of two sensors, 16 and 24 taxels
//   forces N M    the same with "calibrated" of sensor 1
//   null N        "calibrated" is null
//   other N       sensor 1 has 24 taxels; model N: it is another model with the same number
//   spoilt N M    as forces, but sensor 2 tells NaN as Python writes it
//   timed N M     as forces, but sensor 1 alone has a time, a quarter of a second later each
//   say TEXT      this text; bytes: a binary message of 64 bytes; long: a text of 2 MB
//   close CODE    of the connection; clients: "clients N", and how often they pinged
import { createRequire } from "node:module";
import { createInterface } from "node:readline";

const require = createRequire(`${process.env.TELETA_MCAP_PEERS}/package.json`);
const { WebSocketServer } = require("ws");

const server = new WebSocketServer({ host: "127.0.0.1", port: 0 });
let clients = 0;
server.on("connection", (socket) => {
  clients += 1;
  socket.send(JSON.stringify({ message: "Welcome" }));
});
server.on("listening", () => console.log(`ready ${server.address().port}`));

const send = (what) => server.clients.forEach((socket) => socket.send(what));
const hex = (n, count) =>
  Array.from({ length: count }, (_, i) => ((n * 131 + i) & 0xffff).toString(16).toUpperCase().padStart(4, "0")).join(",");
const forces = (n, count) => Array.from({ length: count }, (_, i) => n / 8 + i / 16);
const message = (n, first) =>
  JSON.stringify({
    message: n,
    time: 1619157045.5 + n / 100,
    sensors: 2,
    1: { sensor: "1", model: "uSPa44", time: 1619157045.5, ...first },
    2: { sensor: 2, taxels: 24, data: hex(n + 1, 72), calibrated: null },
  });

const does = {
  raw: (n, last) => {
    for (let i = n; i <= last; i += 1) send(message(i, { taxels: 16, data: hex(i, 48), calibrated: null }));
  },
  forces: (n, last) => {
    for (let i = n; i <= last; i += 1) send(message(i, { taxels: 16, data: hex(i, 48), calibrated: forces(i, 48) }));
  },
  null: (n) => send(message(n, { taxels: 16, data: hex(n, 48), calibrated: null })),
  other: (n) => send(message(n, { taxels: 24, data: hex(n, 72), calibrated: forces(n, 72) })),
  model: (n) => send(message(n, { taxels: 16, model: "uSPa46", data: hex(n, 48), calibrated: forces(n, 48) })),
  spoilt: (n, last) => {
    for (let i = n; i <= last; i += 1)
      send(
        message(i, { taxels: 16, data: hex(i, 48), calibrated: forces(i, 48) }).replace(
          '"calibrated":null',
          '"calibrated":[NaN,-Infinity,"NaN \\" NaN"]',
        ),
      );
  },
  timed: (n, last) => {
    for (let i = n; i <= last; i += 1) {
      const { time, ...rest } = JSON.parse(
        message(i, { taxels: 16, time: 1619157045.5 + i / 4, data: hex(i, 48), calibrated: forces(i, 48) }),
      );
      send(JSON.stringify(rest));
    }
  },
  bytes: () => send(Buffer.alloc(64, 0x7b)),
  long: () => send("x".repeat(2000000)),
  close: (code) => server.clients.forEach((socket) => socket.close(code, "over")),
  clients: () => console.log(`clients ${clients}`),
};

createInterface({ input: process.stdin }).on("line", (line) => {
  const [word, ...rest] = line.split(" ");
  if (word === "say") send(rest.join(" "));
  else does[word](...rest.map(Number));
  console.log("done");
});
