/** What `src` names is read once, by the last one who asked; what goes wrong is told, and nothing is thrown. */
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import type { Drawing } from '../../src/document/drawing.ts';
import { EMPTY_DRAWING } from '../../src/document/drawing.ts';
import { FileError, serialize } from '../../src/document/serialize.ts';
import { Source } from '../../src/element/source.ts';

const TEXT = serialize({ ...EMPTY_DRAWING, name: '' });

let opened: Drawing[];
let errors: unknown[];
let wanted: boolean;
let skipped: number;
let source: Source;
/** answers of the server, by path */
let answers: Record<string, () => Promise<Response>>;

beforeEach(() => {
  opened = [];
  errors = [];
  answers = { '/pear.rotund': async () => new Response(TEXT) };
  wanted = true;
  skipped = 0;
  source = new Source({
    wanted: async () => wanted,
    skipped: () => void skipped++,
    opened: (drawing) => opened.push(drawing),
    failed: (error) => errors.push(error),
  });
  vi.stubGlobal('document', { baseURI: 'http://page.test/folder/' });
  vi.stubGlobal('fetch', (url: URL, { signal }: RequestInit) => {
    const answer = answers[url.pathname]?.() ?? Promise.reject(new TypeError('Failed to fetch'));
    const stopped = new Promise<never>((_, reject) => {
      signal?.addEventListener('abort', () => reject(signal.reason));
    });
    return Promise.race([answer, stopped]);
  });
});

afterEach(() => vi.unstubAllGlobals());

describe('a source', () => {
  it('is resolved against the page and gives a drawing its name', async () => {
    answers['/folder/a%20pear.rotund'] = async () => new Response(TEXT);
    source.open('a%20pear.rotund?version=2#top', true);
    expect(source.busy).toBe(true);
    await source.settled;
    expect(source.busy).toBe(false);
    expect(opened.map(({ name }) => name)).toEqual(['a pear']);
  });

  it('tells what is missing, refused, or no drawing', async () => {
    answers['/none.rotund'] = async () => new Response('', { status: 404 });
    answers['/list.rotund'] = async () => new Response('{"format": 7}');
    for (const address of ['/none.rotund', '/list.rotund', '/unreachable.rotund', 'http://[']) {
      source.open(address, true);
      await source.settled;
    }
    expect(errors.every((error) => error instanceof FileError)).toBe(true);
    expect(errors.map((error) => (error as FileError).file)).toEqual([
      '/none.rotund',
      'list.rotund',
      '/unreachable.rotund',
      'http://[',
    ]);
    expect(String(errors[0])).toContain('404');
    expect(opened).toEqual([]);
  });

  it('that changes is the last one that was asked for', async () => {
    let answerSlow = (_: Response) => {};
    answers['/slow.rotund'] = () =>
      new Promise((resolve) => {
        answerSlow = resolve;
      });
    source.open('/slow.rotund', true);
    const first = source.settled;
    source.open('/pear.rotund', true);
    answerSlow(new Response('too late'));
    await Promise.all([first, source.settled]);
    expect(opened.map(({ name }) => name)).toEqual(['pear']);
    expect(errors).toEqual([]);
  });

  it('waits while it is on no page, and begins anew after it was interrupted', async () => {
    source.open('/pear.rotund', false);
    expect(source.busy).toBe(false);
    source.resume();
    source.pause();
    await source.settled;
    expect(opened).toEqual([]);
    source.resume();
    await source.settled;
    expect(opened).toHaveLength(1);
    source.resume();
    expect(source.busy).toBe(false);
  });

  it('that something else took the place of is not read when the element comes back', async () => {
    source.open('/pear.rotund', true);
    source.forget();
    source.resume();
    await source.settled;
    expect(opened).toEqual([]);
  });

  it('is not read where the page has kept something', async () => {
    wanted = false;
    source.open('/pear.rotund', true);
    await source.settled;
    source.resume();
    await source.settled;
    expect([opened, skipped, source.busy]).toEqual([[], 1, false]);
  });
});
