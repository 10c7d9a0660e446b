export function messagesModule(): string;
export function writeMessages(): void;
