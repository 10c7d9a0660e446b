// SPDX-License-Identifier: BSD-3-Clause
// The compiler drops a space that stands alone between two values within an SVG, so that "io stopped" becomes "iostopped".
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, test } from "vitest";

const SOURCES = new URL("../../src/", import.meta.url).pathname;
const components = readdirSync(SOURCES, { recursive: true, encoding: "utf8" }).filter((path) => path.endsWith(".svelte"));

test("in an SVG's title and text no two values have only a space between them", () => {
  const joined = components.flatMap((path) => {
    const texts = readFileSync(join(SOURCES, path), "utf8").matchAll(/<(title|text|tspan)\b[^<>]*>([^<]*)<\/\1>/g);
    return [...texts].map(([, , text = ""]) => text.replace(/`[^`]*(`[^`]*`[^`]*)*`/g, "")).filter((text) => /\} +\{/.test(text)).map((text) => `${path}: ${text}`);
  });
  expect(components.length).toBeGreaterThan(50);
  expect(joined).toEqual([]);
});
