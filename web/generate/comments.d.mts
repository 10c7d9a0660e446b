export function commentsOf(text: string): Map<string, string>;
