// SPDX-License-Identifier: BSD-3-Clause
// node with_domain.mjs COMMAND…: runs it with a ROS_DOMAIN_ID that no other test on this machine uses, and with
// GALILEAN_TEST_DOMAIN, by which it knows that.
import { spawn } from 'node:child_process';
import { freshDomain } from './domain.mjs';

const [command, ...args] = process.argv.slice(2);
const domain = freshDomain();
const child = spawn(command, args, { stdio: 'inherit', env: { ...process.env, ROS_DOMAIN_ID: domain, GALILEAN_TEST_DOMAIN: domain } });
for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP']) process.on(signal, () => child.kill(signal));
child.on('exit', (code, signal) => { process.exitCode = code ?? (signal ? 1 : 0); });
