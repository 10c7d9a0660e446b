// SPDX-License-Identifier: BSD-3-Clause
// BHDL's words: what one is depends on the colon behind it, and on whether a value stands behind that.
// `motor_schemas: "noise"` is a state's list, `motor_schemas: noise: …` a section.

import { ExternalTokenizer, type InputStream, type Stack } from "@lezer/lr";
import words from "../../../bhdl/editors/words.json";
import * as terms from "./bhdl.grammar.terms";

const isWord = (character: number): boolean => character > 0 && /\w/.test(String.fromCharCode(character));
const startsWord = (character: number): boolean => isWord(character) && !(character >= 48 && character <= 57);
const isBlank = (character: number): boolean => [32, 9, 10, 13, 0xa0, 0xfeff].includes(character);
const VALUE = new Set([...words.quotes, ...words.minuses, ..."0123456789.<("].map((each) => each.charCodeAt(0)));
const COLON = 58, COMMENT = 59, CARET = 94, SLASH = 47;

/** Where the next thing that is neither blank nor comment is, counted from the stream's place. */
function pastBlanks(input: InputStream, from: number): number {
  let at = from;
  for (;;) {
    const character = input.peek(at);
    if (isBlank(character)) ++at;
    else if (character === COMMENT) while (input.peek(at) > 0 && input.peek(at) !== 10) ++at;
    else return at;
  }
}

function wordAt(input: InputStream, from: number): string {
  let text = "";
  if (startsWord(input.peek(from))) for (let at = from; isWord(input.peek(at)); ++at) text += String.fromCharCode(input.peek(at));
  return text;
}

function labelAt(input: InputStream, from: number): string {
  const word = wordAt(input, from);
  return word && input.peek(pastBlanks(input, from + word.length)) === COLON ? word : "";
}

/** m/s and px^2 are one unit. */
function unitLength(input: InputStream, word: string): number {
  const raised = (at: number): number => (input.peek(at) === CARET && isWord(input.peek(at + 1)) ? at + 2 : at);
  const first = raised(word.length);
  if (input.peek(first) !== SLASH) return first;
  const second = wordAt(input, first + 1);
  return second ? raised(first + 1 + second.length) : first;
}

function blockLabel(word: string): number {
  if (word === "define") return terms.DefineLabel;
  if (word === "expect") return terms.ExpectLabel;
  if (word === "states") return terms.StatesLabel;
  if (words.states.includes(word)) return terms.StateLabel;
  if (words.conditions.includes(word)) return terms.ConditionLabel;
  return words.sections.includes(word) ? terms.SectionLabel : terms.ComponentLabel;
}

function statement(word: string): number | undefined {
  return { include: terms.IncludeLabel, start_state: terms.StartLabel, on_swap: terms.SwapLabel }[word];
}

function label(input: InputStream, stack: Stack, word: string, behind: number): number {
  const named = statement(word);
  if (named && stack.canShift(named)) return named;
  const next = wordAt(input, behind);
  const opens = VALUE.has(input.peek(behind)) ? false : !next || words.end.includes(next) || labelAt(input, behind) !== "";
  if (words.lists.includes(word) && stack.canShift(terms.ListLabel)) {
    const belongsToState = ["name", "extends", ...words.lists, ...words.conditions].includes(next);
    if (!opens || words.end.includes(next) || belongsToState) return terms.ListLabel;
  }
  return opens ? blockLabel(word) : terms.AttributeLabel;
}

export const bhdlWords = new ExternalTokenizer(
  (input, stack) => {
    const word = wordAt(input, 0);
    if (!word) return;
    const behind = pastBlanks(input, word.length);
    const hasColon = input.peek(behind) === COLON;
    if (words.end.includes(word)) {
      input.acceptToken(terms.End, hasColon ? behind + 1 : word.length);
    } else if (hasColon) {
      input.acceptToken(label(input, stack, word, pastBlanks(input, behind + 1)), word.length);
    } else if (word === "include" && stack.canShift(terms.IncludeLabel)) {
      input.acceptToken(terms.IncludeLabel, word.length);
    } else if (stack.canShift(terms.Unit)) {
      input.acceptToken(terms.Unit, unitLength(input, word));
    } else {
      input.acceptToken(terms.Word, word.length);
    }
  },
  { contextual: true },
);
