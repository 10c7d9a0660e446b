// SPDX-License-Identifier: BSD-3-Clause
// A recording in the page, as the fixture plays one: 40 s of three robots, of which callisto falls silent at 8 s.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { loadAxe, violations } from "./axe.mjs";
import { PATIENCE_MS, startFixture, Tab } from "./tab.mjs";

const START_MS = Date.UTC(2024, 10, 28, 12);
const NO_STOP = /This is a recording: a recording cannot be stopped/;
const SMALL_PHONE = { width: 375, height: 667 };
const tab = new Tab();
const { at, row, until, untilGiven } = tab;

before(async () => {
  tab.fixture = await startFixture({ simulated: true });
  await tab.open(new URL("/?recording=office.mcap&at=20", tab.fixture.url).href, { timezoneId: "UTC" });
});
after(async () => {
  await tab.close();
  await tab.fixture?.stop();
});

/** Of one moment: where it is, whether it plays, and what the header says. In seconds from the start. */
const shown = () => tab.page.evaluate(() => {
  const { dataset } = document.querySelector("[data-testid=playback]");
  return { ...dataset, header: document.querySelector("header").innerText, address: location.search };
});
/** Waits until what is shown is of an instant from `least_s` to `most_s`, and asked for no other. */
const untilAt = (least_s, most_s = least_s) =>
  until(([start_ms, least, most]) => {
    const wanted_s = Number(document.querySelector("[data-testid=playback]")?.dataset.positionS);
    const shown_s = (Number(document.querySelector("[data-testid=replay]")?.dataset.atMs) - start_ms) / 1000;
    return [wanted_s, shown_s].every((each_s) => each_s >= least - 0.001 && each_s <= most + 0.001);
  }, [START_MS, least_s, most_s]);
const untilStands = () => tab.untilIs("playback", "data-status", "paused");
/** Stands still there. */
async function standAt(to_s) {
  const { plays } = await shown();
  if (plays === "true") await at("playback-play").click();
  await untilStands();
  await at("playback-slider").focus();
  await tab.page.keyboard.press("Home");
  for (let s = 10; s <= to_s; s += 10) await tab.page.keyboard.press("PageUp");
  for (let s = 0; s < to_s % 10; s += 1) await tab.page.keyboard.press("ArrowRight");
  await untilAt(to_s);
}

test("the header says that it is a replay, of which file and of which instant, and nothing of the present", async () => {
  await tab.untilText("replay", /REPLAY\s+office\.mcap\s+2024-11-28 12:00:\d\d/);
  await untilAt(20, 40);
  const { header, durationS } = await shown();
  assert.doesNotMatch(header, /live/i);
  assert.equal(durationS, "40");
  assert.equal(await at("connection").count(), 0);
});

test("the team is shown as it was recorded, and ages go by the recording's time", async () => {
  await at("map-robot-io").waitFor();
  await until(() => document.querySelector("[data-testid=machine] [data-current=true]"));
  await until(() => document.querySelector("[data-testid=variables] [data-variable=shaft]"));
  await standAt(20);
  const { silent, words } = await untilGiven(() => {
    const element = document.querySelector("[data-testid=team-row-callisto]");
    return element?.dataset.silent === "true" && { silent: element.dataset.silent, words: element.innerText };
  });
  assert.equal(silent, "true");
  assert.match(words, /silent\s+1[23](\.\d)? s/);
  assert.equal(await at("team-row-io").getAttribute("data-silent"), "false");
  assert.doesNotMatch(await tab.page.locator("body").innerText(), /this page is|Back to live/);
});

test("what is newer than the instant is forgotten, and what stood then is told anew", async () => {
  await standAt(5);
  await tab.untilRow("callisto", "data-silent", "false");
  const newest_s = await untilGiven((start_ms) => {
    const all = [...document.querySelectorAll("[data-testid=why] [data-stamp-s]")].map(({ dataset }) => Number(dataset.stampS) - start_ms / 1000);
    return all.length > 0 && { most: Math.max(...all) };
  }, START_MS);
  assert.ok(newest_s.most <= 5.2, JSON.stringify(newest_s));
  assert.equal(await at("alarms").locator("[data-alarm=silent]").count(), 0);
});

