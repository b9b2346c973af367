import { describe, expect, it } from 'vitest';
import { Arrival } from '../../src/element/arrival.ts';

describe('an arrival', () => {
  it('answers those who waited and those who come later', async () => {
    const arrival = new Arrival<string>();
    const waiting = [arrival.get(), arrival.get()];
    arrival.come('scene');
    expect(await Promise.all([...waiting, arrival.get()])).toEqual(['scene', 'scene', 'scene']);
  });

  it('that went is waited for again', async () => {
    const arrival = new Arrival<string>();
    arrival.come('first');
    arrival.go();
    const next = arrival.get();
    arrival.come('second');
    expect(await next).toBe('second');
  });

  it('that will not come disappoints everybody until it is expected again', async () => {
    const arrival = new Arrival<string>();
    const waiting = arrival.get();
    arrival.fail(new Error('no scene'));
    await expect(waiting).rejects.toThrow('no scene');
    await expect(arrival.get()).rejects.toThrow('no scene');
    arrival.go();
    const next = arrival.get();
    arrival.come('after all');
    expect(await next).toBe('after all');
  });
});
