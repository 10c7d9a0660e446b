// SPDX-License-Identifier: BSD-3-Clause
// What the robots of a played team see.
import assert from "node:assert/strict";
import { test } from "node:test";
import { playedTab } from "./tab.mjs";

const tab = playedTab({ ahead: 60 });
const { at, until } = tab;

test("pictures come with what was found in them, each supercomponent with its own", async () => {
  for (const kind of ["camera", "superred", "supergreen", "superblue"])
    await until((id) => Number(document.querySelector(`[data-testid=${id}]`)?.dataset.shown) > 1, `picture-${kind}`);
  await until(() => document.querySelectorAll("[data-testid=picture-camera] rect").length > 0);
  assert.match(await at("picture-camera").getByTestId("rate").textContent(), /^\d+ Hz · [\d.]+ (ms|s|min|h) old$/);
});

test("another picture is made the large one", async () => {
  await at("picture-superred").click();
  await until(() => {
    const width = (kind) => document.querySelector(`[data-testid=picture-${kind}]`).clientWidth;
    return width("superred") > 2 * width("camera");
  });
  await at("picture-camera").click();
});

test("a picture is asked for only while it is in sight", async () => {
  await at("title-vision").focus();
  await tab.page.keyboard.press("Delete");
  await until(() => !document.querySelector("[data-testid=vision]"));
  const watched = async () => (await tab.api("/watched")).topics.filter((topic) => topic.includes("/camera/"));
  for (let tries = 0; (await watched()).length > 0; tries += 1) assert.ok(tries < 2000, "the camera is still read");
});

test("many robots' cameras stand side by side, and only those in sight are read", async () => {
  await tab.page.keyboard.press("6");
  await at("vision-every").click();
  await until(() => document.querySelectorAll("[data-testid^=picture-camera-]").length === 3);
  await until(() => document.querySelector("[data-testid=picture-camera-ganymede]").dataset.shown > 0);
});

tab.testComplaints();
