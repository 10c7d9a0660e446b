import { HighlightStyle, LanguageSupport, StreamLanguage, type StreamParser, syntaxHighlighting } from "@codemirror/language";
import { tags } from "@lezer/highlight";

const SECTIONS = /^(input_devices|output_devices|variables|perceptual_schemas|percp_schemas|motor_schemas|states?|condition|define|start_state|on_swap)\b/;

/** BHDL's words by colour; what they mean is the checker's business. */
const parser: StreamParser<unknown> = {
  name: "bhdl",
  startState: () => ({}),
  token(stream) {
    if (stream.eatSpace()) return null;
    if (stream.match(/^;.*/)) return "comment";
    if (stream.match(/^["“”][^"“”]*["“”]?/)) return "string";
    if (stream.match(/^end\b/) || stream.match(/^include\b/)) return "keyword";
    if (stream.match(SECTIONS)) return "keyword";
    if (stream.match(/^[A-Za-z_]\w*(?=\s*:)/)) return "propertyName";
    if (stream.match(/^[-–−+]?\d+(\.\d+)?([eE][-+]?\d+)?/)) return "number";
    if (stream.match(/^\w+/)) return null;
    stream.next();
    return null;
  },
  languageData: { commentTokens: { line: ";" } },
};

const colours = HighlightStyle.define([
  { tag: tags.comment, color: "var(--quiet)", fontStyle: "italic" },
  { tag: tags.string, color: "var(--good)" },
  { tag: tags.keyword, color: "var(--accent)", fontWeight: "650" },
  { tag: tags.number, color: "var(--warn)" },
]);

export const bhdl = new LanguageSupport(StreamLanguage.define(parser), syntaxHighlighting(colours));
