// SPDX-License-Identifier: BSD-3-Clause
import type { Diagnostic } from "../../feed/messages";

interface Problem {
  range: { start: { line: number; character: number } };
  severity?: number;
  code?: string | number;
  message: string;
}

/** `textDocument/publishDiagnostics`, as far as the page reads it. */
export interface PublishedProblems {
  uri: string;
  version?: number;
  diagnostics: Problem[];
}

const ERROR = 1;

/** In the form of the monitor's own check: lines and columns from 1, the hint behind the first line. */
export function problemsFrom(path: string, { diagnostics }: PublishedProblems): Diagnostic[] {
  return diagnostics.map(({ range, severity, code, message }) => {
    const [first = "", ...hint] = message.split("\n");
    return {
      file: path,
      line: range.start.line + 1,
      column: range.start.character + 1,
      severity: severity === ERROR ? "error" : "warning",
      code: String(code ?? ""),
      message: first,
      hint: hint.join("\n"),
    };
  });
}
