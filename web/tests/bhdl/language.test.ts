// SPDX-License-Identifier: BSD-3-Clause
import { readdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { ensureSyntaxTree, foldable } from "@codemirror/language";
import { EditorState } from "@codemirror/state";
import { highlightTree, tagHighlighter, tags } from "@lezer/highlight";
import oniguruma from "vscode-oniguruma";
import textmate from "vscode-textmate";
import { expect, test } from "vitest";
import words from "../../../bhdl/editors/words.json";
import { textmateGrammar } from "../../../bhdl/editors/textmate.mjs";
import { bhdlLanguage } from "../../src/bhdl/language";

const folder = new URL("../../../bhdl/programs/", import.meta.url);
const programs = readdirSync(folder).filter((name) => name.endsWith(".bhdl"));
const textOf = (name: string): string => readFileSync(new URL(name, folder), "utf8");

const classes = tagHighlighter([
  { tag: tags.controlKeyword, class: "keyword" },
  { tag: tags.typeName, class: "type" },
  { tag: tags.propertyName, class: "property" },
  { tag: tags.string, class: "string" },
  { tag: tags.number, class: "number" },
  { tag: tags.unit, class: "unit" },
  { tag: tags.comment, class: "comment" },
]);
const scopes: Record<string, string> = {
  "keyword.control.bhdl": "keyword",
  "entity.name.type.bhdl": "type",
  "variable.other.property.bhdl": "property",
  "string.quoted.bhdl": "string",
  "constant.numeric.bhdl": "number",
  "keyword.other.unit.bhdl": "unit",
  "comment.line.semicolon.bhdl": "comment",
};

/** "line:text class" of all that has a class, as the page colours it. */
function byPage(text: string): string[] {
  const marks: string[] = [];
  highlightTree(bhdlLanguage.parser.parse(text), classes, (from, to, name) => {
    marks.push(`${text.slice(0, from).split("\n").length}:${text.slice(from, to).replace(/:$/, "").trim()} ${name}`);
  });
  return marks;
}

async function textmateTokenizer(): Promise<(text: string) => string[]> {
  const wasm = createRequire(import.meta.url).resolve("vscode-oniguruma/release/onig.wasm");
  await oniguruma.loadWASM(readFileSync(wasm));
  const registry = new textmate.Registry({
    onigLib: Promise.resolve({
      createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns),
      createOnigString: (text) => new oniguruma.OnigString(text),
    }),
    loadGrammar: async () => textmate.parseRawGrammar(JSON.stringify(textmateGrammar(words)), "bhdl.json"),
  });
  const grammar = await registry.loadGrammar("source.bhdl");
  return (text) =>
    text.split("\n").flatMap((line, at) =>
      grammar!.tokenizeLine(line, textmate.INITIAL).tokens.flatMap(({ startIndex, endIndex, scopes: all }) => {
        const name = scopes[all.at(-1)!];
        return name ? [`${at + 1}:${line.slice(startIndex, endIndex).replace(/:$/, "").trim()} ${name}`] : [];
      }),
    );
}

test.each(programs)("%s has a tree without a mistake in it", (name) => {
  const mistakes: string[] = [];
  const text = textOf(name);
  bhdlLanguage.parser.parse(text).iterate({
    enter: (node) => void (node.type.isError && mistakes.push(`${text.slice(0, node.from).split("\n").length}: ${text.slice(node.from, node.from + 30)}`)),
  });
  expect(mistakes).toEqual([]);
});

test("VS Code and the page colour every shipped program alike", async () => {
  const byTextmate = await textmateTokenizer();
  expect(programs.length).toBeGreaterThanOrEqual(6);
  for (const name of programs) {
    const text = textOf(name);
    expect(byTextmate(text), name).toEqual(byPage(text));
  }
});

test("a word is what stands behind it", () => {
  const kinds = (text: string): string[] => byPage(text).map((mark) => mark.replace(/^\d+:/, ""));
  expect(kinds('motor_schemas: "noise" end')).toContain("motor_schemas property");
  expect(kinds("state: motor_schemas: “noise” end end")).toContain("motor_schemas keyword");
  expect(kinds("motor_schemas: noise: gain: 2 end end")).toEqual(expect.arrayContaining(["motor_schemas keyword", "noise type", "gain property"]));
  expect(kinds('variables: bits: variables: "trash" end')).toContain("variables property");
  expect(kinds("noise: period: 30 ms gain: –2")).toEqual(expect.arrayContaining(["ms unit", "–2 number", "gain property"]));
});

test("a state folds to its end, and an unfinished text has a tree all the same", () => {
  const text = 'state: name: "a"\n  condition: bit_index: 3\n  end\nend\nstate: name: "b"\n  condition:';
  const opened = EditorState.create({ doc: text, extensions: bhdlLanguage });
  const tree = ensureSyntaxTree(opened, text.length, 60_000)!;
  const { state } = opened.update({});
  expect(foldable(state, 0, state.doc.line(1).to)).toEqual({ from: state.doc.line(1).to, to: text.indexOf("end\nstate") });
  const names: string[] = [];
  tree.iterate({ enter: ({ name }) => void names.push(name) });
  expect(names.filter((name) => name === "State")).toHaveLength(2);
  expect(names.filter((name) => name === "Condition")).toHaveLength(2);
});
