/**
 * What the program says: one JSON line on standard output, everything else on standard error. Names come from files that
 * others wrote, so nothing reaches a terminal that it might obey.
 */
export function say(message: string): void {
  process.stderr.write(`${printable(message)}\n`);
}

/** The result. Only ASCII, so that no terminal and no reader of lines mistakes it. */
export function result(value: unknown): void {
  process.stdout.write(`${jsonLine(value)}\n`);
}

export function jsonLine(value: unknown): string {
  return JSON.stringify(value).replace(/[\u007f-\uffff]/g, escaped);
}

/** Control characters and marks that turn the direction of writing as escapes, line breaks as they are. */
export function printable(text: string): string {
  return [...text]
    .map((character) => (isUnsafe(character) ? [...character].map(escaped).join('') : character))
    .join('');
}

function isUnsafe(character: string): boolean {
  const code = character.charCodeAt(0);
  return (
    (code < 0x20 && character !== '\n') ||
    (code >= 0x7f && code < 0xa0) ||
    (code >= 0x200b && code <= 0x200f) ||
    (code >= 0x2028 && code <= 0x202e) ||
    (code >= 0x2066 && code <= 0x2069)
  );
}

function escaped(character: string): string {
  return `\\u${character.charCodeAt(0).toString(16).padStart(4, '0')}`;
}

/** ms before the first word about how far it is, and between words */
const PATIENCE = 2000;

/** Says how far long work is, every two seconds; short work stays silent. */
export function progress(
  doing: string,
  total: number,
  now = () => performance.now(),
): (done: number) => void {
  let last = now();
  return (done) => {
    if (now() - last < PATIENCE || done === total) return;
    last = now();
    say(`rotund: ${doing}: ${done} of ${total}`);
  };
}
