/**
 * Lines by hardware based edge detection (thesis 7.2, figure 7.10): the first pass draws normals and depth, the
 * second weighs them with a difference kernel; where the length of the response exceeds a threshold is a line.
 *
 * Departures. Depth is linear over the scene's bounding sphere: with near .1 and far 100 two parts 30 % of the
 * scene apart differ by .003 and no overlap is ever found. A and B answer a straight edge with half of what C and D
 * do (a quarter against a half), so they get half the threshold. C and D look up and right only; their stencil is
 * moved by half its size, so that a line lies on its edge. Thresholds are small ramps, see `SOFTNESS`.
 *
 * The contour of toon wants one width in all directions, which none of the four has (C: 1 to 1.41 offsets): it
 * takes the largest second difference over four diameters of a circle.
 */
import { float, screenUV, smoothstep, texture, uniform, vec2, vec4 } from 'three/tsl';
import { type Node, NodeMaterial, type Texture, Vector2 } from 'three/webgpu';
import type { Surface } from './surface.ts';

export type Kernel = 'A' | 'B' | 'C' | 'D' | 'contour';

/** right, up in offsets, and weight */
type Tap = readonly [right: number, up: number, weight: number];

interface Stencil {
  readonly taps: readonly Tap[];
  /** CSS pixels between the centre and a neighbour */
  readonly offset: 1 | 2;
  /** what a straight edge is answered with, relative to C and D */
  readonly gain: 0.5 | 1;
  /** moves the stencil left and down by half an offset */
  readonly centred: boolean;
}

const CROSS: readonly Tap[] = [
  [0, 0, 1],
  [0, 1, -0.25],
  [1, 0, -0.25],
  [0, -1, -0.25],
  [-1, 0, -0.25],
];
const CORNER: readonly Tap[] = [
  [0, 0, 1],
  [0, 1, -0.5],
  [1, 0, -0.5],
];

export const STENCILS: Readonly<Record<'A' | 'B' | 'C' | 'D', Stencil>> = {
  A: { taps: CROSS, offset: 1, gain: 0.5, centred: false },
  B: { taps: CROSS, offset: 2, gain: 0.5, centred: false },
  C: { taps: CORNER, offset: 1, gain: 1, centred: true },
  D: { taps: CORNER, offset: 2, gain: 1, centred: true },
};

/** CSS pixels; half of it lies on either side of the edge */
const CONTOUR_WIDTH = 2.4;
/** A line fades in from 1 − SOFTNESS to 1 + SOFTNESS times its threshold, so that faint creases do not flicker. */
const SOFTNESS = 0.2;

/** What the line passes read each frame. */
export class LineUniforms {
  /** view-space distance of the near side of the scene's sphere, mm, and the sphere's diameter, mm */
  readonly depthRange = uniform(new Vector2(0, 1));
  /** 1 / size of the line target, texels */
  readonly texel = uniform(new Vector2(1, 1));
  /** texels between a kernel's centre and its neighbours, and by how much the stencil is moved */
  readonly offset = uniform(new Vector2(1, 0));
  /** ends of the contour's diameters, texels: further and nearer axis, see `contour` */
  readonly low = uniform(new Vector2(-2, -1));
  readonly high = uniform(new Vector2(3, 1));
  readonly creases = uniform(0.15);
  readonly overlaps = uniform(0.05);

  /** Texels a CSS pixel → whole texels, so that nearest sampling never has to choose. */
  setScale(texelsPerPixel: number, kernel: Kernel): void {
    if (kernel === 'contour') {
      // Diameters at 22.5° and so on: tan 22.5° = .414. In whole texels 5 × 2, 7 × 3, 10 × 4.
      const far = Math.max(2, Math.round(CONTOUR_WIDTH * texelsPerPixel));
      const near = Math.round(0.414 * far);
      this.low.value.set(-Math.floor(far / 2), -Math.floor(near / 2));
      this.high.value.set(Math.ceil(far / 2), Math.ceil(near / 2));
    } else {
      const { offset, centred } = STENCILS[kernel];
      const texels = Math.max(1, Math.round(offset * texelsPerPixel));
      this.offset.value.set(texels, centred ? Math.floor(texels / 2) : 0);
    }
  }
}

