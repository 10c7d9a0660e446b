// SPDX-License-Identifier: BSD-3-Clause
// A recorded team, played again into a monitor of its own: the page shows it as it shows a live one.
// GALILEAN_RECORDING is a recording of the demo; see scripts/browser_tests.sh.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { freshDomain } from "../tools/domain.mjs";
import { within } from "../tools/patience.mjs";
import { ROBOTS, Tab } from "./tab.mjs";

const GALILEAN = fileURLToPath(new URL("../../build/bin/galilean", import.meta.url));
const tab = new Tab();
const { at, row, until, untilGiven } = tab;
const folder = mkdtempSync(join(tmpdir(), "galilean-recorded-"));
const env = { ...process.env, ROS_DOMAIN_ID: freshDomain() };
const started = [];

/** The first line of its output that has `pattern`. */
function start(args, pattern) {
  const child = spawn(GALILEAN, args, { env, cwd: folder });
  started.push({ child, ended: new Promise((ended) => child.once("exit", ended)) });
  return within(new Promise((found, failed) => {
    for (const stream of [child.stdout, child.stderr]) createInterface({ input: stream }).on("line", (line) => pattern.test(line) && found(pattern.exec(line)[0]));
    child.once("exit", () => failed(new Error(`galilean ${args[0]} ended`)));
  }), () => `galilean ${args[0]} to say ${pattern}`);
}

before(async () => {
  assert.ok(process.env.GALILEAN_RECORDING, "set GALILEAN_RECORDING to a recording of a team");
  const url = await start(["monitor", "--listen", "127.0.0.1:0", "--data", folder], /http:\/\/127\.0\.0\.1:\d+/);
  await start(["replay", process.env.GALILEAN_RECORDING, "--loop"], /topics, /);
  await tab.open(url);
  await row("io").getByRole("button").first().click();
});
after(async () => {
  for (const { child } of started) child.kill("SIGINT");
  await tab.close();
  await within(Promise.all(started.map(({ ended }) => ended)), () => "monitor and replay to end");
  rmSync(folder, { recursive: true, force: true });
});

test("every robot is in the team, well, with a state that it has been in for a time that can be", async () => {
  for (const robot of ROBOTS) {
    const { since, silent, hash } = await untilGiven((id) => {
      const element = document.querySelector(`[data-testid=${id}]`);
      const since = element?.querySelector(".since")?.innerText;
      return since && { ...element.dataset, since };
    }, `team-row-${robot}`);
    assert.equal(silent, "false");
    assert.match(hash, /^[0-9a-f]{64}$/);
    assert.match(since, /^\d+(\.\d)? s$/);
  }
});

test("the map has every robot, and they move", async () => {
  const place = (robot) => at(`map-robot-${robot}`).evaluate(({ dataset }) => [dataset.x, dataset.y].join(" "));
  for (const robot of ROBOTS) await at(`map-robot-${robot}`).waitFor();
  const first = await Promise.all(ROBOTS.map(place));
  await until(
    ([robots, known]) => robots.filter((robot, i) => { const { x, y } = document.querySelector(`[data-testid=map-robot-${robot}]`).dataset; return `${x} ${y}` !== known[i]; }).length > 1,
    [ROBOTS, first],
  );
});

test("the state machine lights the state that the team's row tells", async () => {
  await until(() => {
    const lit = document.querySelector("[data-testid=machine] [data-current=true]")?.dataset.state;
    return lit && document.querySelector("[data-testid=team-state-io]").textContent.trim() === lit;
  });
});

test("why: changes come with their causes and with times as recent as they were", async () => {
  const newest = at("why").locator("li.newest");
  await newest.waitFor();
  const known = await newest.getAttribute("data-testid");
  // The words of a line that has just come are not laid out yet.
  const { time, cause } = await untilGiven((before) => {
    const now = document.querySelector("[data-testid=why] li.newest");
    return now && now.dataset.testid !== before && { time: now.querySelector("time").textContent, cause: now.querySelector(".cause").textContent };
  }, known);
  assert.match(time, /^(now|\d+ s ago)$/);
  assert.match(cause, /\w+\[\d+\] became [01]/);
});

test("the timeline has bars of every robot, within its span", async () => {
  const rows = at("timeline").locator(".row");
  for (const robot of ROBOTS) {
    // By its name alone: the words of a mark may contain it ("collision").
    const row = rows.filter({ has: tab.page.locator(".name span", { hasText: new RegExp(`^${robot}$`) }) });
    await row.locator("rect").first().waitFor();
    const beyond = await row.evaluate((each) => {
      const { left, right } = each.getBoundingClientRect();
      return [...each.querySelectorAll("rect")].map((bar) => bar.getBoundingClientRect()).filter((bar) => bar.left < left - 1 || bar.right > right + 1).length;
    });
    assert.equal(beyond, 0, `${robot} has bars outside of the timeline`);
  }
});

test("variables are told with certainties, and the camera is seen, not long ago", async () => {
  await at("variables").locator("[data-variable=shaft] [data-valid=true]").waitFor();
  await until(() => {
    const { shown, latencyMs } = document.querySelector("[data-testid=picture-camera]")?.dataset ?? {};
    return shown > 2 && latencyMs >= 0 && latencyMs < 2000;
  });
});

tab.testComplaints();
