// SPDX-License-Identifier: BSD-3-Clause
import { foldNodeProp, HighlightStyle, indentNodeProp, LanguageSupport, LRLanguage, syntaxHighlighting } from "@codemirror/language";
import type { EditorState } from "@codemirror/state";
import type { SyntaxNode } from "@lezer/common";
import { styleTags, tags } from "@lezer/highlight";
import { parser } from "./bhdl.grammar";

const BLOCKS = "Section Define Expect Component State Condition SchemaList OnSwap";

/** What a block hides when it is folded: all behind its first line, but its `end`. */
function insideOf(block: SyntaxNode, { doc }: EditorState): { from: number; to: number } | null {
  const from = doc.lineAt(block.from).to;
  const last = block.lastChild;
  const to = last?.name === "End" ? last.from : block.to;
  return from < to ? { from, to } : null;
}

export const bhdlLanguage = LRLanguage.define({
  name: "bhdl",
  parser: parser.configure({
    props: [
      styleTags({
        "SectionLabel StatesLabel DefineLabel ExpectLabel StateLabel ConditionLabel ListLabel": tags.controlKeyword,
        "IncludeLabel StartLabel SwapLabel End": tags.controlKeyword,
        ComponentLabel: tags.typeName,
        AttributeLabel: tags.propertyName,
        Text: tags.string,
        Number: tags.number,
        Unit: tags.unit,
        Comment: tags.lineComment,
      }),
      foldNodeProp.add({ [BLOCKS]: insideOf }),
      indentNodeProp.add({
        [BLOCKS]: (context) => context.baseIndent + (/^\s*end\b/.test(context.textAfter) ? 0 : context.unit),
      }),
    ],
  }),
  languageData: { commentTokens: { line: ";" }, indentOnInput: /^\s*end$/ },
});

const colours = HighlightStyle.define([
  { tag: tags.comment, color: "var(--quiet)", fontStyle: "italic" },
  { tag: tags.string, color: "var(--good)" },
  { tag: tags.keyword, color: "var(--accent)", fontWeight: "650" },
  { tag: tags.typeName, color: "var(--ink)", fontWeight: "650" },
  { tag: [tags.number, tags.unit], color: "var(--warn)" },
]);

export const bhdl = new LanguageSupport(bhdlLanguage, syntaxHighlighting(colours));
