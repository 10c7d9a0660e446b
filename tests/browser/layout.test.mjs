// SPDX-License-Identifier: BSD-3-Clause
// Panels arranged by pointer and by keys, kept, shared and brought back; and one at a time on a phone.
import assert from "node:assert/strict";
import { test } from "node:test";
import { PHONE, playedTab } from "./tab.mjs";

const tab = playedTab();
const { at, until } = tab;
const STANDARD = ["team", "program", "map", "machine", "why", "timeline", "variables", "vision"];

const place = (panel) => tab.page.locator(`[data-panel=${panel}]`);
const box = (panel) => place(panel).boundingBox();
const title = (panel) => at(`title-${panel}`);
const isAbove = (upper, lower) => until(([one, other]) => {
  const top = (panel) => document.querySelector(`[data-panel=${panel}]`)?.getBoundingClientRect().top;
  return top(one) < top(other);
}, [upper, lower]);

async function drag(from, to) {
  await tab.page.mouse.move(from.x, from.y);
  await tab.page.mouse.down();
  await tab.page.mouse.move(to.x, to.y, { steps: 6 });
  await tab.page.mouse.up();
}
async function backToStandard() {
  await at("panels-menu").click();
  await at("layout-standard").click();
}
const opened = () => tab.page.locator("[data-panel]").evaluateAll((places) => places.map(({ dataset }) => dataset.panel).sort());

test("the standard layout shows every panel of a laptop without scrolling, five of them with room to read", async () => {
  for (const panel of STANDARD) await place(panel).waitFor();
  const boxes = await Promise.all(STANDARD.map(box));
  for (const { x, y, width, height } of boxes) assert.ok(x > -4 && y > -4 && x + width < 1370 && y + height < 772);
  assert.ok(boxes.filter(({ width, height }) => width > 300 && height > 180).length >= 5);
  assert.equal(await tab.page.evaluate(() => document.documentElement.scrollHeight > innerHeight), false);
});

test("a panel is carried below another by its title", async () => {
  const [from, map] = [await title("why").boundingBox(), await box("map")];
  await drag({ x: from.x + 8, y: from.y + 8 }, { x: map.x + map.width / 2, y: map.y + map.height - 12 });
  await isAbove("map", "why");
  const [above, below] = [await box("map"), await box("why")];
  assert.ok(Math.abs(above.x - below.x) < 2 && Math.abs(above.width - below.width) < 2);
});

test("the arrangement is there again after the page is loaded anew", async () => {
  await tab.page.reload();
  await place("why").waitFor();
  await isAbove("map", "why");
});

test("a link shows it to others, who keep their own", async () => {
  await at("panels-menu").click();
  await tab.page.evaluate(() => Object.defineProperty(navigator, "clipboard", { value: undefined, configurable: true }));
  await at("layout-share").click();
  const link = await tab.page.locator("output").textContent();
  const other = await tab.browser.newPage({ viewport: tab.page.viewportSize() });
  await other.goto(link);
  await other.locator("[data-panel=why]").waitFor();
  const shown = (page) => page.locator("[data-panel]").evaluateAll((all) => all.map(({ dataset, style }) => `${dataset.panel} ${style.cssText}`).sort());
  assert.deepEqual(await shown(other), await shown(tab.page));
  assert.equal(await other.evaluate(() => localStorage.getItem("galilean.layout")), null);
  await other.close();
  await tab.page.keyboard.press("Escape");
});

test("one click brings the standard back", async () => {
  await backToStandard();
  await isAbove("machine", "why");
  assert.equal(await tab.page.evaluate(() => localStorage.getItem("galilean.layout")), null);
});

test("keys alone move a panel, and the keyboard stays on it", async () => {
  await tab.page.keyboard.press("3");
  await until(() => document.activeElement?.dataset.title === "machine");
  await tab.page.keyboard.press("Shift+ArrowDown");
  await isAbove("why", "machine");
  await until(() => document.activeElement?.dataset.title === "machine");
  await backToStandard();
});

test("a border is moved by the pointer and by keys", async () => {
  const before = await box("machine");
  const border = tab.page.getByRole("separator", { name: "Border between Team and State machine" });
  const { x, y, height } = await border.boundingBox();
  await drag({ x: x + 4, y: y + height / 3 }, { x: x - 96, y: y + height / 3 });
  const dragged = await box("machine");
  assert.ok(Math.abs(dragged.width - before.width - 100) < 3, `${before.width} → ${dragged.width}`);
  await border.focus();
  await tab.page.keyboard.press("ArrowRight");
  await until((before_px) => document.querySelector("[data-panel=machine]").getBoundingClientRect().width < before_px, dragged.width);
  await backToStandard();
});

