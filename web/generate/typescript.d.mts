// SPDX-License-Identifier: BSD-3-Clause
export function moduleOf(files: readonly { name: string; schema: string; text: string }[]): string;
