import { defineConfig } from "vitest/config";
import { grammars } from "./grammar_plugin";

// By number: where /etc/hosts is missing nobody knows localhost.
export default defineConfig({
  plugins: [grammars()],
  server: { host: "127.0.0.1" },
  test: { include: ["tests/**/*.test.ts"], environment: "node", testTimeout: 30_000 },
});
