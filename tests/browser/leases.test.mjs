// SPDX-License-Identifier: BSD-3-Clause
// Two operators in two tabs, and one hand on the wheel: who steers first, who asks, who gives, who takes over.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { liveTab, Tab } from "./tab.mjs";

const ada = liveTab();
const ben = new Tab();
before(() => ben.open(process.env.GALILEAN_URL));
after(() => ben.close());

/** Types the tab's name where its keys are explained. */
async function named(tab, name) {
  await tab.page.keyboard.press("?");
  await tab.at("operator-name").fill(name);
  await tab.at("operator-name").press("Tab");
  await tab.page.keyboard.press("Escape");
  await tab.at("help").waitFor({ state: "detached" });
}

test("a robot that nobody holds goes to the first who steers it, without a question", async () => {
  await named(ada, "Ada");
  await named(ben, "Ben");
  await ada.row("io").getByRole("button").first().click();
  await ben.row("io").getByRole("button").first().click();
  await ada.row("io").getByRole("button", { name: "Hold", exact: true }).click();
  await ada.row("io").getByRole("button", { name: "Resume", exact: true }).click();
  await ben.untilIs("lease-io", "data-holder", "Ada");
  assert.equal(await ada.at("lease-io").count(), 0, "one operator alone sees nothing of it");
});

test("another one sees before he presses anything that he may not, and still stops it", async () => {
  await ben.row("io").getByRole("button", { name: "Hold", exact: true }).click();
  await ada.untilRow("io", "data-held", "true");
  const resume = ben.row("io").getByRole("button", { name: "Resume", exact: true });
  await resume.waitFor();
  assert.equal(await resume.getAttribute("aria-disabled"), "true");
  assert.match(await resume.getAttribute("title"), /^Ada holds io\. Ask for it/);
  await ada.row("io").getByRole("button", { name: "Resume", exact: true }).click();
  await ada.untilRow("io", "data-held", "false");
});

test("he may set a break point, and no lock, at which it would drive on", async () => {
  const state = ben.at("machine").locator("[data-state]").first();
  await state.click();
  const choice = (name) => ben.at("break-choice").getByRole("button", { name, exact: true });
  await choice("Lock").waitFor();
  assert.equal(await choice("Stop").getAttribute("aria-disabled"), "false");
  assert.equal(await choice("Lock").getAttribute("aria-disabled"), "true");
  assert.match(await choice("Lock").getAttribute("title"), /^Ada holds io\. Ask for it/);
  await state.click();
});

test("he asks, and is refused", async () => {
  await ben.at("lease-ask-io").click();
  await ada.untilText("lease-asked-io", /Ben asks for io/);
  await ada.at("lease-refuse-io").click();
  await ben.at("trouble").filter({ hasText: "You do not get io: Ada holds it." }).waitFor();
});

test("he asks again, and is given it", async () => {
  await ben.at("lease-ask-io").click();
  await ada.at("lease-give-io").click();
  await ada.untilIs("lease-io", "data-holder", "Ben");
  assert.equal(await ada.at("trouble").count(), 0, "who gives it is not told that it is gone");
});

test("she takes it over at once with a reason, which he sees", async () => {
  await ada.at("lease-over-io").click();
  assert.ok(await ada.at("lease-take-io").isDisabled(), "not without a reason");
  await ada.at("lease-reason-io").fill("it stands in the door");
  await ada.at("lease-take-io").click();
  await ben.untilIs("lease-io", "data-holder", "Ada");
  await ben.at("trouble").filter({ hasText: "Ada steers io now" }).waitFor();
  await ben.until(() => [...document.querySelectorAll('[data-event="lease"] title')].some(({ textContent }) => textContent.includes("Ada took it over from Ben: it stands in the door")));
});

test("who does not answer loses it after ten seconds", async () => {
  await ben.at("lease-ask-io").click();
  await ada.at("lease-asked-io").waitFor();
  await ada.untilIs("lease-io", "data-holder", "Ben");
});

test("a page that is closed lets go at once", async () => {
  await ben.page.goto("about:blank");
  await ada.until(() => document.querySelector('[data-testid="lease-io"]') === null);
});

ada.testComplaints();
