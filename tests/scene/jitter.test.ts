/** A camera whose middle of the pixel is where rays went through: held against the rays themselves. */
import {
  OrthographicCamera,
  PerspectiveCamera,
  Vector3,
  WebGLCoordinateSystem,
  WebGPUCoordinateSystem,
} from 'three/webgpu';
import { beforeAll, describe, expect, it, vi } from 'vitest';
import { FRONT_VIEW } from '../../src/document/drawing.ts';
import { add3, scale3 } from '../../src/math/tuple.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { CameraRig } from '../../src/scene/cameraRig.ts';
import { jittered } from '../../src/scene/jitter.ts';
import { rayAt } from '../../src/stroke/plane.ts';

const [WIDTH, HEIGHT] = [90, 70];

beforeAll(() => void vi.stubGlobal('DOMRect', class {}));

describe.each([0, 35])('opening %d°', (fov) => {
  it.each([
    [0.5, 0.5],
    [0.125, 0.875],
    [0.9, 0.2],
  ])('what a ray through %d, %d of a pixel meets is in its middle', (x, y) => {
    const rig = new CameraRig();
    const view = {
      ...FRONT_VIEW,
      pivot: [3, -2, 5] as Vec3,
      rotation: [0.1, 0.3, 0, Math.sqrt(0.9)] as const,
      fov,
    };
    // the sides of the element are no whole numbers of pixels
    rig.resize(60.3, 46.5);
    rig.setView(view, false);
    const { camera } = rig;
    const before = camera.projectionMatrix.clone();
    for (const coordinateSystem of [WebGLCoordinateSystem, WebGPUCoordinateSystem] as const) {
      for (const [column, row] of [
        [0, 0],
        [44, 12],
        [89, 69],
      ] as const) {
        const ray = rayAt(view, { width: WIDTH, height: HEIGHT }, column + x, row + y);
        const start = fov === 0 ? 1e4 : 300;
        const place = add3(ray.origin, scale3(ray.direction, start));
        const rays = { view, width: WIDTH, height: HEIGHT, offset: [x, y] as const };
        const seen = jittered(camera, { coordinateSystem }, rays, () =>
          new Vector3(...place).project(camera),
        );
        expect(((seen.x + 1) / 2) * WIDTH).toBeCloseTo(column + 0.5, 4);
        expect(((1 - seen.y) / 2) * HEIGHT).toBeCloseTo(row + 0.5, 4);
      }
    }
    expect(camera instanceof OrthographicCamera || camera instanceof PerspectiveCamera).toBe(true);
    camera.coordinateSystem = WebGLCoordinateSystem;
    camera.updateProjectionMatrix();
    for (const [i, value] of camera.projectionMatrix.elements.entries())
      expect(value).toBeCloseTo(before.elements[i]!, 9);
  });
});
