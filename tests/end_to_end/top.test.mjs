// SPDX-License-Identifier: BSD-3-Clause
// galilean top on a real terminal (tmux's), with a robot that obeys and a monitor that pushes.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { eventually, galilean, galileanBinary, startMonitor } from './tools.mjs';

/** Goes round three states, a second each, without board and camera. */
const program = `
variables:
  bits: name: "time"
end
perceptual_schemas:
  time_detector: name: "clock" bits_variable: "time" duration: 1 end
end
states:
  state: name: "a" perceptual_schemas: "clock" end
    condition: bits_variable: "time" bit_index: 0 bit_value: 1 new_state: "b" end
  end
  state: name: "b" perceptual_schemas: "clock" end
    condition: bits_variable: "time" bit_index: 0 bit_value: 1 new_state: "c" end
  end
  state: name: "c" perceptual_schemas: "clock" end
    condition: bits_variable: "time" bit_index: 0 bit_value: 1 new_state: "a" end
  end
end
`;
const env = { ...process.env, USER: 'anna', LC_ALL: 'C.UTF-8' };

/** A shell on a terminal of its own, which is gone with the test. */
function openTerminal(t, columns, rows) {
  const name = `galilean-${process.pid}`;
  const tmux = (...words) => execFileSync('tmux', ['-L', name, ...words], { env, encoding: 'utf8' });
  t.after(() => spawnSync('tmux', ['-L', name, 'kill-server']));
  tmux('-f', '/dev/null', 'new-session', '-d', '-x', String(columns), '-y', String(rows), 'sh');
  const screen = () => tmux('capture-pane', '-p');
  const press = (...keys) => tmux('send-keys', ...keys);
  return {
    screen,
    press,
    /** Leaves what shows the pattern. A key right behind Escape would be taken for one with Alt. */
    leave: async (pattern) => {
      press('Escape');
      await eventually(() => !pattern.test(screen()));
    },
    resize: (x, y) => tmux('resize-window', '-x', String(x), '-y', String(y)),
    shows: (pattern) => eventually(() => pattern.exec(screen())).catch((late) => {
      throw new Error(`${late.message}\nThe screen did not show ${pattern}:\n${screen()}`);
    }),
  };
}

test('a robot is stopped, stepped, tuned and given an earlier program from a terminal', { timeout: 300_000 }, async (t) => {
  const { domain, cwd, url } = await startMonitor(t);
  writeFileSync(join(cwd, 'round.bhdl'), program);
  const way = ['--monitor', url, '--token-file', join(cwd, 'operator.token')];
  const pushed = galilean(['swap', 'round.bhdl', '--robot', 'io', ...way], { cwd, env: { USER: 'anna' } });
  assert.equal(pushed.status, 0, pushed.stdout + pushed.stderr);
  const { screen, press, leave, resize, shows } = openTerminal(t, 80, 24);
  press(`'${galileanBinary}' top --domain ${domain} ${way.map((word) => `'${word}'`).join(' ')}; echo code $?`, 'Enter');
  await shows(/▶.?I +io[^]*STATES[^]*q quit/);

  await t.test('a break point on entering a state stops the robot, which says why', async () => {
    press('J', 'K', 'K', 'K');
    await shows(/\[a\]/);
    press('b');
    await shows(/● io: stopped at c -> a \(anna's break point\) +n step {2}r go on/);
    await shows(/▶●\[a\]/);
    await shows(/io +a stopped/);
  });

  await t.test('steps lead from one change of state to the next', async () => {
    press('n');
    await shows(/● io: stepped into b/);
    press('n');
    await shows(/● io: stepped into c/);
  });

  await t.test('a break point that is made a lock keeps the robot until it is let through', async () => {
    press('B');
    await shows(/Break points of io[^]*▶ ● stop +on entering a/);
    press('t');
    await shows(/▶ ● stop team +on entering a/);
    press('t');
    await shows(/▶ ■ lock +on entering a/);
    await leave(/Break points of io/);
    press('r');
    await shows(/Resume io\? y \/ n/);
    press('y');
    await shows(/■ io: waits at the lock c -> a for \d+ s +B let through/);
    press('B');
    await shows(/▶ ■ lock +on entering a {2}the robot waits here/);
    press('l');
    await shows(/io opens the lock once/);
    press('C');
    await shows(/It has none\. J and K choose a state/);
    await leave(/Break points of io/);
    assert.doesNotMatch(screen(), /waits at the lock/);
  });

  await t.test('what the robot refuses is told', async () => {
    press('h');
    await shows(/io +[abc] held/);
    press('n');
    await shows(/io refused: io is held by anna, not at a break point: resume it first/);
    press('r', 'y');
    await shows(/told io to resume/);
  });

  await t.test('it is taken out of service and back', async () => {
    press('d');
    await shows(/Decommission io, so that it stands until it is commissioned\? y \/ n/);
    press('y');
    await shows(/io +[abc] out of service/);
    press('d', 'y');
    await eventually(() => !/out of service/.test(screen()));
  });

  resize(130, 40);
  await t.test('a threshold is moved, and the robot keeps it', async () => {
    press('g');
    await shows(/Gains of io[^]*▶ clock · duration +1 s +─+●─+ {2}0 to 5/);
    press('Right');
    await shows(/▶ clock · duration +1\.05 s .* runs 1\n/);
    press('Enter');
    await shows(/Gains of io: (runs, on probation|taken)/);
    await shows(/▶ clock · duration +1\.05 s +─+●─+ {2}0 to 5/);
    await leave(/Gains of io/);
  });

  await t.test('what was pushed is listed, compared and pushed again', async () => {
    press('w');
    await shows(/Pushed by anna \(clock · duration 1 → 1\.05\) to io: io (running|confirmed)/);
    await shows(/ago +[0-9a-f]{8} +round\.bhdl +anna .* runs now +to io/);
    press('Down');
    await shows(/Pushed by anna to io: io/);
    press('Enter');
    await shows(/1 difference from what runs now:[^]*duration[^]*Push to io\? {2}y yes/);
    press('y');
    await shows(/Push of round\.bhdl [0-9a-f]{8}: done/);
    await leave(/Push of round/);
    press('g');
    await shows(/▶ clock · duration +1 s /);
    await leave(/Gains of io/);
    press('q');
    await shows(/code 0/);
  });
});
