// SPDX-License-Identifier: BSD-3-Clause
// Manual pages: one for each verb, in roff that formatters take, with all that --help has.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { copyFileSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { places, verbs } from './help.mjs';
import { galilean, galileanBinary, root, scratchFolder } from './tools.mjs';

const built = `${process.env.GALILEAN_BUILD ?? `${root}build`}/share/man/man1`;
const pages = Object.fromEntries(readdirSync(built).map((file) => [file, readFileSync(join(built, file), 'utf8')]));
const pageOf = (verb) => `galilean-${verb.join('-')}.1`;

/** The text as a reader sees it, but for its layout. */
const read = (roff) => roff.replace(/\\f[BIR]/g, '').replaceAll('\\&', '').replaceAll('\\-', '-').replaceAll('\\(aq', "'")
  .replaceAll('\\(ha', '^').replaceAll('\\(ti', '~').replaceAll('\\(ga', '`').replace(/\\\[u([0-9A-F]+)\]/g, (_, code) => String.fromCodePoint(parseInt(code, 16)));

test('the build makes one page of each verb and of galilean, as the verb manual prints them', (t) => {
  const folder = join(scratchFolder(t), 'new', 'man1');
  assert.equal(galilean(['manual', '--into', folder]).status, 0);
  const names = ['galilean.1', ...verbs().map(pageOf)].sort();
  assert.deepEqual(readdirSync(folder).sort(), names);
  assert.deepEqual(Object.keys(pages).sort(), names);
  for (const name of names) assert.equal(readFileSync(join(folder, name), 'utf8'), pages[name], name);
  assert.equal(galilean(['manual', 'sim', 'ctl']).stdout, pages['galilean-sim-ctl.1']);
  assert.equal(galilean(['manual']).stdout, pages['galilean.1']);
});

