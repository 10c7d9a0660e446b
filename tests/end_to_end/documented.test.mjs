// SPDX-License-Identifier: BSD-3-Clause
// What README and docs tell people to type is accepted: verbs, commands, options, and sentences of expectations, whose
// states are those of programs that ship.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, test } from 'node:test';
import { ownWords, places } from './help.mjs';
import { galilean, root, scratchFolder } from './tools.mjs';

const PAGES = ['README.md', 'CONTRIBUTING.md', 'sim/README.md', 'bhdl/GRAMMAR.md', 'CHANGELOG.md', ...readdirSync(join(root, 'docs')).filter((name) => name.endsWith('.md')).map((name) => `docs/${name}`)];
const textOf = Object.fromEntries(PAGES.map((page) => [page, readFileSync(join(root, page), 'utf8')]));

/** Code between backticks, also over a line's end, and indented lines: each with the line where it begins. */
function* codeIn(text) {
  for (const { 1: code, index } of text.matchAll(/(?<!`)`([^`]+)`(?!`)/g)) yield { code: code.replace(/\s+/g, ' '), index };
  for (const { 1: code, index } of text.matchAll(/^ {4,}(\S.*)$/gm)) yield { code, index };
}

/** The words of a line as a shell divides it, up to what is another command or a comment. */
function wordsOf(line) {
  const words = [];
  for (const [word] of line.matchAll(/(?:'[^']*'|"[^"]*"|[^\s'"])+/g)) {
    if (/^[#|;&<>]/.test(word)) break;
    words.push(word.replace(/^(['"])(.*)\1$/, '$2').replace(/^\[/, ''));  // [--from 60] may be left out
  }
  return words;
}

const known = places();
const placeOf = (words) => known.filter(({ path }) => path.every((word, at) => words[at] === word)).sort((a, b) => b.path.length - a.path.length)[0];
const isOption = (word) => /^--?[a-z]/.test(word);
const optionOf = (word) => word.replace(/[=,.;:\]].*$/, '');

/** What is wrong about a command that is written somewhere; empty: nothing. */
function wrongAbout(words) {
  if (ownWords.includes(words[0])) return '';
  const place = placeOf(words);
  if (!place) return words[0] && /^[a-z]/.test(words[0]) ? `there is no verb ${words[0]}` : '';
  // Options of an outer command may stand behind an inner one.
  const options = known.filter(({ path }) => path.every((word, at) => place.path[at] === word)).flatMap((each) => each.options);
  const unknown = words.filter(isOption).map(optionOf).filter((option) => !options.includes(option));
  return unknown.length ? `galilean ${place.path.join(' ')} has no ${unknown.join(', ')}` : '';
}

describe('what is documented', () => {
  for (const [page, text] of Object.entries(textOf))
    test(`${page}: commands and their options are those of the programs`, () => {
      const wrong = [];
      for (const { code, index } of codeIn(text)) {
        const found = /^(?:build\/bin\/)?galilean(?:-[a-z-]+)? (.*)$/.exec(code) ?? (page === 'docs/LOGS.md' && /^(log .*)$/.exec(code));
        if (!found || /^galilean-/.test(code.replace('build/bin/', ''))) continue;
        const problem = wrongAbout(wordsOf(found[1]));
        if (problem) wrong.push(`line ${text.slice(0, index).split('\n').length}: ${code}: ${problem}`);
      }
      assert.deepEqual(wrong, []);
    });

  test('options that stand alone are options of some program', () => {
    const all = new Set(known.flatMap(({ options }) => options));
    // These are of tools, too.
    for (const page of PAGES.filter((each) => !['CONTRIBUTING.md', 'docs/ARCHITECTURE.md', 'docs/BENCHMARKS.md', 'docs/MAP.md'].includes(each)))
      for (const { code } of codeIn(textOf[page]))
        if (/^--[a-z]/.test(code)) assert.ok(all.has(optionOf(code.split(' ')[0])), `${page}: ${code}`);
  });

  const shipped = readdirSync(join(root, 'bhdl/programs')).map((name) => join(root, 'bhdl/programs', name));
  const states = new Set(shipped.flatMap((file) => {
    const { status, stdout } = galilean(['bhdl', 'graph', file, '--format', 'json']);
    return status === 0 ? JSON.parse(stdout).states.map(({ name }) => name) : [];  // parts of programs are none
  }));

  /** Expectations in blocks, and those in a line. What a recorder tells of an event has other quotation marks. */
  const expectations = (text) => [
    ...[...text.matchAll(/^```text\n(.*?)^```$/gms)].map(([, block]) => block),
    ...[...codeIn(text)].map(({ code }) => code).filter((code) => /^(every robot|some robot|team|io): [^']*$/.test(code)).map((code) => `${code}\n`),
  ].filter((block) => /^(every|some|team|io)/m.test(block));

  for (const page of ['README.md', 'CHANGELOG.md', 'docs/EXPECT.md', 'docs/CI.md', 'docs/LOGS.md', 'docs/RECORDING.md'])
    test(`${page}: expectations can be read, and states that they name are states of programs that ship`, (t) => {
      const folder = scratchFolder(t);
      expectations(textOf[page]).forEach((block, number) => {
        const file = join(folder, `${number}.expect`);
        writeFileSync(file, block);
        const { status, stdout, stderr } = galilean(['log', 'check', '--syntax', '--expect', file]);
        assert.equal(status, 0, `${block}${stdout}${stderr}`);
      });
      for (const [sentence, state] of textOf[page].matchAll(/\bstate (?:is|becomes)(?: not)? ['"]([^'"]+)['"]|\b(?:from|to) "([a-z_0-9]+)"/g)) assert.ok(states.has(state ?? sentence.match(/"(.*)"/)[1]), `${sentence}: no program that ships has this state`);
    });
});
