// SPDX-License-Identifier: BSD-3-Clause
import { createServer } from 'node:net';

/** A port of 127.0.0.1 at which nobody listens now. */
export function freePort() {
  return new Promise((resolve, reject) => {
    const server = createServer().on('error', reject).listen(0, '127.0.0.1', () => {
      const { port } = server.address();
      server.close(() => resolve(port));
    });
  });
}