test("it plays and stands still, and steps by a tenth of a second, by keys", async () => {
  await standAt(5);
  await tab.page.evaluate(() => document.activeElement.blur());
  await tab.page.keyboard.press(".");
  await untilAt(5.1);
  await tab.page.keyboard.press(",");
  await untilAt(5);
  await tab.page.keyboard.press("ArrowRight");
  await untilAt(6);
  await tab.page.keyboard.press(" ");
  await untilAt(6.5, 20);
  await tab.page.keyboard.press(" ");
  await untilStands();
});

test("it goes as fast as it is told", async () => {
  await standAt(0);
  await at("playback-speed").selectOption("100");
  await at("playback-play").click();
  await tab.untilIs("playback", "data-status", "ended");
  await untilAt(40);
  await at("playback-speed").selectOption("1");
  // From the end it begins anew.
  await at("playback-play").click();
  await untilAt(0, 20);
  await standAt(0);
});

test("the bar is a slider that says where it is, and goes where it is clicked and dragged to", async () => {
  const slider = at("playback-slider");
  assert.deepEqual(await slider.evaluate((each) => [each.role ?? each.getAttribute("role"), each.ariaValueMin, each.ariaValueMax, each.ariaValueNow]), ["slider", "0", "40", "0"]);
  const { x, y, width, height } = await slider.boundingBox();
  await tab.page.mouse.click(x + width / 2, y + height / 2);
  await untilAt(19, 21);
  await tab.page.mouse.down();
  for (const share of [0.4, 0.6, 0.75]) await tab.page.mouse.move(x + width * share, y + height / 2);
  await tab.page.mouse.up();
  await untilAt(29, 31);
  assert.match(await slider.getAttribute("aria-valuetext"), /^(29|30|31) s of 40 s, 12:00:(29|30|31)$/);
  await slider.focus();
  await tab.page.keyboard.press("End");
  await untilAt(40);
  await tab.page.keyboard.press("PageDown");
  await untilAt(30);
  await tab.page.keyboard.press("Home");
  await untilAt(0);
});

test("the address has the recording and the instant, and opens the same again", async () => {
  await standAt(12);
  await until(() => /^\?recording=office\.mcap&at=12(&|$)/.test(location.search));
  await tab.page.reload();
  await untilAt(12, 20);
  await standAt(12);
});

test("nothing can be ordered, by button or by key, and each says why", async () => {
  await tab.untilIs("stop-all", "aria-disabled", "true");
  for (const button of [at("stop-all"), row("io").getByRole("button", { name: /^(Hold|Start|Resume)/ }).first(), at("push-button")]) {
    assert.equal(await button.getAttribute("aria-disabled"), "true");
    assert.match(await button.getAttribute("title"), NO_STOP);
  }
  await at("stop-all").click({ force: true });
  await at("trouble").filter({ hasText: NO_STOP }).waitFor();
  await at("trouble").getByRole("button", { name: "Dismiss" }).click();
  await tab.page.evaluate(() => document.activeElement.blur());
  for (const key of ["Control+.", "h", "n", "N", "r", "p", "b"]) {
    await tab.page.keyboard.press(key);
    await at("trouble").filter({ hasText: NO_STOP }).waitFor();
    await at("trouble").getByRole("button", { name: "Dismiss" }).click();
  }
  const { robots } = await tab.api("/api/status");
  assert.deepEqual(robots.filter(({ held }) => held), []);
});

test("gains are not moved, and the sentence stands there", async () => {
  await tab.page.getByTestId("title-gains").click();
  await at("gains").getByText("This is a recording").waitFor();
  assert.ok(await at("gains").locator("input[type=range]").first().isDisabled());
  await tab.page.getByTestId("title-program").click();
});

test("the list has every recording, and leads back to the live team", async () => {
  await tab.page.keyboard.press("L");
  await at("recordings").waitFor();
  assert.match(await at("recording-office.mcap").innerText(), /office\.mcap\s+shown now\s+2024-11-28 12:00:00 · 40 s · io, ganymede, callisto · 12 MB ·\s+whole/);
  assert.match(await at("recording-cut.mcap").innerText(), /cut$/);
  assert.match(await at("recording-broken.mcap").innerText(), /It does not begin as an MCAP file does/);
  assert.equal(await at("recording-broken.mcap").getByRole("link").count(), 0);
  await at("to-live").click();
  await tab.untilText("connection", /^live$/);
  assert.equal(await tab.page.evaluate(() => location.search), "");
  assert.equal(await at("replay").count(), 0);
});

test("the browser's own way back leads to the recording again, at its instant", async () => {
  await tab.page.goBack();
  await tab.untilText("replay", /REPLAY/);
  await untilAt(12, 30);
  await tab.page.goForward();
  await tab.untilText("connection", /^live$/);
});

