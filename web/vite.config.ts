import { svelte } from "@sveltejs/vite-plugin-svelte";
import { defineConfig } from "vite";

const monitor = process.env.GALILEAN_URL ?? "http://127.0.0.1:8080";

export default defineConfig({
  plugins: [svelte()],
  build: { target: "es2022" },
  server: {
    proxy: {
      "/api": { target: monitor, changeOrigin: true },
      "/ws": { target: monitor, ws: true, changeOrigin: true },
    },
  },
});
