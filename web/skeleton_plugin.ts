// SPDX-License-Identifier: BSD-3-Clause
// What index.html paints before any file of the page has come: its colours, and where its panels will stand.
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import type { HtmlTagDescriptor, IndexHtmlTransformContext, Plugin, Rollup } from "vite";
import { type PlacedStack, placesOf } from "./src/layout/places";
import { treeOf } from "./src/layout/text";
import { STANDARD } from "./src/shell/standard";

const STYLES = fileURLToPath(new URL("src/app.css", import.meta.url));
const THEME = fileURLToPath(new URL("src/theme.js", import.meta.url));
/** The panel in whose place it says that the page starts. */
const SAYS = "map";

const percent = (share: number) => `${(share * 100).toFixed(3)}%`;

function boxOf({ stack, x, y, width, height }: PlacedStack): string {
  const words = stack.panels.includes(SAYS) ? '<p id="starting-word" role="status">starting …</p>' : "";
  return `<div style="left:${percent(x)};top:${percent(y)};width:${percent(width)};height:${percent(height)}">${words}</div>`;
}

function boxes(): string {
  const tree = treeOf(STANDARD, STANDARD.match(/[a-z_]{2,}/g) ?? []);
  if (!tree) throw new Error(`src/shell/standard.ts: '${STANDARD}' is no arrangement, as src/layout/text.ts reads it`);
  return placesOf(tree).map(boxOf).join("");
}

/** Puts `content` in place of a comment of index.html. */
function filled(html: string, comment: string, content: string): string {
  if (!html.includes(comment)) throw new Error(`index.html has no ${comment}, where what is painted first is put`);
  return html.replace(comment, () => content);
}

/**
 * The page and its styles are fetched while index.html is painted, with what the network has to spare, and are only fetched:
 * a module that is preloaded is compiled as it comes, and a stylesheet is read, both before the first paint.
 */
function linksOf({ bundle = {}, chunk }: IndexHtmlTransformContext): HtmlTagDescriptor[] {
  const isScript = (file: string) => bundle[file]?.type === "chunk";
  const later = (chunk?.dynamicImports ?? []).filter(isScript).map((file) => bundle[file] as Rollup.OutputChunk);
  const scripts = later.flatMap(({ fileName, imports }) => [fileName, ...imports]).filter((file) => file !== chunk?.fileName);
  const styles = later.flatMap(({ viteMetadata }) => [...(viteMetadata?.importedCss ?? [])]);
  return [...new Set([...scripts, ...styles])].map((file) => ({ tag: "link", attrs: { rel: "prefetch", href: `/${file}` }, injectTo: "body" }));
}

export const skeleton = (): Plugin[] => [
  {
    name: "galilean-skeleton",
    transformIndexHtml: {
      order: "pre",
      handler: (html) => {
        const placed = filled(html, "<!-- places -->", boxes());
        const styled = filled(placed, "<!-- page styles -->", `<style>${readFileSync(STYLES, "utf8")}</style>`);
        return filled(styled, "<!-- theme -->", `<script>${readFileSync(THEME, "utf8")}</script>`);
      },
    },
    configureServer({ watcher, ws }) {
      watcher.on("change", (path) => [STYLES, THEME].includes(path) && ws.send({ type: "full-reload" }));
    },
  },
  { name: "galilean-skeleton-links", transformIndexHtml: { order: "post", handler: (_, context) => linksOf(context) } },
];
