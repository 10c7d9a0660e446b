// SPDX-License-Identifier: BSD-3-Clause
export function messagesModule(): string;
export function writeMessages(): void;
