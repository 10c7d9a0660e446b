// SPDX-License-Identifier: BSD-3-Clause
import { svelte } from "@sveltejs/vite-plugin-svelte";
import { defineConfig } from "vite";
import { grammars } from "./grammar_plugin";
import { messages } from "./messages_plugin";
import { skeleton } from "./skeleton_plugin";

const monitor = process.env.GALILEAN_URL ?? "http://127.0.0.1:8080";
// The monitor answers no other origin's page.
const own = { target: monitor, changeOrigin: true, headers: { origin: monitor } };

export default defineConfig({
  plugins: [svelte(), grammars(), messages(), skeleton()],
  build: { target: "es2022" },
  server: {
    proxy: {
      "/api": own,
      "/lsp": { ...own, ws: true },
      "/ws": { ...own, ws: true },
      "/replay": { ...own, ws: true },
    },
  },
});
