// SPDX-License-Identifier: BSD-3-Clause
// WCAG 2.2 AA as far as axe can tell.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const axe = readFileSync(createRequire(new URL("../../web/package.json", import.meta.url)).resolve("axe-core/axe.min.js"), "utf8");
const RULES = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"];

/** Before `violations` of the page. */
export const loadAxe = (page) => page.evaluate(axe);

/** What breaks a rule on the page as it is now, a line each. */
export async function violations(page) {
  // Of what breaks no rule it need not say where it stands, which takes it longest.
  const found = await page.evaluate((rules) => window.axe.run({ runOnly: { type: "tag", values: rules }, resultTypes: ["violations"] }), RULES);
  return found.violations.flatMap(({ id, nodes }) => nodes.map((node) => `${id}: ${node.html.slice(0, 120)} ${node.any[0]?.message ?? ""}`));
}