/** First pass: the normal as N/2 + ½ in red, green, blue; depth 0–1 in alpha. */
export const lineMaterial = (surface: Surface, uniforms: LineUniforms): NodeMaterial =>
  surface.material('normals and depth', () =>
    vec4(surface.normal.mul(0.5).add(0.5), sceneDepth(surface, uniforms)),
  );

/** 0 at the near side of the scene's sphere, 1 at the far side. */
export function sceneDepth(surface: Surface, uniforms: LineUniforms): Node<'float'> {
  return surface.z.negate().sub(uniforms.depthRange.x).div(uniforms.depthRange.y);
}

/**
 * Second pass: red is how much of a texel is line, 0–1; green is red times the line's nearness (1 − depth), so that
 * averages of both still tell the nearness. A line belongs to the nearest surface its kernel saw.
 */
export function edgeMaterial(lines: Texture, uniforms: LineUniforms, kernel: Kernel): NodeMaterial {
  const looks = new Looks(lines, uniforms);
  const covered = (
    kernel === 'contour' ? contour(looks, uniforms) : difference(looks, uniforms, kernel)
  ).toVar();
  const material = new NodeMaterial();
  material.name = `edges ${kernel}`;
  material.depthTest = false;
  material.depthWrite = false;
  material.fragmentNode = vec4(covered, covered.mul(looks.nearest.oneMinus()), 0, 1);
  return material;
}

/** The texels a kernel looks at, and the least depth among them. */
class Looks {
  nearest: Node<'float'> = float(1);
  readonly #lines: Texture;
  readonly #texel: Node<'vec2'>;

  constructor(lines: Texture, uniforms: LineUniforms) {
    this.#lines = lines;
    this.#texel = uniforms.texel;
  }

  /** Nearest texel: normals and depths of different surfaces must not be averaged before they are compared. */
  at(texels: Node<'vec2'>): Node<'vec4'> {
    const look = texture(this.#lines, screenUV.add(texels.mul(this.#texel))).toVar();
    this.nearest = this.nearest.min(look.w);
    return look;
  }
}

function difference(looks: Looks, uniforms: LineUniforms, kernel: 'A' | 'B' | 'C' | 'D'): Node<'float'> {
  const { taps, gain } = STENCILS[kernel];
  const { x: step, y: lead } = uniforms.offset;
  let response: Node<'vec4'> = vec4(0);
  for (const [right, up, weight] of taps) {
    const texels = vec2(step.mul(right).sub(lead), lead.sub(step.mul(up)));
    response = response.add(looks.at(texels).mul(weight));
  }
  return coverage(response.toVar(), uniforms, gain);
}

/**
 * An edge lies between the ends of a diameter as long as it is within the contour, so the contour is as wide as the
 * diameters are long, odd numbers of texels too. Second differences answer an edge like C does, and smooth slopes
 * of depth and normal hardly at all: rims of small forms stay thin.
 *
 * Tried: two rings of whole texels, mixed for the width between them: the same picture for 17 looks instead of 9.
 */
function contour(looks: Looks, uniforms: LineUniforms): Node<'float'> {
  const { x: lowFar, y: lowNear } = uniforms.low;
  const { x: highFar, y: highNear } = uniforms.high;
  const centre = looks.at(vec2(0)).mul(2).toVar();
  const diameters = [
    [vec2(lowFar, lowNear), vec2(highFar, highNear)],
    [vec2(lowNear, lowFar), vec2(highNear, highFar)],
    [vec2(highNear, lowFar), vec2(lowNear, highFar)],
    [vec2(highFar, lowNear), vec2(lowFar, highNear)],
  ] as const;
  let strongest: Node<'float'> = float(0);
  for (const [one, other] of diameters) {
    const ends = looks.at(one).add(looks.at(other));
    strongest = strongest.max(coverage(ends.sub(centre).mul(0.5).toVar(), uniforms, 1));
  }
  return strongest;
}

function coverage(response: Node<'vec4'>, uniforms: LineUniforms, gain: number): Node<'float'> {
  const crease = over(response.xyz.length(), uniforms.creases.mul(gain));
  const overlap = over(response.w.abs(), uniforms.overlaps.mul(gain));
  return crease.max(overlap);
}

function over(value: Node<'float'>, threshold: Node<'float'>): Node<'float'> {
  return smoothstep(threshold.mul(1 - SOFTNESS), threshold.mul(1 + SOFTNESS), value);
}
