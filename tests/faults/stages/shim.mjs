// SPDX-License-Identifier: BSD-3-Clause
// Sets the clock of processes, or lets their disk fail, by the library that tests/faults/fault_shim.cpp is.
import { closeSync, existsSync, openSync, writeSync } from 'node:fs';
import { join } from 'node:path';
import { testTool } from '../../logs/tools.mjs';

const LIBRARY = testTool('libfault_shim.so');
const WORD_BYTES = 8;
const CLOCK = 0, WRITE = 1, SYNC = 2;

/** Why no process can be harmed so; undefined where it can. */
export const noShim = () => (existsSync(LIBRARY) ? undefined : `${LIBRARY} is missing: build the tests without sanitizers`);

export class Shim {
  /** `files`: of which files writing may fail, by how their path begins. */
  constructor(scope, folder, name, files = '') {
    const file = join(folder, `${name}.shim`);
    this.file = openSync(file, 'w+');
    scope.after(() => closeSync(this.file));
    for (const word of [CLOCK, WRITE, SYNC]) this.#set(word, 0n);
    this.env = existsSync(LIBRARY) ? { LD_PRELOAD: LIBRARY, FAULT_SHIM: file, ...(files && { FAULT_SHIM_FILES: files }) } : {};
  }

  #set(word, value) {
    const bytes = Buffer.alloc(WORD_BYTES);
    bytes.writeBigInt64LE(value);
    writeSync(this.file, bytes, 0, WORD_BYTES, word * WORD_BYTES);
  }

  setClock(ahead_s) {
    this.#set(CLOCK, BigInt(Math.round(ahead_s * 1e9)));
  }

  /** Lets writing fail with this errno; 0: not. */
  failWriting(error) {
    this.#set(WRITE, BigInt(error));
  }

  failSyncing(error) {
    this.#set(SYNC, BigInt(error));
  }
}
