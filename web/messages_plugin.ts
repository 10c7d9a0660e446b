// SPDX-License-Identifier: BSD-3-Clause
import { fileURLToPath } from "node:url";
import type { Plugin } from "vite";
import { IDL_FOLDER } from "./generate/idl.mjs";
import { writeMessages } from "./generate/messages.mjs";

/** Makes src/feed/messages.ts of the IDL before anything imports it, and again whenever the IDL changes. */
export const messages = (): Plugin => ({
  name: "galilean-messages",
  configResolved: writeMessages,
  configureServer({ watcher }) {
    watcher.add(fileURLToPath(IDL_FOLDER));
    watcher.on("change", (path) => path.endsWith(".idl") && writeMessages());
  },
});
