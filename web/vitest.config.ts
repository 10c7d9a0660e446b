import { defineConfig } from "vitest/config";

// By number: where /etc/hosts is missing nobody knows localhost.
export default defineConfig({
  server: { host: "127.0.0.1" },
  test: { include: ["tests/**/*.test.ts"], environment: "node" },
});
