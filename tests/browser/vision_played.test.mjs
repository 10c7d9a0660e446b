// SPDX-License-Identifier: BSD-3-Clause
// What the robots of a played team see.
import { test } from "node:test";
import { eventually } from "../tools/patience.mjs";
import { playedTab } from "./tab.mjs";

const tab = playedTab({ ahead: 60 });
const { at, until } = tab;

test("pictures come with what was found in them, each supercomponent with its own", async () => {
  for (const kind of ["camera", "superred", "supergreen", "superblue"])
    await until((id) => Number(document.querySelector(`[data-testid=${id}]`)?.dataset.shown) > 1, `picture-${kind}`);
  await until(() => document.querySelectorAll("[data-testid=picture-camera] rect").length > 0);
  await until(() => /^\d+ Hz · [\d.]+ (ms|s|min|h) old$/.test(document.querySelector("[data-testid=picture-camera] [data-testid=rate]")?.textContent));
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
  const isCamera = (topic) => topic.includes("/camera/");
  await eventually(async () => !(await tab.api("/watched")).topics.some(isCamera));
});

test("many robots' cameras stand side by side, and only those in sight are read", async () => {
  await tab.page.keyboard.press("6");
  await at("vision-every").click();
  await until(() => document.querySelectorAll("[data-testid^=picture-camera-]").length === 3);
  await until(() => document.querySelector("[data-testid=picture-camera-ganymede]")?.dataset.shown > 0);
});

tab.testComplaints();