test("a closed panel comes back from the menu, and by its key", async () => {
  await title("vision").focus();
  await tab.page.keyboard.press("Delete");
  await place("vision").waitFor({ state: "detached" });
  await at("panels-menu").click();
  await at("open-vision").check();
  await tab.page.keyboard.press("Escape");
  await place("vision").waitFor();
  await title("vision").focus();
  await tab.page.keyboard.press("Delete");
  await tab.page.keyboard.press("6");
  await place("vision").waitFor();
  await backToStandard();
});

test("panels become tabs of one place, and leave it, from the menu alone", async () => {
  await at("arrange-why").click();
  await tab.page.getByLabel("Put as a tab of").selectOption("machine");
  await place("machine").waitFor({ state: "detached" });
  await title("why").focus();
  await tab.page.keyboard.press("ArrowLeft");
  await place("machine").waitFor();
  await at("arrange-machine").click();
  await tab.page.getByRole("button", { name: "Move down" }).click();
  await tab.page.keyboard.press("Escape");
  await isAbove("why", "machine");
  await backToStandard();
});

test("one panel fills the page, and goes back among the others", async () => {
  await title("map").dblclick();
  await until(() => document.querySelectorAll("[data-panel]").length === 1);
  assert.ok((await box("map")).width > 1300);
  await tab.page.keyboard.press("z");
  await until((count) => document.querySelectorAll("[data-panel]").length === count, STANDARD.length);
  assert.deepEqual(await opened(), [...STANDARD].sort());
});

test("the address carries robot, instant and plots, and never the token; elsewhere it shows the same", async () => {
  await at("variables").locator('[data-variable="shaft"] [data-quantity="heading"]').click();
  await at("team-row-ganymede").locator("button.choose").click();
  await until(() => location.search === "?robot=ganymede&plots=io:shaft:heading");
  await tab.page.keyboard.press("ArrowLeft");
  await until(() => /&at=\d{4}-\d\d-\d\dT[\d:.]+Z&/.test(location.search));
  await tab.page.keyboard.press("l");
  await until(() => !location.search.includes("at="));
  const other = await tab.browser.newPage({ viewport: tab.page.viewportSize() });
  await other.goto(`${tab.page.url()}#token=secret`);
  await other.locator('[data-testid=plot][data-lines="io shaft heading"]').waitFor();
  await other.locator('[data-testid="machine"]').getByText("ganymede").waitFor();
  await other.getByTestId("team-row-callisto").locator("button.choose").click();
  await other.waitForFunction(() => location.search.startsWith("?robot=callisto"));
  assert.equal(other.url().includes("secret"), false);
  await other.close();
});

test("what makes no sense in an address is left out, with a sentence", async () => {
  const other = await tab.browser.newPage({ viewport: tab.page.viewportSize() });
  await other.goto(new URL("/?robot=nobody&at=yesterday&plots=io:shaft:x,io:shaft:weight&layout=z(", tab.url).href);
  await other.locator('[data-testid=plot][data-lines="io shaft x"]').waitFor();
  await other.getByText("the robot nobody, which is not heard").waitFor();
  const told = await other.getByTestId("trouble").innerText();
  assert.match(told, /plot of io shaft weight/);
  await other.waitForFunction(() => location.search === "?plots=io:shaft:x");
  await other.close();
});

test("an instant that a page has not heard is told of, and the present is shown", async () => {
  const other = await tab.browser.newPage({ viewport: tab.page.viewportSize() });
  await other.goto(new URL(`/?robot=io&at=${new Date(Date.now() - 60_000).toISOString()}`, tab.url).href);
  await other.getByText(/asks for \d\d:\d\d:\d\d\. This page was opened later and has heard nothing from before/).waitFor();
  assert.equal(await other.getByTestId("past-notice").count(), 0);
  await other.waitForFunction(() => location.search === "?robot=io");
  await other.close();
});

test("a phone shows one panel at a time, with STOP ALL under the thumb", async () => {
  const phone = await tab.browser.newPage({ viewport: PHONE, hasTouch: true, isMobile: true });
  await phone.goto(tab.url);
  await phone.getByTestId("strip-ganymede").tap();
  for (const panel of ["machine", "why", "variables", "vision", "program", "timeline", "team", "map"]) {
    await phone.getByTestId(`tab-${panel}`).tap();
    const shown = phone.locator("main > section");
    assert.equal(await shown.count(), 1);
    const stop = await phone.getByTestId("stop-all").boundingBox();
    assert.ok(stop.y + stop.height <= PHONE.height && stop.y > PHONE.height * 0.8 && stop.height >= 44, panel);
    assert.equal(await phone.evaluate(() => document.documentElement.scrollWidth > innerWidth), false, panel);
  }
  await phone.close();
});

tab.testComplaints();
