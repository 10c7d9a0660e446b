// SPDX-License-Identifier: BSD-3-Clause
// A page that has a twentieth of a processor accuses no robot, says how far it is behind where it is, and shows
// the present within a second of being fed again, where the machine itself is not busy with other things.
import assert from "node:assert/strict";
import { setTimeout as pause } from "node:timers/promises";
import { after, before, test } from "node:test";
import { startFixture, Tab } from "./tab.mjs";

const STARVED_MS = 60_000;
const CAUGHT_UP_MS = 1000;
/** So short a sleep leaves nothing to catch up with: what it costs to be live again is this machine's own. */
const BRIEFLY_STARVED_MS = 5000;

/** Counts, from within the page, every row that is called silent and every alarm, as they are drawn. */
function watchAccusations() {
  window.accusations = [];
  const look = () => {
    for (const row of document.querySelectorAll("[data-silent=true]")) window.accusations.push(`${row.dataset.testid} is silent`);
    if (document.body.textContent.includes("is silent")) window.accusations.push("an alarm");
  };
  new MutationObserver(look).observe(document.body, { subtree: true, childList: true, attributes: true, characterData: true });
}

/** By how much the contest's clock on the page differs from the fixture's. */
async function clockError_s(tab) {
  const [minutes, seconds] = (await tab.at("clock").textContent()).match(/\d+/g).map(Number);
  const { score } = await tab.api("/api/status");
  return Math.abs(minutes * 60 + seconds - score.remaining_s);
}

/** Starves the page for a while. Returns how long it takes to be live again. */
async function starve(tab, for_ms) {
  const cdp = await tab.page.context().newCDPSession(tab.page);
  await cdp.send("Emulation.setCPUThrottlingRate", { rate: 20 });
  await pause(for_ms);
  await cdp.send("Emulation.setCPUThrottlingRate", { rate: 1 });
  const fed_ms = Date.now();
  await tab.until(() => document.querySelector("[data-testid=connection]").textContent.trim() === "live");
  return Date.now() - fed_ms;
}

for (const robots of [3, 30]) {
  const tab = new Tab();
  before(async () => {
    tab.fixture = await startFixture({ robots });
    await tab.open(tab.fixture.url);
    await tab.row("io").waitFor();
  });
  after(async () => {
    await tab.close();
    await tab.fixture?.stop();
  });

  test(`a starved page with ${robots} robots accuses nobody and catches up within a second`, async () => {
    await tab.page.evaluate(watchAccusations);
    const took_ms = await starve(tab, STARVED_MS);
    const error_s = await clockError_s(tab);
    assert.ok(error_s < 2, `the contest's clock is wrong by ${error_s} s`);
    assert.deepEqual(await tab.page.evaluate(() => [...new Set(window.accusations)]), []);
    if (took_ms < CAUGHT_UP_MS) return;
    const least_ms = await starve(tab, BRIEFLY_STARVED_MS);
    assert.ok(took_ms < CAUGHT_UP_MS + 2 * least_ms, `live again after ${took_ms} ms, and after a short sleep in ${least_ms} ms`);
  });
}