test("a damaged recording is shown, and what is lost is told", async () => {
  await at("recordings-button").click();
  await at("recording-cut.mcap").getByRole("link").click();
  await tab.untilText("replay", /cut\.mcap/);
  await at("trouble").filter({ hasText: "cut.mcap is damaged: nothing is left of 12:00:20 to 12:00:22." }).waitFor();
});

/** As a hand that drops a file from the desk does. */
const drop = (name, bytes) => tab.page.evaluate(([file, content]) => {
  const dataTransfer = new DataTransfer();
  dataTransfer.items.add(new File([new Uint8Array(content)], file));
  for (const type of ["dragover", "drop"]) document.body.dispatchEvent(new DragEvent(type, { bubbles: true, cancelable: true, dataTransfer }));
}, [name, bytes]);
const MAGIC = [0x89, 0x4d, 0x43, 0x41, 0x50, 0x30, 0x0d, 0x0a];

test("a file that is dropped and is no recording is refused, with what to do", async () => {
  for (const [name, bytes, words] of [["notes.txt", [1], "drop a recording such as run.mcap"], ["office.mcap", MAGIC, "rename the file"], ["run.mcap", [1, 2, 3], "drop one that 'galilean record' made"]]) {
    await drop(name, bytes);
    await at("recordings-failure").filter({ hasText: words }).waitFor();
  }
});

test("a recording that is dropped goes to the monitor, and is shown then", async () => {
  await drop("my run.mcap", [...MAGIC, ...Array(2000).fill(0)]);
  await at("upload-progress").waitFor();
  await tab.untilText("replay", /my run\.mcap/);
  await untilAt(0, 40);
});

test("a recording that is not there is told of, with what to do, and asked for no more", async () => {
  await tab.page.goto(new URL("/?recording=gone.mcap", tab.fixture.url).href);
  await at("trouble").filter({ hasText: "There is no recording gone.mcap at this monitor: choose another one" }).waitFor();
});

test("on a small phone the bar and the list have room, and nothing is cut", async () => {
  const page = await tab.browser.newPage({ viewport: SMALL_PHONE, timezoneId: "UTC" });
  page.setDefaultTimeout(PATIENCE_MS);
  await page.goto(new URL("/?recording=office.mcap&at=20", tab.fixture.url).href);
  await page.getByTestId("playback-slider").waitFor();
  await page.getByTestId("replay").getByText("2024-11-28").waitFor();
  const wide = () => page.evaluate(() => [...document.querySelectorAll("header, [data-testid=replay], [data-testid=playback] *, [data-testid=recordings] *")]
    .filter((each) => each.checkVisibility() && !each.matches(".unseen") && each.getBoundingClientRect().right > innerWidth + 1).map((each) => each.outerHTML.slice(0, 100)));
  assert.deepEqual(await wide(), []);
  await page.getByTestId("more").click();
  await page.getByTestId("recordings-button").click();
  await page.getByTestId("recording-office.mcap").waitFor();
  assert.deepEqual(await wide(), []);
  await page.close();
});

for (const colorScheme of ["light", "dark"]) {
  test(`axe finds nothing to complain of, ${colorScheme}`, async () => {
    const page = await tab.browser.newPage({ viewport: { width: 1366, height: 768 }, colorScheme });
    page.setDefaultTimeout(PATIENCE_MS);
    await page.goto(new URL("/?recording=office.mcap&at=20", tab.fixture.url).href);
    await page.getByTestId("map-robot-io").waitFor();
    await page.getByTestId("playback-slider").waitFor();
    await loadAxe(page);
    assert.deepEqual(await violations(page), []);
    await page.keyboard.press("L");
    await page.getByTestId("recording-office.mcap").waitFor();
    assert.deepEqual(await violations(page), [], "recordings");
    await page.close();
  });
}

test("where there is no recording, the list says how one gets there", async () => {
  const fixture = await startFixture({ unrecorded: true });
  const page = await tab.browser.newPage();
  await page.goto(fixture.url);
  await page.getByTestId("recordings-button").click();
  await page.getByTestId("recordings-empty").getByText("galilean record --out /var/lib/galilean/recordings/run.mcap").waitFor();
  await page.close();
  await fixture.stop();
});

test("the browser has nothing to complain of but what was refused", () => {
  assert.deepEqual(tab.complaints.filter((words) => !/status of 4\d\d|404|gone\.mcap/.test(words)), []);
});
