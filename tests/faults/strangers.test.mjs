// SPDX-License-Identifier: BSD-3-Clause
import { group } from './rows/strangers.mjs';
import { testGroup } from './table.mjs';

testGroup(group);
