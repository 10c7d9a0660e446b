export function moduleOf(files: readonly { name: string; schema: string; text: string }[]): string;
