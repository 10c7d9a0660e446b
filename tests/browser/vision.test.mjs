// SPDX-License-Identifier: BSD-3-Clause
// What the robots of a live team see, and trying other thresholds on it.
import assert from "node:assert/strict";
import { test } from "node:test";
import { liveTab, ROBOTS } from "./tab.mjs";

const tab = liveTab();
const { api, at, row, until } = tab;

test("camera and supercomponents of the chosen robot are shown", async () => {
  for (const picture of ["camera", "superred", "supergreen", "superblue"])
    await until((id) => Number(document.querySelector(`[data-testid=${id}]`)?.dataset.shown) > 0, `picture-${picture}`);
});

test("what was found stands over the camera, with horizon and ranges, rate and age", async () => {
  const camera = at("picture-camera");
  await until(() => document.querySelector("[data-testid=picture-camera] rect") !== null);
  await camera.getByTestId("range-scale").locator("text").first().waitFor();
  const words = await camera.getByTestId("range-scale").locator("text").allTextContents();
  assert.deepEqual(words, ["horizon", "2 m", "1 m", "0.5 m"]);
  await until(() => /^\d+ Hz · [\d.]+ (ms|s|min|h) old$/.test(document.querySelector("[data-testid=picture-camera] [data-testid=rate]")?.textContent));
  await until(() => {
    const { latencyMs } = document.querySelector("[data-testid=picture-camera]").dataset;
    return latencyMs > 0 && latencyMs < 2000;
  });
  await at("vision-scale").click();
  await camera.getByTestId("range-scale").waitFor({ state: "detached" });
  await at("vision-scale").click();
});

test("the robots' cameras are shown side by side", async () => {
  await at("vision-every").click();
  for (const robot of ROBOTS) await until((id) => Number(document.querySelector(`[data-testid=${id}]`)?.dataset.shown) > 0, `picture-camera-${robot}`);
  await at("picture-camera-callisto").click();
  await until(() => document.querySelector("[data-testid=team-row-callisto] [aria-pressed=true]") !== null);
  await at("vision-every").click();
});

test("a threshold that was tuned on a live picture goes to the robot as a program", async () => {
  await row("io").getByRole("button").first().click();
  const [running, others] = [await row("io").getAttribute("data-hash"), await row("callisto").getAttribute("data-hash")];
  await at("tune-button").click();
  const slider = at("tune-threshold");
  await slider.fill("255");
  await until(() => document.querySelector("[data-testid=vision-tuning] canvas")?.width === 352);
  await at("tune-write").click();
  await at("push-confirm").click();
  const hash = await tab.untilGiven((before) => {
    const now = document.querySelector("[data-testid=team-row-io]")?.dataset.hash;
    return now !== before && now;
  }, running);
  assert.equal(await row("callisto").getAttribute("data-hash"), others);
  const pushed = await api(`/api/pushed/${hash}`);
  assert.match(pushed.files.map(({ text }) => text).join(""), /threshold: 255/);
  await at("tune-button").click();
});

tab.testComplaints();
