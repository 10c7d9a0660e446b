// SPDX-License-Identifier: BSD-3-Clause
export function commentsOf(text: string): Map<string, string>;
