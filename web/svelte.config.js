// SPDX-License-Identifier: BSD-3-Clause
import { vitePreprocess } from "@sveltejs/vite-plugin-svelte";

export default { preprocess: vitePreprocess() };
