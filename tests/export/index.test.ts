/** What every exporter must do: the same solid in every format, the same bytes twice, no number that is none. */
import { describe, expect, it } from 'vitest';
import { ExportError, type Exporter, exporters, type Model, modelOf } from '../../src/export/index.ts';
import { area, bounds, volume } from '../../src/mesh/measure.ts';
import { box } from '../mesh/solids.ts';
import { BALL_AND_TUBE, ballAndTube, EMPTY, namedBoxes, solidOf } from './models.ts';
import { cornersOf, type Measures, measured, readGlb, readObj, readPly, readStl } from './readers.ts';

const all: readonly Exporter[] = Object.values(exporters);

/** What is in the files of a model, in the format's unit. */
const readers: Readonly<Record<string, (files: readonly Uint8Array[]) => Measures>> = {
  obj: ([file, library]) => measured(readObj(file!, library!).flatMap(cornersOf)),
  glb: ([file]) => measured(readGlb(file!).flatMap(cornersOf)),
  stl: ([file]) => measured(readStl(file!).facets.map(({ corners }) => corners)),
  ply: ([file]) => measured(cornersOf(readPly(file!))),
};

describe('the model', () => {
  it('is the kept and visible parts', () => {
    expect(ballAndTube().solids.map(({ name }) => name)).toEqual(['Rotational 1', 'Tube 2']);
    const [ball, tube] = BALL_AND_TUBE.parts;
    const hidden = { ...BALL_AND_TUBE, parts: [{ ...ball!, hidden: true }, tube!] };
    expect(modelOf(hidden, '').solids.map(({ name }) => name)).toEqual(['Tube 2']);
    expect(modelOf(hidden, '').name).not.toBe('');
  });
});

describe.each(all.map((exporter) => [exporter.id, exporter] as const))('%s', (id, exporter) => {
  const read = async (model: Model): Promise<Measures> =>
    readers[id]!((await exporter.write(model)).map(({ bytes }) => bytes));

  it('is registered under its extension and says what it carries', async () => {
    expect(exporters[exporter.id]).toBe(exporter);
    const [file] = await exporter.write(ballAndTube());
    expect(file!.name).toBe(`ball and tube.${id}`);
    expect(exporter.carries).toMatch(/millimetres|metres/);
  });

  it('holds the same solids', async () => {
    const model = ballAndTube();
    const unit = exporter.carries.includes('millimetres') ? 1 : 1000;
    const found = await read(model);
    const meshes = model.solids.map(({ mesh }) => mesh);
    const sum = (of: (mesh: (typeof meshes)[0]) => number) =>
      meshes.reduce((total, mesh) => total + of(mesh), 0);
    expect(found.triangles).toBe(sum((mesh) => mesh.indices.length / 3));
    expect(Math.abs((found.volume * unit ** 3) / sum(volume) - 1)).toBeLessThan(1e-5);
    expect(Math.abs((found.area * unit ** 2) / sum(area) - 1)).toBeLessThan(1e-5);
    const boxes = meshes.map(bounds);
    [0, 1, 2].forEach((k) => {
      expect(Math.abs(found.min[k]! * unit - Math.min(...boxes.map(({ min }) => min[k]!)))).toBeLessThan(
        1e-4,
      );
      expect(Math.abs(found.max[k]! * unit - Math.max(...boxes.map(({ max }) => max[k]!)))).toBeLessThan(
        1e-4,
      );
    });
  });

  it('writes the same bytes again, also from a document that was stored', async () => {
    const first = await exporter.write(ballAndTube());
    const stored = JSON.parse(JSON.stringify(BALL_AND_TUBE)) as typeof BALL_AND_TUBE;
    const second = await exporter.write(modelOf(stored, 'ball and tube'));
    expect(second.map(({ name }) => name)).toEqual(first.map(({ name }) => name));
    second.forEach(({ bytes }, i) => {
      expect(Buffer.compare(bytes, first[i]!.bytes)).toBe(0);
    });
  });

  it('has no negative zero', async () => {
    const mesh = box(1, 1, 1);
    const signed = { ...mesh, positions: mesh.positions.map((x) => (x === 0 ? -0 : x)) };
    const [plain] = await exporter.write({ name: 'x', solids: [solidOf('box', mesh)] });
    const [found] = await exporter.write({ name: 'x', solids: [solidOf('box', signed)] });
    expect(Buffer.compare(found!.bytes, plain!.bytes)).toBe(0);
  });

  it('refuses what is no number, and names the part', async () => {
    for (const bad of [Number.NaN, Number.POSITIVE_INFINITY]) {
      const mesh = box(1, 1, 1);
      const solid = solidOf('broken', {
        ...mesh,
        positions: mesh.positions.map((x, i) => (i === 4 ? bad : x)),
      });
      const writing = exporter.write({ name: 'x', solids: [solidOf('sound'), solid] });
      await expect(writing).rejects.toThrow(ExportError);
      await expect(writing).rejects.toThrow('broken');
    }
  });

  it('of nothing is a file, and parts without triangles are left out', async () => {
    expect((await exporter.write(EMPTY))[0]!.bytes.length).toBeGreaterThan(0);
    const none = { ...box(1, 1, 1), indices: new Uint32Array() };
    const [found] = await exporter.write({ name: 'x', solids: [solidOf('none', none), solidOf('box')] });
    const [expected] = await exporter.write({ name: 'x', solids: [solidOf('box')] });
    expect(Buffer.compare(found!.bytes, expected!.bytes)).toBe(0);
  });

  it('takes time in proportion: 500 parts', async () => {
    const model = namedBoxes(Array.from({ length: 500 }, () => 'same'));
    const found = await read({ ...model, name: 'many' });
    expect(found.triangles).toBe(6000);
  }, 30_000);
});
