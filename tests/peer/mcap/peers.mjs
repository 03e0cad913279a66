// SPDX-License-Identifier: GPL-3.0-or-later
// The peers, from the folder TELETA_MCAP_PEERS into which npm has installed them.
import { createRequire } from "node:module";

export const require = createRequire(`${process.env.TELETA_MCAP_PEERS}/package.json`);

export const core = require("@mcap/core");
export const { FileHandleReadable, FileHandleWritable } = require("@mcap/nodejs");
export const { loadDecompressHandlers } = require("@mcap/support");
export const { parse } = require("@foxglove/rosmsg");
export const { MessageReader, MessageWriter } = require("@foxglove/rosmsg2-serialization");
export const { FoxgloveClient } = require("@foxglove/ws-protocol");
export const { WebSocket } = require("ws");

/// Ends the program with an error unless the condition holds.
export function check(condition, text) {
  if (!condition) {
    console.error(`failed: ${text}`);
    process.exit(1);
  }
}
