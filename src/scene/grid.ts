/**
 * The grid: faint lines on the plane through the pivot that faces the camera, where a stroke on empty paper would
 * lie. Lines are 1 CSS pixel wide at every zoom; their distance is 1, 5, 10, 50, … mm, whichever is nearest above
 * 24 CSS pixels, and every fifth or tenth is stronger.
 */
import { fract, positionGeometry, uniform, vec4 } from 'three/tsl';
import {
  BufferAttribute,
  BufferGeometry,
  type Camera,
  CustomBlending,
  DoubleSide,
  Mesh,
  type Node,
  NodeMaterial,
  OneFactor,
  OneMinusSrcAlphaFactor,
  Vector3,
} from 'three/webgpu';
import type { View } from '../stroke/stroke.ts';
import { pixelWidth } from './surface.ts';

/** CSS pixels between two lines, at least */
const LEAST_DISTANCE = 24;
/** opacity of ordinary and of strong lines */
const FAINT = 0.1;
const STRONG = 0.22;

export class Grid {
  readonly mesh: Mesh;
  readonly #colour = uniform(new Vector3());
  /** mm between two lines, and between two strong ones */
  readonly #fine = uniform(10);
  readonly #coarse = uniform(50);

  constructor() {
    const geometry = new BufferGeometry();
    geometry.setAttribute(
      'position',
      new BufferAttribute(new Float32Array([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]), 3),
    );
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    geometry.name = 'grid';
    this.mesh = new Mesh(geometry, this.#material());
    this.mesh.name = 'grid';
    this.mesh.frustumCulled = false;
    // after the parts, which hide what of it lies behind them
    this.mesh.renderOrder = 2;
  }

  setColour(rgb: readonly [number, number, number]): void {
    this.#colour.value.set(...rgb);
  }

  /** Lays the plane through the pivot, large enough to fill the screen. */
  update(view: View, camera: Camera, aspect: number, pixelsHigh: number): void {
    const [fine, coarse] = distances((LEAST_DISTANCE * view.height) / pixelsHigh);
    this.#fine.value = fine;
    this.#coarse.value = coarse;
    this.mesh.position.set(...view.pivot);
    this.mesh.quaternion.copy(camera.quaternion);
    // a whole number of strong lines, so that one always passes the pivot
    this.mesh.scale.setScalar(coarse * Math.ceil((view.height * Math.max(1, aspect)) / coarse));
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    (this.mesh.material as NodeMaterial).dispose();
  }

  #material(): NodeMaterial {
    const place = positionGeometry.xy.mul(this.#scale());
    const opacity = cover(place, this.#fine).mul(FAINT).max(cover(place, this.#coarse).mul(STRONG));
    const material = new NodeMaterial();
    material.name = 'grid';
    material.side = DoubleSide;
    material.transparent = true;
    material.depthWrite = false;
    // premultiplied, see the page pass
    material.blending = CustomBlending;
    material.blendSrc = OneFactor;
    material.blendDst = OneMinusSrcAlphaFactor;
    material.fragmentNode = vec4(this.#colour.mul(opacity), opacity);
    return material;
  }

  /** mm from the middle of the plane to its side */
  #scale(): Node<'float'> {
    return uniform(1).onObjectUpdate(({ object }) => object?.scale.x ?? 1) as unknown as Node<'float'>;
  }
}

/** How much of a pixel lies on lines of this distance; a line is one pixel wide. */
function cover(place: Node<'vec2'>, distance: Node<'float'>): Node<'float'> {
  const along = (mm: Node<'float'>): Node<'float'> => {
    const cells = mm.div(distance).toVar();
    const off = fract(cells.add(0.5)).sub(0.5).abs();
    return off.div(pixelWidth(cells)).oneMinus().clamp(0, 1);
  };
  return along(place.x).max(along(place.y));
}

/** 1, 5, 10, 50, … and the next of the row. */
export function distances(least: number): readonly [fine: number, coarse: number] {
  const decade = 10 ** Math.floor(Math.log10(least));
  const fine = least <= decade ? decade : least <= 5 * decade ? 5 * decade : 10 * decade;
  return fine === 5 * decade ? [fine, 10 * decade] : [fine, 5 * fine];
}