test('every option and command that --help has is on its page, under its command', () => {
  const all = verbs();
  const isVerb = (path) => all.some((verb) => verb.join(' ') === path.join(' '));
  for (const { path, options, commands } of places()) {
    const verb = all.filter((each) => each.every((word, at) => path[at] === word)).sort((a, b) => b.length - a.length)[0];
    const page = pages[pageOf(verb)];
    const inner = path.length > verb.length;
    const start = inner ? `.SS "${path.join(' ').replace(/^/, 'galilean ').replaceAll('-', '\\-')}"\n` : '.SH OPTIONS\n';
    const block = page.split(start)[1]?.split(/^\.S[HS] /m)[0];
    assert.ok(block, `${pageOf(verb)}: ${start}`);
    const terms = [...block.matchAll(/^\.TP\n(.*)$/gm)].map(([, term]) => read(term));
    for (const option of options) assert.ok(terms.some((term) => term.split(/[ ,[]+/).includes(option)), `${path.join(' ')} ${option}: ${terms}`);
    for (const command of commands.filter((each) => !isVerb([...path, each])))
      assert.ok(read(page).includes(`\n.SS "galilean ${[...path, command].join(' ')}"\n`), `${path.join(' ')} ${command}`);
  }
});

test('every page has the sections of a command, in their order', () => {
  for (const [name, page] of Object.entries(pages)) {
    const sections = [...page.matchAll(/^\.SH (.*)$/gm)].map(([, title]) => title);
    const order = ['NAME', 'SYNOPSIS', 'DESCRIPTION', 'OPTIONS', 'COMMANDS', 'EXIT STATUS', 'ENVIRONMENT', 'SEE ALSO'];
    assert.deepEqual(sections, order.filter((title) => sections.includes(title)), name);
    for (const title of order.filter((each) => !['COMMANDS', 'ENVIRONMENT'].includes(each))) assert.ok(sections.includes(title), `${name} ${title}`);
    assert.match(page, new RegExp(`^\\.SH NAME\n${name.slice(0, -2).replaceAll('-', '\\\\-')} \\\\- \\S`, 'm'));
    const exits = page.split('.SH EXIT STATUS\n')[1].split('.SH')[0];
    for (const code of [0, 1, 2]) assert.ok(exits.includes(`.TP\n\\fB${code}\\fR`), `${name} ${code}`);
  }
  assert.match(read(pages['galilean-bhdl.1']), /\n1, of galilean bhdl diff\nThe programs differ\.\n/);
  assert.match(read(pages['galilean-log-check.1']), /\n3\nNone fails, but for some it cannot be told/);
  assert.match(read(pages['galilean-log.1']), /\n3, of galilean log cat\nA part of the recording is damaged/);
  assert.doesNotMatch(pages['galilean-list.1'].split('.SH EXIT STATUS\n')[1], /\\fB3/);
});

test('every page refers only to pages that there are, and galilean(1) to all', () => {
  const references = (page) => [...read(page).split('.SH SEE ALSO\n')[1].matchAll(/([\w-]+)\(1\)/g)].map(([, name]) => `${name}.1`);
  for (const [name, page] of Object.entries(pages)) for (const other of references(page)) assert.ok(pages[other], `${name}: ${other}`);
  assert.deepEqual(references(pages['galilean.1']).sort(), verbs().map(pageOf).sort());
});

test('the roff is plain: known requests and escapes, ASCII, no line that roff would take for a request', () => {
  for (const [name, page] of Object.entries(pages)) {
    assert.match(page, /^\.\\" .*\n\.TH GALILEAN\S* 1 "" "Galilean \d\S*" "Galilean"\n/, name);
    assert.match(page, /^[\n -~]*$/, name);
    for (const line of page.split('\n').slice(2, -1)) {
      assert.match(line, /^(\.SH [A-Z ]+|\.SS "[^"]+"|\.(PP|TP|br)|[^.'].*)$/, `${name}: ${line}`);
      const rest = line.replace(/\\(f[BIR]|-|e|&|\((aq|ha|ti|ga)|\[u[0-9A-F]{4,6}\])/g, '');
      assert.ok(!rest.includes('\\'), `${name}: ${line}`);
      const fonts = [...line.matchAll(/\\f(.)/g)].map(([, font]) => font);
      fonts.forEach((font, at) => assert.equal(font === 'R', at % 2 === 1, `${name}: ${line}`));
    }
    assert.ok(!/\.TP\n(\.|.*\n\.)/.test(page), `${name} has an item without a text`);
  }
});

test('groff takes every page without a warning, where there is one', () => {
  for (const name of Object.keys(pages)) {
    const { error, status, stderr } = spawnSync('groff', ['-man', '-ww', '-Tutf8', '-z', join(built, name)], { encoding: 'utf8' });
    if (error?.code === 'ENOENT') return;
    assert.deepEqual([status, stderr], [0, ''], name);
  }
});

test('pages do not depend on who makes them', (t) => {
  const folder = scratchFolder(t);
  const env = { USER: 'xyzzy', HOME: '/home/xyzzy', XDG_STATE_HOME: '/xyzzy', LC_ALL: 'de_DE.UTF-8' };
  assert.equal(galilean(['manual', '--into', folder], { env }).status, 0);
  for (const [name, page] of Object.entries(pages)) assert.equal(readFileSync(join(folder, name), 'utf8'), page, name);
});

test('galilean(1) names every variable of the environment that the programs read, and no other', () => {
  const sources = execFileSync(join(root, 'scripts/sources.sh'), ['*.cpp', '*.h'], { encoding: 'utf8' }).split('\n')
    .filter((file) => /^(core|bhdl|robot|sim|monitor)\//.test(file) && !file.includes('front/manual/'));
  const text = sources.map((file) => readFileSync(join(root, file), 'utf8')).join('\n');
  const asked = [...text.matchAll(/(?:getenv|environment)\("(\w+)"\)/g)].map(([, name]) => name);
  const listed = [...read(pages['galilean.1'].split('.SH ENVIRONMENT\n')[1].split('.SH')[0]).matchAll(/^\.TP\n(\w+)$/gm)].map(([, name]) => name);
  assert.ok(asked.length > 5);
  for (const name of asked) assert.ok(listed.includes(name), name);
  for (const name of listed) assert.ok(text.includes(`"${name}"`), name);
});

test('a program that is missing is named, and nothing is printed without it', (t) => {
  const alone = join(scratchFolder(t), 'galilean-manual');
  copyFileSync(`${galileanBinary}-manual`, alone);
  const { status, stdout, stderr } = spawnSync(alone, ['manual'], { encoding: 'utf8' });
  assert.deepEqual([status, stdout], [1, '']);
  assert.match(stderr, /^galilean-manual: \S+\/galilean-demo cannot be started: /);
});

test('a verb that there is not has no page', () => {
  const { status, stdout, stderr } = galilean(['manual', 'xyzzy']);
  assert.deepEqual([status, stdout], [2, '']);
  assert.match(stderr, /there is no verb 'xyzzy'/);
});
