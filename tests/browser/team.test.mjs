// The page in a real browser on a live team, by the link that `galilean demo` prints:
// GALILEAN_URL=http://127.0.0.1:8080/#token=… node --test tests/browser/
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";

const { chromium } = createRequire(new URL("../../web/package.json", import.meta.url))("playwright-core");

const url = process.env.GALILEAN_URL;
const ROBOTS = ["io", "ganymede", "callisto"];
const PATIENCE_MS = 120_000;
const complaints = [];
let browser;
let page;

const at = (testid) => page.getByTestId(testid);
const row = (robot) => at(`team-row-${robot}`);
const until = (condition, argument) => page.waitForFunction(condition, argument, { timeout: PATIENCE_MS });
const untilRow = (robot, attribute, value) =>
  until(([id, name, wanted]) => document.querySelector(`[data-testid=${id}]`)?.getAttribute(name) === wanted, [`team-row-${robot}`, attribute, value]);

async function untilReply(robot, statuses) {
  await until(([id, wanted]) => wanted.includes(document.querySelector(`[data-testid=${id}]`)?.dataset.status), [`reply-${robot}`, statuses]);
}

async function api(path, body) {
  const request = body && { method: "POST", headers: { "content-type": "application/json" }, body: JSON.stringify(body) };
  return (await fetch(new URL(path, url), request)).json();
}

before(async () => {
  assert.ok(url, "set GALILEAN_URL to the operator's link of a running team's monitor");
  browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox", "--disable-gpu"] });
  page = await browser.newPage({ viewport: { width: 1366, height: 768 } });
  page.setDefaultTimeout(PATIENCE_MS);
  page.on("console", (message) => message.type() === "error" && complaints.push(message.text()));
  page.on("pageerror", (error) => complaints.push(error.message));
  await page.goto(url);
});
after(() => browser?.close());

test("three robots are in the team and move on the map", async () => {
  for (const robot of ROBOTS) await row(robot).waitFor();
  for (const robot of ROBOTS) await at(`map-robot-${robot}`).waitFor();
  await page.evaluate((robots) => {
    window.begun = Object.fromEntries(robots.map((name) => [name, { ...document.querySelector(`[data-testid=map-robot-${name}]`).dataset }]));
  }, ROBOTS);
  await until((robots) =>
    robots.every((name) => {
      const { x, y } = document.querySelector(`[data-testid=map-robot-${name}]`).dataset;
      return Math.hypot(x - window.begun[name].x, y - window.begun[name].y) > 0.1;
    }), ROBOTS);
});

test("a robot's change of state is lit in its machine, with its cause", async () => {
  await row("io").getByRole("button").first().click();
  const lit = at("machine").locator("[data-testid^=state-][data-current=true]");
  const before = await lit.getAttribute("data-testid");
  await until((id) => {
    const now = document.querySelector("[data-testid=machine] [data-current=true]")?.dataset.testid;
    return now !== undefined && now !== id;
  }, before);
  await at("why").locator("li.newest .cause").waitFor();
});

test("changes of state reach the page", async (t) => {
  await page.evaluate(() => {
    window.delays_ms = [];
    const newest = () => Number(document.querySelector("[data-testid=why] li.newest")?.dataset.stampS);
    let known = newest();
    new MutationObserver(() => {
      if (newest() === known) return;
      known = newest();
      window.delays_ms.push(Date.now() - known * 1000);
    }).observe(document.querySelector("[data-testid=why]"), { subtree: true, childList: true, attributes: true });
  });
  await until(() => window.delays_ms.length >= 5);
  const delays_ms = (await page.evaluate(() => window.delays_ms)).sort((a, b) => a - b);
  t.diagnostic(`from a robot's change of state to the changed page: median ${delays_ms[2].toFixed(0)} ms of 5`);
});

test("score and clock are shown, and the clock runs", async () => {
  const shown = await at("clock").textContent();
  assert.match(shown, /\d\d:\d\d/);
  await until((text) => document.querySelector("[data-testid=clock]").textContent !== text, shown);
  assert.match(await at("score").textContent(), /\d+ of \d+/);
});

test("a variable's certainty decays between its samples", async () => {
  await page.evaluate(() => {
    window.certainties = new Map();
  });
  await until(() =>
    [...document.querySelectorAll("[data-testid=variables] [data-certainty]")].some(({ dataset }) => {
      const before = window.certainties.get(dataset.variable) ?? -1;
      window.certainties.set(dataset.variable, Number(dataset.certainty));
      return Number(dataset.certainty) > 0 && Number(dataset.certainty) < before;
    }), undefined);
});

