// SPDX-License-Identifier: BSD-3-Clause
// The language server as an editor meets it: the real executable, spoken to by Microsoft's client library.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { copyFileSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { within } from '../tools/patience.mjs';
import { galileanBinary, programs, root, scratchFolder } from './tools.mjs';

const require = createRequire(`${root}tests/node/`);
const { createProtocolConnection, StreamMessageReader, StreamMessageWriter } = require('vscode-languageserver-protocol/node');

const capabilities = {
  general: { positionEncodings: ['utf-16'] },
  textDocument: {
    completion: { completionItem: { snippetSupport: true } },
    hover: { contentFormat: ['markdown'] },
    documentSymbol: { hierarchicalDocumentSymbolSupport: true },
    publishDiagnostics: { relatedInformation: true, versionSupport: true },
  },
};

/** An editor with a server of its own, in a folder with the programs that ship. */
class Editor {
  constructor(t) {
    this.folder = scratchFolder(t);
    for (const name of readdirSync(programs)) copyFileSync(`${programs}/${name}`, `${this.folder}/${name}`);
    this.process = spawn(galileanBinary, ['bhdl', 'lsp'], { stdio: ['pipe', 'pipe', 'inherit'] });
    this.ended = new Promise((resolve) => this.process.on('exit', resolve));
    this.connection = createProtocolConnection(new StreamMessageReader(this.process.stdout), new StreamMessageWriter(this.process.stdin));
    this.published = new Map();
    this.waiting = [];
    this.connection.onNotification('textDocument/publishDiagnostics', (params) => {
      this.published.set(params.uri, params);
      this.waiting = this.waiting.filter((look) => !look());
    });
    this.connection.listen();
    t.after(() => this.process.kill());
  }

  get exited() {
    return within(this.ended, () => "the server's end");
  }

  request(method, params) {
    return within(this.connection.sendRequest(method, params), () => `an answer to ${method}`);
  }

  async start() {
    const answer = await this.request('initialize', { processId: process.pid, rootUri: null, capabilities });
    await this.connection.sendNotification('initialized', {});
    return answer;
  }

  uri(name) {
    return pathToFileURL(`${this.folder}/${name}`).href;
  }

  async open(name, text = readFileSync(`${this.folder}/${name}`, 'utf8')) {
    this.name = name;
    this.text = text;
    this.version = 1;
    await this.connection.sendNotification('textDocument/didOpen', {
      textDocument: { uri: this.uri(name), languageId: 'bhdl', version: 1, text },
    });
  }

  /** The place of `here`, the first behind `after`, in the file opened last. */
  place(here, after = '') {
    const offset = this.text.indexOf(here, this.text.indexOf(after));
    assert.ok(offset >= 0, here);
    const lines = this.text.slice(0, offset).split('\n');
    return { line: lines.length - 1, character: lines.at(-1).length };
  }

  ask(method, params = {}) {
    return this.request(`textDocument/${method}`, { textDocument: { uri: this.uri(this.name) }, ...params });
  }

  /** Puts `text` in before `here`, as typing does. */
  async type(text, here, after) {
    const at = this.place(here, after);
    const offset = this.text.indexOf(here, this.text.indexOf(after ?? ''));
    this.text = this.text.slice(0, offset) + text + this.text.slice(offset);
    this.version += 1;
    await this.connection.sendNotification('textDocument/didChange', {
      textDocument: { uri: this.uri(this.name), version: this.version },
      contentChanges: [{ range: { start: at, end: at }, text }],
    });
    return { line: at.line, character: at.character + text.length };
  }

  /** The diagnostics of a file's newest version, once they suit. */
  problems(name, suit) {
    return within(new Promise((resolve) => {
      const look = () => {
        const params = this.published.get(this.uri(name));
        const newest = params && (name !== this.name || params.version === this.version);
        if (newest && suit(params.diagnostics)) resolve(params.diagnostics);
        return newest && suit(params.diagnostics);
      };
      if (!look()) this.waiting.push(look);
    }), () => `problems of ${name} that suit; published were ${JSON.stringify(this.published.get(this.uri(name)))}`);
  }
}

async function editing(t, name, text) {
  const editor = new Editor(t);
  await editor.start();
  await editor.open(name, text);
  return editor;
}

const none = (problems) => problems.length === 0;
const labels = ({ items }) => items.map(({ label }) => label);

/** A text after edits, which do not overlap. */
function applied(text, edits) {
  const lines = text.split('\n');
  const offset = ({ line, character }) => lines.slice(0, line).reduce((sum, each) => sum + each.length + 1, 0) + character;
  return [...edits].sort((a, b) => offset(b.range.start) - offset(a.range.start))
    .reduce((now, { range, newText }) => now.slice(0, offset(range.start)) + newText + now.slice(offset(range.end)), text);
}

