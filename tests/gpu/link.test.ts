import { afterAll, describe, expect, it } from 'vitest';
import { compile, link, ShaderError } from '../../src/gpu/link.ts';
import { withDevice } from './compute.ts';
import { closeDawn, describeGpu } from './dawn.ts';

afterAll(closeDawn);

describe('link', () => {
  const modules = {
    entry: '#import b\n#import a\nfn main() {}',
    a: '// a\n#import shared\nfn a() {}',
    b: '#import shared\nfn b() {}',
    shared: 'fn shared() {}',
  };

  it('puts each module once, dependencies first, without the directives', () => {
    expect(link(modules, 'entry').code).toBe('fn shared() {}\nfn b() {}\n// a\nfn a() {}\nfn main() {}');
  });

  it('knows the file and line of each line', () => {
    const { locate } = link(modules, 'entry');
    expect([1, 2, 3, 4, 5].map(locate)).toEqual([
      'shared.wgsl:1',
      'b.wgsl:2',
      'a.wgsl:1',
      'a.wgsl:3',
      'entry.wgsl:3',
    ]);
  });

  it('names the importer of what does not exist', () => {
    expect(() => link({ entry: '#import kernel/none' }, 'entry')).toThrow(
      'entry.wgsl imports kernel/none, which does not exist',
    );
    expect(() => link({}, 'entry')).toThrow('there is no WGSL module entry');
  });

  it('refuses a circle and tells it', () => {
    const circle = { entry: '#import a', a: '#import b', b: '#import a' };
    expect(() => link(circle, 'entry')).toThrow('entry → a → b → a');
  });
});

describeGpu('compile', () => {
  const entry = '#import kernel/broken\n@compute @workgroup_size(1) fn main() { broken(); }';
  const broken = '// fine\nfn broken() -> f32 {\n  return nothing_of_that_name;\n}';

  it('says in which file and line the mistake is', async () => {
    await withDevice(async (device) => {
      const linked = link({ entry, 'kernel/broken': broken }, 'entry');
      const failure = compile(device, 'broken', linked);
      await expect(failure).rejects.toThrow(ShaderError);
      await expect(failure).rejects.toThrow(/^kernel\/broken\.wgsl:3: .*nothing_of_that_name/);
    });
  });

  it('gives the module of what has none', async () => {
    await withDevice(async (device) => {
      const right = broken.replace('nothing_of_that_name', '1.0').replace('fine', 'right');
      const linked = link(
        { entry: entry.replace('broken();', '_ = broken();'), 'kernel/broken': right },
        'entry',
      );
      expect((await compile(device, 'right', linked)).label).toBe('right');
    });
  });
});
