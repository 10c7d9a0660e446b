// SPDX-License-Identifier: BSD-3-Clause
// Browsers have it; Node 18 does not without being told.
import { webcrypto } from "node:crypto";

globalThis.crypto ??= webcrypto as Crypto;
