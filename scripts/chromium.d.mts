export function findChromium(): string | null;
export const SOFTWARE_WEBGPU: string[];
export const QUIET: string[];
export function dawnEnvironment(chromium?: string | null): Record<string, string>;