test("camera and supercomponents of the chosen robot are shown", async () => {
  for (const picture of ["camera", "superred", "supergreen", "superblue"])
    await until((id) => Number(document.querySelector(`[data-testid=${id}]`)?.dataset.shown) > 0, `picture-${picture}`);
});

test("sit and spin is pushed to the team, and its states appear", async () => {
  const { files } = await api("/api/programs/sit_and_spin.bhdl");
  const { machine, hash } = await api("/api/check", { files });
  const running = await row("io").getAttribute("data-hash");
  assert.notEqual(running, hash);

  await at("program-select").selectOption("sit_and_spin.bhdl");
  await at("push-button").click();
  await at("push-confirm").click();
  for (const robot of ROBOTS) await untilReply(robot, ["running", "confirmed"]);
  for (const robot of ROBOTS) await untilRow(robot, "data-hash", hash);
  for (const { name } of machine.states) await at(`state-${name}`).waitFor();
  await at("machine").locator("[data-current=true]").waitFor();
});

test("a broken program shows its errors with their lines and changes nothing", async () => {
  const running = await row("io").getAttribute("data-hash");
  await at("edit-button").click();
  const text = at("program-editor").locator(".cm-content");
  await text.click();
  await page.keyboard.press("Control+Home");
  await page.keyboard.type("nonsense_here:\n");
  await at("check-button").click();
  await at("diagnostics").getByText(/:1:\d+/).first().waitFor();

  await at("push-button").click();
  await at("push-confirm").click();
  await page.getByRole("alert").getByText("The program has errors").waitFor();
  await at("diagnostics").getByText(/:1:\d+/).first().waitFor();
  assert.equal(await row("io").getAttribute("data-hash"), running);
  await at("editor-close").click();
  // The browser logs every refusal of a server; this one was asked for.
  const refusal = complaints.findIndex((complaint) => complaint.includes("status of 422"));
  if (refusal >= 0) complaints.splice(refusal, 1);
});

test("what was meant is put in with one click", async () => {
  await at("edit-button").click();
  const text = at("program-editor").locator(".cm-content");
  await text.click();
  await page.keyboard.press("Control+Home");
  await page.keyboard.type("motr_schemas:\nend\n");
  await text.locator(".cm-lintRange-error").first().hover();
  await page.getByRole("button", { name: "Change to 'motor_schemas'" }).click();
  await text.getByText(/^motor_schemas:$/).first().waitFor();
  await at("editor-close").click();
});

test("a canary runs a program first, each step is shown, and cancelling takes it back", async () => {
  const running = await row("callisto").getAttribute("data-hash");
  await at("program-select").selectOption("office_cleanup.bhdl");
  await at("push-button").click();
  await at("push-canary").selectOption("callisto");
  await at("push-probation").fill("60");
  await at("push-confirm").click();
  await until((id) => document.querySelector(`[data-testid=${id}]`)?.dataset.state === "running", "step-canary");
  await untilReply("callisto", ["running", "confirmed"]);
  await at("push-cancel").first().click();
  await until((id) => document.querySelector(`[data-testid=${id}]`)?.dataset.state === "cancelled", "step-canary");
  await untilRow("callisto", "data-hash", running);
  assert.equal(await row("io").getAttribute("data-hash"), running);
});

test("STOP ALL holds every robot, and resuming asks", async () => {
  await at("stop-all").click();
  for (const robot of ROBOTS) await untilRow(robot, "data-held", "true");
  await at("resume-all").click();
  await page.getByRole("button", { name: /^Let .* move$/ }).click();
  for (const robot of ROBOTS) await untilRow(robot, "data-held", "false");
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
  await until(([hash]) => {
    const now = document.querySelector("[data-testid=team-row-io]")?.dataset.hash;
    return now !== undefined && now !== hash;
  }, [running]);
  const hash = await row("io").getAttribute("data-hash");
  assert.equal(await row("callisto").getAttribute("data-hash"), others);
  const pushed = await api(`/api/pushed/${hash}`);
  assert.match(pushed.files.map(({ text }) => text).join(""), /threshold: 255/);
  await at("tune-button").click();
});

test("the browser has nothing to complain of", () => {
  assert.deepEqual(complaints, []);
});
