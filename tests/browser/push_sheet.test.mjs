// SPDX-License-Identifier: BSD-3-Clause
// A push on a laptop of 1366 x 768: the question, the ways and the answers are in sight without scrolling.
import assert from "node:assert/strict";
import { test } from "node:test";
import { LAPTOP, playedTab } from "./tab.mjs";

const tab = playedTab({ ahead: 60 });
const { at } = tab;

/** Whether all of an element is in the window and nothing lies over its middle. */
const isInSight = (locator) => locator.evaluate((element, { width, height }) => {
  const box = element.getBoundingClientRect();
  const top = document.elementFromPoint(box.x + box.width / 2, box.y + box.height / 2);
  const isInside = box.x >= 0 && box.y >= 0 && box.right <= width && box.bottom <= height;
  return isInside && (element.contains(top) || top.contains(element));
}, LAPTOP);

test("what the program does otherwise, the targets, the ways and the click are in sight", async () => {
  await at("program-select").selectOption("sit_and_spin.bhdl");
  await at("push-button").click();
  const parts = ["program-changes", "push-try", "push-canary", "push-confirm"];
  for (const part of parts) await at(part).waitFor();
  for (const part of parts) assert.ok(await isInSight(at(part)), `${part} is hidden`);
  assert.match(await at("push-sheet").innerText(), /sit_and_spin\.bhdl \w+ to the team \(3 robots\)/);
});

test("the differences follow what the robots run, while the question stands", async () => {
  const named = () => at("program-changes").innerText();
  const before = await named();
  await tab.page.evaluate(async () => {
    const { files } = await (await fetch("/api/programs/office_cleanup.bhdl")).json();
    const theirs = [{ path: "theirs.bhdl", text: `${files[0].text}; from another page\n` }];
    await fetch("/api/push", { method: "POST", body: JSON.stringify({ files: theirs }) });
  });
  await tab.page.waitForFunction((text) => {
    const now = document.querySelector("[data-testid=program-changes]")?.innerText ?? "";
    return now !== text && now.includes("theirs.bhdl");
  }, before);
});

test("Escape closes the sheet and pushes nothing", async () => {
  const posted = [];
  const note = (request) => request.method() === "POST" && posted.push(request.url());
  tab.page.on("request", note);
  await tab.page.keyboard.press("Escape");
  await at("push-sheet").waitFor({ state: "detached" });
  tab.page.off("request", note);
  assert.deepEqual(posted.filter((url) => new URL(url).pathname.startsWith("/api/push")), []);
});

test("each robot's answer is in sight, until somebody closes the sheet", async () => {
  await at("push-button").click();
  await at("push-confirm").click();
  const robots = ["io", "ganymede", "callisto"];
  for (const robot of robots) await tab.untilReply(robot, ["running", "confirmed"]);
  for (const robot of robots) assert.ok(await isInSight(at(`reply-${robot}`)), `${robot}'s answer is hidden`);
  await tab.page.keyboard.press("Escape");
  await at("push-sheet").waitFor({ state: "detached" });
  await at("reply-io").waitFor();
});

tab.testComplaints();
