// SPDX-License-Identifier: BSD-3-Clause
// A viewer that may only watch sees so before it presses anything, and is told where to get the right.
import assert from "node:assert/strict";
import { test } from "node:test";
import { playedTab } from "./tab.mjs";

const tab = playedTab({ watching: true });
const { at, row } = tab;

test("what steers looks as if it may not be used, and says where to get the right", async () => {
  await tab.untilIs("stop-all", "aria-disabled", "true");
  for (const button of [at("stop-all"), row("io").getByRole("button", { name: /^(Hold|Start)$/ })]) {
    assert.equal(await button.getAttribute("aria-disabled"), "true");
    assert.match(await button.getAttribute("title"), /^You may watch only\. Open the operator's link .* operator\.token/);
  }
  await at("stop-all").click({ force: true });
  await at("trouble").filter({ hasText: "You may watch only." }).waitFor();
});

test("break points are looked at, and neither set nor stepped through", async () => {
  await at("state-grab_trash").click();
  await at("break-choice").getByRole("button").first().waitFor();
  for (const button of await at("break-choice").getByRole("button").all()) assert.equal(await button.getAttribute("aria-disabled"), "true");
  await at("trouble").getByRole("button", { name: "Dismiss" }).click();
  for (const key of ["n", "b"]) {
    await tab.page.keyboard.press(key);
    await at("trouble").filter({ hasText: "You may watch only." }).waitFor();
    await at("trouble").getByRole("button", { name: "Dismiss" }).click();
  }
  await at("machine-breaks").click();
  await at("break-list").getByText("You may watch only.").waitFor();
  const { robots } = await tab.api("/api/status");
  assert.deepEqual(robots.filter(({ held }) => held), []);
  assert.equal(await at("state-grab_trash").getAttribute("data-break"), null);
});

test("what is only looked at may be used", async () => {
  assert.equal(await at("edit-button").getAttribute("aria-disabled"), null);
  assert.equal(await at("check-button").getAttribute("aria-disabled"), null);
});

tab.testComplaints();
