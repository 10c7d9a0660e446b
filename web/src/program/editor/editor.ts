// SPDX-License-Identifier: BSD-3-Clause
// CodeMirror, as the page uses it. Loaded only when somebody edits.

import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import { bracketMatching, foldGutter, foldKeymap } from "@codemirror/language";
import { type Action, type Diagnostic as Mark, lintGutter, lintKeymap, setDiagnostics } from "@codemirror/lint";
import { type Extension, StateEffect, StateField } from "@codemirror/state";
import { Decoration, type DecorationSet, drawSelection, EditorView, highlightActiveLine, keymap, lineNumbers } from "@codemirror/view";
import { bhdl } from "../../bhdl/language";
import { changeOf, offsetOf } from "./fix_change";
import type { Fix, FixableDiagnostic } from "./quick_fixes";

const setRunningLine = StateEffect.define<number | undefined>();
const runningLine = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(lines, { changes, effects, newDoc }) {
    for (const effect of effects) {
      if (!effect.is(setRunningLine)) continue;
      const line = effect.value;
      if (!line || line > newDoc.lines) return Decoration.none;
      return Decoration.set([Decoration.line({ class: "cm-running" }).range(newDoc.line(line).from)]);
    }
    return lines.map(changes);
  },
  provide: (field) => EditorView.decorations.from(field),
});

const look = EditorView.theme({
  "&": { height: "100%", fontSize: "13px", backgroundColor: "var(--panel)", color: "var(--ink)" },
  ".cm-content": { caretColor: "var(--ink)" },
  ".cm-cursor": { borderLeftColor: "var(--ink)" },
  ".cm-gutters": { backgroundColor: "var(--panel)", color: "var(--quiet)", borderRight: "1px solid var(--line)" },
  ".cm-activeLine": { backgroundColor: "color-mix(in srgb, var(--raised) 55%, transparent)" },
  ".cm-running": { boxShadow: "inset 3px 0 var(--accent)", backgroundColor: "var(--chosen)" },
  ".cm-tooltip-autocomplete ul li[aria-selected]": { backgroundColor: "var(--chosen)", color: "var(--ink)" },
  ".cm-tooltip .cm-completionDetail": { color: "var(--quiet)" },
  ".cm-tooltip.cm-lsp-hover-tooltip": { maxWidth: "60ch", maxHeight: "40vh", overflowY: "auto" },
  ".cm-panels": { backgroundColor: "var(--panel)", color: "var(--ink)" },
  ".cm-tooltip": { backgroundColor: "var(--panel)", border: "1px solid var(--line)", color: "var(--ink)" },
  "&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground": {
    backgroundColor: "color-mix(in srgb, var(--accent) 30%, transparent)",
  },
});

const actionOf = (fix: Fix): Action => ({
  name: fix.title,
  apply: (view) => {
    const changes = changeOf(fix, view.state.doc);
    if (changes) view.dispatch({ changes, userEvent: "input.fix" });
  },
});

export class Editor {
  #view: EditorView;

  /** `language`: what the language server adds. */
  constructor(parent: HTMLElement, text: string, edited: (text: string) => void, language: Extension = []) {
    const told = EditorView.updateListener.of((update) => update.docChanged && edited(update.state.doc.toString()));
    const extensions: Extension[] = [
      lineNumbers(), foldGutter(), history(), drawSelection(), bracketMatching(), highlightActiveLine(), lintGutter(), runningLine, bhdl, look, told,
      language,
      keymap.of([...defaultKeymap, ...historyKeymap, ...foldKeymap, ...lintKeymap, indentWithTab]),
      EditorView.contentAttributes.of({ "aria-label": "Program text", tabindex: "0" }),
    ];
    this.#view = new EditorView({ parent, doc: text, extensions });
  }

  get view(): EditorView {
    return this.#view;
  }

  /** Marks problems of the file that is shown; lines and columns count from 1. */
  mark(diagnostics: readonly FixableDiagnostic[]): void {
    const { doc } = this.#view.state;
    const marks = diagnostics.map(({ line, column, severity, message, hint, fix }): Mark => {
      const from = offsetOf(doc, { line, column });
      const at = doc.lineAt(from);
      const word = /^[\w.]+/.exec(doc.sliceString(from, at.to))?.[0].length ?? 0;
      const text = hint ? `${message} (${hint})` : message;
      return { from, to: Math.min(from + Math.max(word, 1), at.to), severity: severity === "error" ? "error" : "warning", message: text, actions: fix && [actionOf(fix)] };
    });
    this.#view.dispatch(setDiagnostics(this.#view.state, marks));
  }

  /** Lights the line where the state that runs is declared. */
  light(line: number | undefined): void {
    this.#view.dispatch({ effects: setRunningLine.of(line) });
  }

  show(line: number, column: number): void {
    const { doc } = this.#view.state;
    const anchor = offsetOf(doc, { line, column });
    this.#view.dispatch({ selection: { anchor }, effects: EditorView.scrollIntoView(anchor, { y: "center" }) });
    this.#view.focus();
  }

  close(): void {
    this.#view.destroy();
  }
}