test('it says what it can, and ends as it should', async (t) => {
  const editor = new Editor(t);
  const { capabilities: can } = await editor.start();
  assert.equal(can.positionEncoding, 'utf-16');
  assert.equal(can.textDocumentSync.change, 2);
  await assert.rejects(editor.request('textDocument/nonsense', {}), { code: -32601 });
  await editor.request('shutdown');
  await editor.connection.sendNotification('exit');
  assert.equal(await editor.exited, 0);
});

test('problems come and go as one types, each with its file', async (t) => {
  const editor = await editing(t, 'sit_and_spin.bhdl');
  await editor.problems('sit_and_spin.bhdl', none);
  await editor.type('include "parts.bhdl"\n', 'include');
  const [missing] = await editor.problems('sit_and_spin.bhdl', (all) => all.length > 0);
  assert.equal(missing.code, 'include/not-found');
  await editor.open('parts.bhdl', 'variables: bist: name: "mine" end\n');
  const [unknown] = await editor.problems('parts.bhdl', (all) => all.length > 0);
  assert.equal(unknown.code, 'name/unknown-component');
  assert.match(unknown.message, /did you mean 'bits'/);
});

test('what was meant is a fix', async (t) => {
  const editor = await editing(t, 'parts.bhdl', 'variables: bist: name: "mine" end\n');
  const range = { start: { line: 0, character: 0 }, end: { line: 1, character: 0 } };
  const [fix] = await editor.ask('codeAction', { range, context: { diagnostics: [] } });
  assert.equal(applied(editor.text, fix.edit.changes[editor.uri('parts.bhdl')]), 'variables: bits: name: "mine" end\n');
});

test('completion knows the robot, and the names that are included', async (t) => {
  const editor = await editing(t, 'follow_the_red.bhdl', 'include "office_robot.bhdl"\nmotor_schemas:\n  avoid_obstacle:\n    shaft_variable: HERE\n');
  const offered = await editor.ask('completion', { position: editor.place('HERE') });
  assert.deepEqual(labels(offered), ['shaft']);
  const at = editor.place('  avoid_obstacle');
  assert.ok(labels(await editor.ask('completion', { position: at })).includes('move_robot'));
  const attributes = await editor.ask('completion', { position: editor.place('shaft_variable') });
  assert.ok(labels(attributes).includes('max_sphere'));
});

test('hover tells the law, the unit and what declares a name', async (t) => {
  const editor = await editing(t, 'office_robot.bhdl');
  const told = async (...where) => (await editor.ask('hover', { position: editor.place(...where) })).contents.value;
  assert.match(await told('avoid_obstacle'), /\*\*avoid_obstacle\*\*, motor schema/);
  assert.match(await told('max_sphere', 'avoid_obstacle'), /a number in cm/);
  assert.match(await told('gripper"', 'gripper_scanner:'), /0: the beam is broken/);
  assert.match(await told('0', 'bit_index: '), /written by/);
});

test('definition and references cross files', async (t) => {
  const editor = await editing(t, 'sit_and_spin.bhdl');
  const position = editor.place('wander_for_trash', 'state:');
  const references = await editor.ask('references', { position, context: { includeDeclaration: true } });
  const files = new Set(references.map(({ uri }) => uri));
  assert.ok(files.has(editor.uri('office_states.bhdl')));
  await editor.open('office_states.bhdl');
  const [declared] = await editor.ask('definition', { position: editor.place('gripper"', 'bits_variable') });
  assert.equal(declared.uri, editor.uri('office_robot.bhdl'));
});

test('a name is changed in every file, and the programs stay right', async (t) => {
  const editor = await editing(t, 'office_robot.bhdl');
  const position = editor.place('gripper"', 'bits:');
  assert.equal((await editor.ask('prepareRename', { position })).placeholder, 'gripper');
  const { changes } = await editor.ask('rename', { position, newName: 'hand' });
  assert.ok(Object.keys(changes).length >= 2);
  for (const [uri, edits] of Object.entries(changes)) {
    const file = new URL(uri);
    writeFileSync(file, applied(readFileSync(file, 'utf8'), edits));
  }
  await editor.open('office_cleanup.bhdl');
  await editor.open('office_robot.bhdl');
  await editor.problems('office_cleanup.bhdl', none);
  await assert.rejects(editor.ask('rename', { position: editor.place('stuck"', 'bits:'), newName: 'hand' }), /already/);
});

test('symbols, folds and the one layout', async (t) => {
  const editor = await editing(t, 'office_states.bhdl');
  const symbols = await editor.ask('documentSymbol');
  assert.deepEqual(symbols.map(({ name }) => name), ['states']);
  assert.ok(symbols[0].children.some(({ name }) => name === 'move_to_trash'));
  assert.ok((await editor.ask('foldingRange')).length > 20);
  const laidOut = editor.text;
  assert.deepEqual(await editor.ask('formatting', { options: { tabSize: 2, insertSpaces: true } }), []);
  await editor.type('      ', 'name: "start"');
  assert.equal(applied(editor.text, await editor.ask('formatting', { options: { tabSize: 2, insertSpaces: true } })), laidOut);
});
