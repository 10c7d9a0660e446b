// SPDX-License-Identifier: BSD-3-Clause
import { expect, it } from "vitest";
import { withFixes, withKnownFixes } from "../../../src/program/editor/quick_fixes";

const problem = { file: "a.bhdl", line: 2, column: 3, severity: "error", code: "name/undefined-state", message: "no 'og'", hint: "" };
const other = { ...problem, line: 5 };
const range = { start: { line: 1, character: 2 }, end: { line: 1, character: 6 } };
const inside = { start: { line: 1, character: 3 }, end: { line: 1, character: 5 } };
const fix = { title: "Change to 'go'", from: { line: 2, column: 4 }, to: { line: 2, column: 6 }, text: "go", of: "\n   og" };

it("gives a problem the one edit that puts it right", () => {
  const diagnostics = [{ range, code: problem.code }];
  for (const edit of [
    { changes: { "file:///a.bhdl": [{ range: inside, newText: "go" }] } },
    { documentChanges: [{ edits: [{ range: inside, newText: "go" }] }] },
  ])
    expect(withFixes([problem, other], [{ title: fix.title, diagnostics, edit }], fix.of)).toEqual([{ ...problem, fix }, other]);
});

it("leaves out what would need several edits", () => {
  const edits = [{ range: inside, newText: "go" }, { range, newText: "" }];
  const action = { title: fix.title, diagnostics: [{ range, code: problem.code }], edit: { documentChanges: [{ edits }] } };
  expect(withFixes([problem], [action], fix.of)).toEqual([problem]);
});

it("knows a problem again that the monitor's check tells", () => {
  expect(withKnownFixes([problem, other], [{ ...problem, message: "as typed", fix }])).toEqual([{ ...problem, fix }, other]);
});
