// SPDX-License-Identifier: BSD-3-Clause
// A crowd of viewers of a monitor, by tests/bench/crowd_bench.cpp.
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { setTimeout as sleep } from 'node:timers/promises';
import { connect as connectFoxglove } from '../../end_to_end/foxglove_client.mjs';
import { program } from '../../logs/tools.mjs';
import { within } from '../../tools/patience.mjs';
import { Scope } from '../table.mjs';

export const VIEWERS = 1000, STALLED = 100;
const WATCHED_S = 1;
const CROWD_WITHIN_MS = 60_000;
const HIGH_FILE_LIMIT = 4096;
const COSTLY = ['sensor_msgs/msg/CompressedImage', 'visualization_msgs/msg/MarkerArray'];

/** The channels of what is live, but for pictures and markers. */
export async function channels(stage) {
  const scope = new Scope();
  const { heard, channel } = connectFoxglove(scope, stage.monitor.url, { token: stage.monitor.token() });
  await channel('/io/state');
  await sleep(1000); // for what is advertised after that
  const ids = heard.advertise.flat().filter(({ schemaName }) => !COSTLY.includes(schemaName)).map(({ id }) => String(id));
  await scope.end();
  return ids;
}

/** What crowd_bench measures. Its own files need a high limit, whatever this process has. */
export async function crowd(stage, ids) {
  const child = spawn('bash', ['-c', `ulimit -n ${HIGH_FILE_LIMIT}; exec "$@"`, 'bash', program('crowd_bench'),
    String(stage.monitor.port), `${VIEWERS}:${STALLED}`, String(WATCHED_S), ...ids], { stdio: ['ignore', 'pipe', 'pipe'] });
  let said = '', problem = '';
  child.stdout.on('data', (data) => { said += data; });
  child.stderr.on('data', (data) => { problem += data; });
  await within(once(child, 'close'), () => 'the end of crowd_bench', CROWD_WITHIN_MS).catch((late) => {
    child.kill('SIGKILL');
    throw late;
  });
  if (!said) throw new Error(`crowd_bench failed: ${problem}`);
  return JSON.parse(said);
}
