/** The life of a scene against back ends that fail and die on demand, with a clock of its own. */
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { SceneLife, type SceneOwner } from '../../src/element/sceneLife.ts';
import type { SceneOptions } from '../../src/scene/index.ts';

/** A scene that can be lost, and knows whether it was given back. */
class FakeScene {
  readonly backend: 'WebGPU' | 'WebGL2';
  readonly canvas: object;
  readonly because: string | undefined;
  disposed = false;
  useless = false;
  lose: (reason: string) => void = () => {};
  readonly lost = new Promise<string>((resolve) => {
    this.lose = resolve;
  });

  constructor(canvas: object, { backend, because }: SceneOptions) {
    this.backend = backend === 'webgl2' ? 'WebGL2' : 'WebGPU';
    this.canvas = canvas;
    this.because = because;
  }

  dispose(): void {
    this.disposed = true;
  }
}

type Maker = (canvas: object, options: SceneOptions) => Promise<FakeScene>;
const works: Maker = async (canvas, options) => new FakeScene(canvas, options);
const fails: Maker = async (_canvas, { backend }) => Promise.reject(new Error(`no ${backend}`));

/** An element as far as the life of its scene goes. */
function element(make: { now: Maker }, backend: 'auto' | 'webgl2' = 'auto') {
  const said: string[] = [];
  const shown: FakeScene[] = [];
  let canvas = {};
  const owner: SceneOwner = {
    canvas: () => canvas as HTMLCanvasElement,
    freshCanvas: () => {
      canvas = {};
    },
    backend,
    fine: false,
    show: (scene) => {
      shown.push(scene as unknown as FakeScene);
      said.push(scene.backend);
    },
    lose: (reason) => said.push(`lost: ${reason}`),
    withoutScene: (error) => said.push(`none: ${(error as Error).message}`),
  };
  const createScene = (on: object, options?: SceneOptions) => make.now(on, options ?? {});
  const life = new SceneLife(owner, async () => ({ createScene: createScene as never }));
  const last = () => shown.at(-1) ?? expect.unreachable('no scene was shown');
  return { life, said, shown, last };
}

const settle = () => vi.advanceTimersByTimeAsync(3000);

beforeEach(() => {
  vi.useFakeTimers();
  vi.spyOn(console, 'warn').mockImplementation(() => {});
});
afterEach(() => {
  vi.useRealTimers();
  vi.restoreAllMocks();
});

describe('a scene', () => {
  it('that WebGPU refuses is WebGL2’s, on a canvas of its own, and knows why', async () => {
    const make: Maker = (canvas, options) => (options.backend === 'auto' ? fails : works)(canvas, options);
    const tried: object[] = [];
    const { life, said, last } = element({
      now: (canvas, options) => {
        tried.push(canvas);
        return make(canvas, options);
      },
    });
    await life.open();
    expect(said).toEqual(['WebGL2']);
    expect(new Set(tried).size).toBe(2);
    expect(last().because).toBe('WebGPU failed: no auto');
  });

  it('that finds neither back end is none, without another try', async () => {
    let tries = 0;
    const { life, said } = element({
      now: async () => {
        tries++;
        throw Object.assign(new Error('nothing here'), { name: 'NoGraphicsError' });
      },
    });
    await life.open();
    expect(said).toEqual(['none: nothing here']);
    expect(tries).toBe(1);
  });

  it('that nobody can make is none, at once, and may be asked for again', async () => {
    const make = { now: fails };
    const { life, said } = element(make);
    await life.open();
    expect(said).toEqual(['none: no webgl2']);
    make.now = works;
    await life.open();
    expect(said.at(-1)).toBe('WebGPU');
  });

  it('that arrives after its element left is given back and never shown', async () => {
    const made: FakeScene[] = [];
    const { life, said } = element({
      now: async (canvas, options) => {
        const scene = await works(canvas, options);
        made.push(scene);
        return scene;
      },
    });
    const opening = life.open();
    await Promise.resolve();
    life.close();
    await opening;
    expect(said).toEqual([]);
    expect(made.every(({ disposed }) => disposed)).toBe(true);
  });

  it('of an element that left and came back at once is made once, on another canvas than before', async () => {
    const { life, said, shown } = element({ now: works });
    await life.open();
    life.close();
    void life.open();
    life.close();
    await life.open();
    await settle();
    expect(said).toEqual(['WebGPU', 'WebGPU']);
    expect(shown[0]?.canvas).not.toBe(shown[1]?.canvas);
  });

  it('whose loss arrives after its element left is not made anew', async () => {
    const { life, said, last } = element({ now: works });
    await life.open();
    life.close();
    last().lose('late');
    await settle();
    expect(said).toEqual(['WebGPU']);
  });
});

describe('a lost device', () => {
  it('is replaced, and so is the replacement when it was lost on the way', async () => {
    const { life, said, shown, last } = element({ now: works });
    await life.open();
    last().lose('one');
    await settle();
    last().lose('two');
    await settle();
    expect(said).toEqual(['WebGPU', 'lost: one', 'WebGPU', 'lost: two', 'WebGPU']);
    expect(new Set(shown.map(({ canvas }) => canvas)).size).toBe(3);
  });

  it('gives WebGL2 its turn after three losses in a minute, with words, and stays there', async () => {
    const { life, said, last } = element({ now: works });
    await life.open();
    for (const reason of ['one', 'two', 'three']) {
      last().lose(reason);
      await settle();
    }
    expect(last().backend).toBe('WebGL2');
    expect(last().because).toBe('WebGPU was lost 3 times: three');
    last().lose('four');
    await settle();
    expect(last().backend).toBe('WebGL2');
    expect(said.filter((word) => word.startsWith('lost'))).toHaveLength(4);
  });

  it('that cannot draw its first frame is not tried again', async () => {
    const { life, said, last } = element({ now: works });
    await life.open();
    last().useless = true;
    last().lose('it could not draw');
    await settle();
    expect(said).toEqual(['WebGPU', 'lost: it could not draw', 'WebGL2']);
    expect(last().because).toBe('WebGPU failed: it could not draw');
    last().useless = true;
    last().lose('nor this');
    await settle();
    expect(said.at(-1)).toBe('none: WebGL2 failed: nor this');
  });

  it('may be lost now and then for ever', async () => {
    const { life, last } = element({ now: works });
    await life.open();
    for (let i = 0; i < 12; i++) {
      await vi.advanceTimersByTimeAsync(30_000);
      last().lose('now and then');
      await settle();
    }
    expect(last().backend).toBe('WebGPU');
  });

  it('of WebGL2 alone, three times, ends in no picture in place of a loop', async () => {
    const { life, said, last } = element({ now: works }, 'webgl2');
    await life.open();
    for (const reason of ['one', 'two', 'three']) {
      last().lose(reason);
      await settle();
    }
    expect(said.at(-1)).toBe('none: WebGL2 was lost 3 times: three');
    expect(said.filter((word) => word === 'WebGL2')).toHaveLength(3);
  });

  it('is waited for a moment, since the browser may need one', async () => {
    const make = { now: works };
    const { life, said, last } = element(make, 'webgl2');
    await life.open();
    make.now = fails;
    last().lose('driver update');
    await vi.advanceTimersByTimeAsync(400);
    expect(said).toEqual(['WebGL2', 'lost: driver update']);
    make.now = works;
    await settle();
    expect(said).toEqual(['WebGL2', 'lost: driver update', 'WebGL2']);
  });
});
