// SPDX-License-Identifier: BSD-3-Clause
import type { Diagnostic } from "../../feed/messages";
/** What would put a problem right: another text between two places of its file, counted from 1. */
export interface Fix {
  title: string;
  from: { line: number; column: number };
  to: { line: number; column: number };
  text: string;
  /** The text of the whole file that it puts right; in any other its places are others. */
  of: string;
}
/** A mistake in a program, with what would put it right where the language server knows that. */
export interface FixableDiagnostic extends Diagnostic {
  fix?: Fix;
}

interface Place {
  line: number;
  character: number;
}
interface Range {
  start: Place;
  end: Place;
}

/** What `textDocument/codeAction` answers, as far as the page reads it. */
export interface CodeAction {
  title: string;
  diagnostics?: { range: Range; code?: string | number }[];
  edit?: {
    changes?: Record<string, { range: Range; newText: string }[]>;
    documentChanges?: { edits: { range: Range; newText: string }[] }[];
  };
}

const fixOf = ({ title, edit }: CodeAction, of: string): Fix | undefined => {
  const edits = edit?.documentChanges?.flatMap((change) => change.edits) ?? Object.values(edit?.changes ?? {}).flat();
  const only = edits.length === 1 ? edits[0] : undefined;
  return only && { title, from: placeOf(only.range.start), to: placeOf(only.range.end), text: only.newText, of };
};

const placeOf = ({ line, character }: Place) => ({ line: line + 1, column: character + 1 });

const key = (line: number, column: number, code: string) => `${line}:${column} ${code}`;

/** The problems of a text, each with what would put it right, where the language server knows that. */
export function withFixes(problems: readonly Diagnostic[], actions: readonly CodeAction[], text: string): FixableDiagnostic[] {
  const fixes = new Map<string, Fix>();
  for (const action of actions) {
    const fix = fixOf(action, text);
    for (const { range, code } of action.diagnostics ?? [])
      if (fix) fixes.set(key(range.start.line + 1, range.start.character + 1, String(code ?? "")), fix);
  }
  return problems.map((problem) => {
    const fix = fixes.get(key(problem.line, problem.column, problem.code));
    return fix ? { ...problem, fix } : problem;
  });
}

/** The monitor's own check knows no fixes: they are those that the language server had for the same problem. */
export function withKnownFixes(problems: readonly Diagnostic[], known: readonly FixableDiagnostic[]): FixableDiagnostic[] {
  return problems.map((problem) => {
    const same = known.find(
      ({ file, line, column, code }) => file === problem.file && line === problem.line && column === problem.column && code === problem.code,
    );
    return same?.fix ? { ...problem, fix: same.fix } : problem;
  });
}
