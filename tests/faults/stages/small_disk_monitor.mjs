// SPDX-License-Identifier: BSD-3-Clause
import { appendFileSync, mkdirSync, readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { galileanBinary } from '../../end_to_end/tools.mjs';
import { start } from '../../logs/tools.mjs';
import { until } from '../table.mjs';
import { Monitor } from './monitor.mjs';
import { closeOf, endChild } from './children.mjs';
import { onSmallDisk } from './namespaces.mjs';

/** The monitor keeps 8 MB of it back, and takes them again where 24 MB are free. */
const DISK_kB = 48_000;
/** The disk is filled by large pieces first. */
const PIECE = Buffer.alloc(1 << 20, 'x');

/** A monitor whose data folder is a small disk, which only it sees. */
export class MonitorOnSmallDisk extends Monitor {
  async start() {
    this.data = join(this.cwd, 'disk');
    mkdirSync(this.data, { recursive: true });
    const [command, ...args] = onSmallDisk(this.data, DISK_kB,
      [galileanBinary, 'monitor', '--listen', `127.0.0.1:${this.port}`, '--data', this.data]);
    this.child = start(command, args, { cwd: this.cwd, env: { ...process.env, ROS_DOMAIN_ID: this.domain, ...this.env } });
    const closed = closeOf(this.child);
    this.scope.after(() => endChild(this.child, closed));
    await until(() => /http:\/\/[0-9.]+:\d+/.test(this.child.text), () => `the monitor to serve; it said ${this.child.text}`);
  }

  /** Where this process sees its disk. */
  get disk() {
    return `/proc/${this.child.pid}/root${this.data}`;
  }

  token(name = 'operator') {
    return readFileSync(join(this.disk, `${name}.token`), 'utf8').trim();
  }

  fill() {
    for (let size = PIECE.length; size >= 1; size = Math.floor(size / 2)) {
      try {
        for (;;) appendFileSync(join(this.disk, 'filler'), PIECE.subarray(0, size));
      } catch (error) {
        if (error.code !== 'ENOSPC') throw error;
      }
    }
  }

  empty() {
    rmSync(join(this.disk, 'filler'), { force: true });
  }
}
