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

const SENTENCE = /^10 of 10 states, 10 of 15 transitions have happened in the whole of this recording, whichever robot ran this program\.$/;

test("it is that of the whole recording, which has hardly begun to play", async () => {
  await at("state-start").waitFor();
  await at("machine-coverage").click();
  await tab.untilText("coverage-sentence", SENTENCE);
  const never = await tab.page.locator("[data-testid=machine] [data-arrow][data-count='0']").count();
  assert.equal(never, 5);
  await at("state-move_to_trash").focus();
  await tab.page.keyboard.press("Enter");
  assert.deepEqual(await at("machine-detail").locator("[data-fired]").allInnerTexts(), ["never fired", "fired 10×"]);
});

test("it stays as it is where the recording is at its end", async () => {
  await at("playback-slider").focus();
  await tab.page.keyboard.press("End");
  await tab.untilIs("playback", "data-status", "ended");
  await tab.untilText("coverage-sentence", SENTENCE);
});

test("of a damaged recording it says what is lost", async () => {
  await open("cut.mcap");
  await at("machine-coverage").click();
  await tab.untilText("coverage-sentence", /It may be more: what was recorded from 12:00:20 to 12:00:22 is lost\.$/);
});

tab.testComplaints();
