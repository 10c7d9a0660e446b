// SPDX-License-Identifier: BSD-3-Clause
// DDS domains for tests that run beside a team, beside one another and beside those of another checkout.
import { spawnSync } from 'node:child_process';
import { closeSync, constants, openSync } from 'node:fs';

// As tests/free_domain.h. From 102 on a domain's ports may be taken by whoever asks the system for any port.
const FIRST = 20, COUNT = 80;

let next = process.pid % COUNT;

/** Whether the domain is this process's now, for as long as it lives. */
function taken(domain) {
  let lock;
  try {
    lock = openSync(`/tmp/galilean-domain-${domain}`, constants.O_RDONLY | constants.O_CREAT, 0o644);
  } catch { return false; } // another user's
  const { status } = spawnSync('flock', ['--nonblock', '3'], { stdio: ['ignore', 'ignore', 'inherit', lock] });
  if (status !== 0) closeSync(lock);
  return status === 0;
}

/** A DDS domain that no other test on this machine uses. */
export function freshDomain() {
  for (let tried = 0; tried < COUNT; ++tried) {
    const domain = FIRST + (next++ % COUNT);
    if (String(domain) !== process.env.ROS_DOMAIN_ID && taken(domain)) return String(domain);
  }
  throw new Error(`tests hold all DDS domains from ${FIRST} to ${FIRST + COUNT - 1}: see who holds /tmp/galilean-domain-*`);
}
