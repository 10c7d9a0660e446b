// SPDX-License-Identifier: BSD-3-Clause
// What is left of recordings that end within a write, are cut, or have a bit changed, at thousands of places:
// `galilean log recover` makes a recording of it that MCAP's own reference reader reads, and less than a second is lost.
import assert from "node:assert/strict";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { createInterface } from "node:readline";
import { spawn } from "node:child_process";
import { test } from "node:test";
import { readIndexed, testTool } from "./tools.mjs";

/** At so many places; the nightly run may ask for more. */
const PLACES = Number(process.env.GALILEAN_BROKEN_RECORDINGS ?? 2000);

for (const [how, what, codes] of [
  ["kill", "the process that writes it ends within a write", [1, 3]],
  ["cut", "it is cut", [1, 3]],
  ["flip", "a bit of it is changed", [0, 3]],
])
  test(`a recording can be recovered wherever ${what}`, async () => {
    const folder = mkdtempSync(path.join(tmpdir(), "galilean-broken-"));
    try {
      const breaker = spawn(testTool("break_recordings"), [how, String(PLACES), folder]);
      let errors = "";
      breaker.stderr.on("data", (data) => (errors = (errors + data).slice(-4000)));
      const closed = new Promise((resolve) => breaker.on("close", resolve));
      let places = 0, recovered = 0;
      for await (const line of createInterface({ input: breaker.stdout })) {
        const { file, code, messages } = JSON.parse(line);
        ++places;
        assert.ok(codes.includes(code), `${file}: recover ends with ${code}`);
        if (code === 1) continue;
        ++recovered;
        assert.equal((await readIndexed(path.join(folder, file))).messages.length, messages, file);
        rmSync(path.join(folder, file));
      }
      assert.equal(await closed, 0, errors);
      assert.ok(places >= PLACES, `${places} places`);
      assert.ok(recovered > places / 2, `${recovered} of ${places} were recovered`);
    } finally {
      rmSync(folder, { recursive: true });
    }
  });
