// SPDX-License-Identifier: BSD-3-Clause
// All groups of faults, in the order of docs/RELIABILITY.md.
import { group as clients } from './rows/clients.mjs';
import { group as clock } from './rows/clock.mjs';
import { group as disk } from './rows/disk.mjs';
import { group as held } from './rows/held.mjs';
import { group as motors } from './rows/motors.mjs';
import { group as network } from './rows/network.mjs';
import { group as process } from './rows/process.mjs';
import { group as strangers } from './rows/strangers.mjs';

export const groups = [motors, held, process, network, disk, clock, strangers, clients];
