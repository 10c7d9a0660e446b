// SPDX-License-Identifier: BSD-3-Clause
// textmate.mjs FOLDER: writes the extension that colours BHDL in VS Code, and in whatever else reads
// TextMate grammars. Its words are those of words.json, as the page's are.
import { cpSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));

const escaped = (characters) => characters.replace(/[-\]\\^]/g, "\\$&");

export function textmateGrammar(words) {
  const quote = `[${escaped(words.quotes)}]`;
  const minus = `[${escaped(words.minuses)}]`;
  const digits = "(?:\\d+(?:\\.\\d*)?|\\.\\d+)(?:[eE][-+]?\\d+)?";
  const factor = "[A-Za-z_]\\w*(?:\\^\\d)?";
  const oneOf = (...lists) => `(?:${lists.flat().join("|")})`;
  // What opens a block has no value behind its colon: the same word with one is an attribute.
  const colon = "(?=\\s*:)";
  const block = `(?=\\s*:\\s*(?:;.*)?$|\\s*:\\s*(?:[A-Za-z_]\\w*\\s*:|end\\b))`;
  const list = `(?=\\s*:\\s*${quote})`;
  return {
    name: "BHDL",
    scopeName: "source.bhdl",
    patterns: [
      { name: "comment.line.semicolon.bhdl", match: ";.*$" },
      { name: "string.quoted.bhdl", match: `${quote}[^${escaped(words.quotes)}\\n]*${quote}?` },
      { name: "keyword.control.bhdl", match: `\\b${oneOf(words.end)}\\b:?` },
      { name: "keyword.control.bhdl", match: `\\b${oneOf(words.statements)}\\b(?=\\s*:|\\s*${quote})` },
      { name: "keyword.control.bhdl", match: `\\b${oneOf(words.sections, words.states, words.conditions)}\\b${block}` },
      { name: "keyword.control.bhdl", match: `\\b${oneOf(words.lists)}\\b${list}` },
      { name: "entity.name.type.bhdl", match: `\\b[A-Za-z_]\\w*\\b${block}` },
      { name: "variable.other.property.bhdl", match: `\\b[A-Za-z_]\\w*\\b${colon}` },
      {
        match: `(${minus}?${digits})(?:[ \\t]*(?!${oneOf(words.end)}\\b)(${factor}(?:/${factor})?)\\b(?!\\s*:))?`,
        captures: { 1: { name: "constant.numeric.bhdl" }, 2: { name: "keyword.other.unit.bhdl" } },
      },
    ],
  };
}

export function writeExtension(folder) {
  const words = JSON.parse(readFileSync(join(here, "words.json"), "utf8"));
  mkdirSync(join(folder, "syntaxes"), { recursive: true });
  cpSync(join(here, "vscode"), folder, { recursive: true });
  writeFileSync(join(folder, "syntaxes/bhdl.tmLanguage.json"), `${JSON.stringify(textmateGrammar(words), null, 2)}\n`);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  if (process.argv.length !== 3) {
    console.error("textmate.mjs: give the folder that the extension is written to");
    process.exit(2);
  }
  writeExtension(process.argv[2]);
}
