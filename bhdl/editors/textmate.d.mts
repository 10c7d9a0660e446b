// SPDX-License-Identifier: BSD-3-Clause
export interface Words {
  sections: string[];
  lists: string[];
  states: string[];
  conditions: string[];
  statements: string[];
  end: string[];
  quotes: string;
  minuses: string;
}

export function textmateGrammar(words: Words): object;
export function writeExtension(folder: string): void;
