// SPDX-License-Identifier: BSD-3-Clause
import { expect, it } from "vitest";
import { problemsFrom } from "../../../src/program/editor/problems";

it("tells what the language server published as the monitor's check would", () => {
  const range = { start: { line: 1, character: 2 } };
  const diagnostics = [
    { range, severity: 1, code: "name/undefined-state", message: "no 'og'\ndid you mean 'go'?" },
    { range, severity: 2, message: "a word" },
  ];
  expect(problemsFrom("a.bhdl", { uri: "file:///a.bhdl", diagnostics })).toEqual([
    { file: "a.bhdl", line: 2, column: 3, severity: "error", code: "name/undefined-state", message: "no 'og'", hint: "did you mean 'go'?" },
    { file: "a.bhdl", line: 2, column: 3, severity: "warning", code: "", message: "a word", hint: "" },
  ]);
});
