// SPDX-License-Identifier: BSD-3-Clause
export const IDL_FOLDER: URL;
export function schemaOf(type: string): string;
export function packages(): string[];
export function textOf(name: string): string;
