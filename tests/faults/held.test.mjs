// SPDX-License-Identifier: BSD-3-Clause
import { group } from './rows/held.mjs';
import { testGroup } from './table.mjs';

testGroup(group);
