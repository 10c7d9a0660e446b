// SPDX-License-Identifier: BSD-3-Clause
import { lezer } from "@lezer/generator/rollup";
import type { Plugin } from "vite";

/** Makes a parser of what is imported from a .grammar; before Vite takes the file for a script. */
export const grammars = (): Plugin => ({ ...lezer(), enforce: "pre" });
