// SPDX-License-Identifier: BSD-3-Clause
// The monitor goes away and comes back: the page says so, connects by itself, and shows what it did not hear.
import assert from "node:assert/strict";
import { test } from "node:test";
import { playedTab, startFixture } from "./tab.mjs";

const tab = playedTab();
const { at, until, untilText } = tab;

test("a monitor that went away is told of, with for how long, and no robot is accused", async () => {
  await at("team-row-io").waitFor();
  await tab.fixture.stop();
  await untilText("connection", /nothing heard for ([3-9]|\d\d)/);
  await at("timeline-gap").waitFor();
  await until(() => document.querySelector("[data-testid=team-rows]").dataset.stale === "true");
  assert.equal(await tab.row("io").getAttribute("data-silent"), "false", "nothing is known against io");
  assert.equal(await at("alarm-count").count(), 0);
});

test("a STOP that nobody takes says so, with no figure of the team cut, and is taken back at a word", async () => {
  await tab.page.keyboard.press(".");
  await untilText("stop-report", /STOP has not reached the robots: .* It is sent again every second, and reaches the robots that are there as soon as the monitor answers\./);
  assert.doesNotMatch(await at("stop-report").innerText(), /They are told again|has not answered for/);
  await until(() => !/heard \d\.\d s ago/.test(document.querySelector("[data-testid=health-io]").textContent) || /heard [1-9]/.test(document.querySelector("[data-testid=health-io]").textContent));
  const cut = await tab.page.evaluate(() => {
    const all = document.querySelector(".figures").getBoundingClientRect();
    return [...document.querySelector(".figures").children].filter((figure) => {
      const { top, right } = figure.getBoundingClientRect();
      return top < all.bottom - 1 && right > all.right + 1;
    }).map(({ textContent }) => textContent);
  });
  assert.deepEqual(cut, []);
  await at("stop-take-back").click();
  await at("stop-report").waitFor({ state: "detached" });
});

test("a STOP that nobody took holds the team of the monitor that answers next", async () => {
  await tab.page.keyboard.press(".");
  await at("stop-take-back").waitFor();
});

test("it is live again by itself, and the gap stays on the timeline", async () => {
  // With time enough to end it again while the push of the next test is under way.
  tab.fixture = await startFixture({ probation: 60 }, new URL(tab.url).port);
  await untilText("connection", /live/);
  await until(() => document.querySelector("[data-testid=team-row-io]")?.dataset.held === "true");
  await at("resume-all").filter({ hasText: "Resume 3" }).click();
  await tab.page.getByRole("button", { name: "Let 3 robots move" }).click();
  await tab.untilRow("io", "data-held", "false");
  await until(() => document.querySelector("[data-testid=team-rows]").dataset.stale === "false");
  assert.equal(await at("timeline-gap").count(), 1);
  assert.match(await at("timeline-gap").getAttribute("title"), /^Nothing was heard from the monitor for \d/);
});

test("a push that was under way when the monitor was started anew is under way no more", async () => {
  await tab.page.evaluate(async () => {
    const { files } = await (await fetch("/api/programs/sit_and_spin.bhdl")).json();
    void fetch("/api/push", { method: "POST", body: JSON.stringify({ files, canary: "io" }) }).catch(() => {});
  });
  await at("push-cancel").waitFor();
  await tab.fixture.stop();
  tab.fixture = await startFixture({}, new URL(tab.url).port);
  await tab.page.getByText("Its monitor ended before it did").waitFor();
  assert.equal(await at("push-cancel").count(), 0);
});
