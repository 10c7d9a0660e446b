// SPDX-License-Identifier: BSD-3-Clause
// What `galilean` says of its verbs, of a word that it does not know, and how that ends.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { galilean, startMonitor } from './tools.mjs';

const listed = galilean(['help']).stdout.match(/^ {2}\S+( \S+)?(?= {2,})/gm).map((line) => line.trim());
const verbs = listed.filter((verb) => !['version', 'help'].includes(verb));

for (const verb of verbs)
  test(`${verb} --help names it as users type it, and no path`, () => {
    const { status, stdout, stderr } = galilean([...verb.split(' '), '--help']);
    assert.deepEqual([status, stderr], [0, '']);
    assert.match(stdout, new RegExp(`^Usage: galilean ${verb}( |$)`, 'm'));
    assert.doesNotMatch(stdout, /\/bin\//);
  });

for (const verb of verbs)
  test(`${verb} with an option that it does not have ends with 2 and says so`, () => {
    const { status, stdout, stderr } = galilean([...verb.split(' '), '--xyzzy']);
    assert.deepEqual([status, stdout], [2, '']);
    assert.equal(stderr, `galilean ${verb}: there is no option '--xyzzy'\n'galilean ${verb} --help' lists what there is.\n`);
  });

const misspelt = [
  ['stpo', /galilean: there is no 'stpo'; did you mean 'stop'\?/],
  ['log inof', /there is no command 'inof'; did you mean 'info'\?/],
  ['bhdl chekc x.bhdl', /there is no command 'chekc'; did you mean 'check'\?/],
  ['bhdl tset x.bhdl', /there is no command 'tset'; did you mean 'test'\?/],
  ['bhdl check --jsno x.bhdl', /galilean bhdl check: there is no option '--jsno'; did you mean '--json'\?/],
  ['demo --prot 8081', /there is no option '--prot'; did you mean '--port'\?/],
  ['programs lsit', /there is no command 'lsit'; did you mean 'list'\?/],
  ['demo --=x', /there is no option '--'/],
  ['hold --tema', /there is no option '--tema'; did you mean '--team'\?/],
  ['record --oot run.mcap', /there is no option '--oot'; did you mean '--out'\?/],
  ['xyzzy', /there is no 'xyzzy'; 'galilean help' lists what there is/],
  ['log xyzzy', /there is no command 'xyzzy'\n/],
  ['log slice --from 9 --to 3s --out x.mcap run.mcap', /galilean log slice: --to 3s is before --from 9s; a part begins before it ends\n/],
  ['log coverage --at-least 101 run.mcap', /101/],
  ['monitor --listen 0.0.0.0:8080', /galilean monitor: --listen 0\.0\.0\.0 is heard on the network, .* give --tls, too, or --plain if you trust that network\n/],
  ['monitor --tls --key /none.pem', /--certificate and --key belong together/],
  ['tokens add anna --role admin', /viewer/], ['tokens add anna --expires soon', /'soon' is not a valid time/],
  ['monitor --listen 127.0.0.1:0 --recordings /dev/null', /galilean monitor: --recordings \/dev\/null is no folder\n/],
];
for (const [words, said] of misspelt)
  test(`galilean ${words}`, () => {
    const { status, stdout, stderr } = galilean(words.split(' '));
    assert.deepEqual([status, stdout], [2, '']);
    assert.match(stderr, said);
  });

const endings = [
  ['', 2], ['demo --port 99999', 2], ['demo --port many', 2], ['log', 2], ['log info', 2], ['log check', 2],
  ['record', 2], ['robot', 2], ['swap x.bhdl', 2], ['bhdl graph --format png x.bhdl', 2], ['hold', 2], ['hold --team --robot io', 2],
  ['break', 2], ['break :', 2], ['break grab --lock --stop-team', 2], ['break grab --clear', 2], ['step', 2],
  ['break grab', 2], ['break --clear', 2],
  ['step --team --robot io', 2],
  ...['cat', 'csv', 'stats', 'plot --map'].map((verb) => [`log ${verb} --from 9 --to 3 /none.mcap`, 2]),
  ['log slice /none.mcap --out -', 1], ['log check /none.mcap --expect /none.expect --junit -', 1],
  ['log cat', 2], ['log cat --from 5x /none.mcap', 2], ['log diff /none.mcap', 2], ['log slice /none.mcap', 2],
  ['log check --live --for 0 --expect /none.expect', 2], ['log check --expect /none.expect', 2],
  ['log cat /none.mcap', 1], ['log verify /none.mcap', 1], ['log merge /none.mcap --out /none/out.mcap', 1],
  ['log diff /none.mcap /none.mcap', 2],
  ['log info /none.mcap', 1], ['log check /none.mcap --expect /none.expect', 1],
  ['replay /none.mcap', 1], ['bhdl check /none.bhdl', 1], ['robot --bhdl /none.bhdl', 1],
  ['programs list --monitor http://127.0.0.1:1', 1], ['programs diff a b --monitor http://127.0.0.1:1', 2],
  ['monitor --listen 127.0.0.1:0 --data /dev/null/none', 1],
  ['swap x.bhdl --team --monitor foo', 2], ['top --once --monitor foo', 2], ['programs list --monitor https://127.0.0.1:1', 1],
  ['programs list --monitor http://127.0.0.1:1 --ca /none.pem', 1], ['programs list --monitor https://127.0.0.1:1 --fingerprint AB', 2],
  ['programs list --monitor 127.0.0.1:1', 1],
  ['sim ctl rate 0', 2], ['sim ctl rate 21', 2], ['sim ctl step -1', 2], ['sim ctl push io 0 90', 2],
  ['wait io/state.tick>1 --timeout 3x', 2], ['wait io/state.tick>1 --timeout 0s', 2], ['swap x.bhdl --team --direct --timeout 0', 2],
  ["record --out /none/run.mcap --on ''", 2], ["record --out ''", 2], ["demo --record ''", 2], ["log check /none.mcap --expect ''", 2],
  ["replay /none.mcap --topic ''", 2], ["hold --robot ''", 2], ["swap /none.bhdl --robot ''", 2], ["demo --allow-origin ''", 2],
  ["log plot /none.mcap a.b --svg ''", 2], ["log rerun /none.mcap --bhdl ''", 2], ["sim --trace ''", 2],
  ['tokens', 2], ['tokens add', 2], ['tokens add anna --expires 0s', 2], ['tokens revoke', 2],
  ['team', 2], ['team keys', 2], ['team keys add', 2], ['team keys add io', 2], ['team keys add io --role king', 2],
  ['team keys add io --role robot --expires 0s', 2], ['team keys revoke', 2], ["team keys list --team ''", 2],
  ['team keys init --team /dev/null/none', 1], ['team keys add io --role robot --team /dev/null/none', 1],
  ['team keys renew io --team /dev/null/none', 1], ['team keys revoke io --team /dev/null/none', 1], ['team keys list --team /dev/null/none', 1],
  ['list --secure /dev/null/none', 2], ["list --secure ''", 2], ['list --secure /', 1],
  ['tokens add operator --data /dev/null/none', 1], ['tokens add a/b --data /dev/null/none', 1],
  ['tokens add anna --data /dev/null/none', 1], ['tokens revoke anna --data /dev/null/none', 1],
];
for (const [words, code] of endings)
  test(`galilean ${words} ends with ${code} and says why`, () => {
    const { status, stdout, stderr } = galilean(words.split(' ').filter(Boolean).map((word) => word === "''" ? '' : word));
    assert.equal(status, code, stdout + stderr);
    assert.notEqual(stderr, '');
  });

test('programs list says that nothing was pushed, and where that would be', async (t) => {
  const { url, cwd } = await startMonitor(t);
  const options = ['--monitor', url, '--token-file', `${cwd}/operator.token`];
  const { status, stdout, stderr } = galilean(['programs', 'list', ...options]);
  assert.deepEqual([status, stdout], [0, '']);
  assert.ok(stderr.startsWith(`galilean programs: no program was pushed yet through the monitor at ${url}. It looks in `), stderr);
  assert.match(stderr, /history\.sqlite/);
  assert.deepEqual(JSON.parse(galilean(['programs', 'list', '--json', ...options]).stdout).pushes, []);
});

test('programs orders lists none and programs verify finds a new history whole, and none where there is none', async (t) => {
  const { url, cwd } = await startMonitor(t);
  const orders = galilean(['programs', 'orders', '--monitor', url, '--token-file', `${cwd}/operator.token`]);
  assert.deepEqual([orders.status, orders.stdout], [0, '']);
  const whole = galilean(['programs', 'verify', '--data', cwd]);
  assert.equal(whole.status, 0, whole.stderr);
  assert.match(whole.stdout, /^The history is whole: 0 rows/);
  const none = galilean(['programs', 'verify', '--data', `${cwd}/nowhere`]);
  assert.equal(none.status, 3);
  assert.match(none.stderr, /^galilean programs: the history cannot be read.*nowhere/);
});
