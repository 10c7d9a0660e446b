// SPDX-License-Identifier: BSD-3-Clause
// What the whole of a recording has exercised, on the state machine, wherever the recording stands.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { startFixture, Tab } from "./tab.mjs";

const tab = new Tab();
const { at } = tab;
const open = (name) => tab.page.goto(new URL(`/?recording=${name}&at=1`, tab.fixture.url).href);

before(async () => {
  tab.fixture = await startFixture({});
  await tab.open(new URL("/?recording=office.mcap&at=1", tab.fixture.url).href, { viewport: { width: 1920, height: 1080 } });
});
after(async () => {
  await tab.close();
  await tab.fixture?.stop();
});

/** What the monitor counted, and how the page says it. */
async function counted() {
  const { programs: [{ states, conditions }] } = await (await fetch(new URL("/api/recordings/office.mcap/coverage", tab.fixture.url))).json();
  const taken = new Map();
  for (const each of conditions) taken.set(`${each.from} → ${each.to}`, (taken.get(`${each.from} → ${each.to}`) ?? 0) + each.taken);
  const happened = [...taken.values()].filter((times) => times > 0).length;
  const visited = states.filter((state) => state.visited).length;
  return {
    sentence: new RegExp(`^${visited} of ${states.length} states, ${happened} of ${taken.size} transitions have happened in the whole of this recording, whichever robot ran this program\\.$`),
    never: taken.size - happened,
    firedFrom: (state) => conditions.filter(({ from }) => from === state).map((each) => (each.taken > 0 ? `fired ${each.taken}×` : "never fired")),
  };
}

test("it is that of the whole recording, which has hardly begun to play", async () => {
  const { sentence, never, firedFrom } = await counted();
  await at("state-start").waitFor();
  await at("machine-coverage").click();
  await tab.untilText("coverage-sentence", sentence);
  assert.ok(never > 0);
  assert.equal(await tab.page.locator("[data-testid=machine] [data-arrow][data-count='0']").count(), never);
  await at("state-move_to_trash").focus();
  await tab.page.keyboard.press("Enter");
  assert.deepEqual(await at("machine-detail").locator("[data-fired]").allInnerTexts(), firedFrom("move_to_trash"));
});

test("it stays as it is where the recording is at its end", async () => {
  await at("playback-slider").focus();
  await tab.page.keyboard.press("End");
  await tab.untilIs("playback", "data-status", "ended");
  await tab.untilText("coverage-sentence", (await counted()).sentence);
});

test("of a damaged recording it says what is lost", async () => {
  await open("cut.mcap");
  await at("machine-coverage").click();
  await tab.untilText("coverage-sentence", /It may be more: what was recorded from 12:00:20 to 12:00:22 is lost\.$/);
});

tab.testComplaints();
