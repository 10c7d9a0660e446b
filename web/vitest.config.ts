// SPDX-License-Identifier: BSD-3-Clause
import { svelte } from "@sveltejs/vite-plugin-svelte";
import { defineConfig } from "vitest/config";
import { grammars } from "./grammar_plugin";
import { messages } from "./messages_plugin";

export default defineConfig({
  plugins: [svelte(), grammars(), messages()],
  // What has Svelte's state in it is tested as a browser runs it.
  resolve: { conditions: ["browser"] },
  // By number: where /etc/hosts is missing nobody knows localhost.
  server: { host: "127.0.0.1" },
  test: {
    include: ["tests/**/*.test.ts"],
    environment: "node",
    setupFiles: ["tests/setup.ts"],
    testTransformMode: { web: ["**/*.svelte.test.ts"] },
    testTimeout: 30_000,
  },
});
