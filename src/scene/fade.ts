/**
 * From one body to the next (Kravtsov et al. §1.3.2: alpha blending between the extracted meshes). The picture of the one is kept and
 * laid over those of the other, ever lighter. Departure: pictures are blended, not meshes: nothing has to be sorted, no line is
 * drawn twice, and every style fades alike, as long as the camera rests.
 */
import { float, max, min, mix, screenUV, texture, uniform, vec4 } from 'three/tsl';
import {
  CustomBlending,
  type Node,
  NodeMaterial,
  OneFactor,
  OneMinusSrcAlphaFactor,
  type RenderTarget,
} from 'three/webgpu';
import { makeOutput } from './targets.ts';

/** of the picture's height: a kernel that finds lines looks a few pixels across the border of what is known … */
const BORDER = 0.01;
/** … which is no line itself */
const SOFT = 0.05;

/** Rows of a picture, from … to …, 0–1 from the top. */
export type Known = readonly [from: number, to: number];
export const ALL: Known = [0, 1];

export class Fade {
  /** the picture that is kept; takes no memory worth naming while there is none */
  readonly kept: RenderTarget = makeOutput();
  readonly over: NodeMaterial;
  readonly #from = uniform(-1);
  readonly #to = uniform(2);
  readonly #lostFrom = uniform(3);
  readonly #lostTo = uniform(-2);
  #lost: Known | null = null;
  readonly #opacity = uniform(0);

  constructor() {
    const known = [this.#from, this.#to] as const;
    this.over = overMaterial(this.kept, this.#opacity, known, [this.#lostFrom, this.#lostTo]);
  }

  /** Of the picture that is kept, 0–1. */
  get share(): number {
    return this.#opacity.value;
  }

  set share(share: number) {
    this.#opacity.value = Math.min(Math.max(share, 0), 1);
    if (!this.isSeen) this.kept.setSize(1, 1);
  }

  /** Something of the picture that is kept is. */
  get isSeen(): boolean {
    return this.share > 0 || this.#lost !== null;
  }

  /** It goes. */
  end(): void {
    this.lost = null;
    this.share = 0;
  }

  /** Rows from the top, 0–1, above and below which nothing else is seen. */
  set known([from, to]: Known) {
    this.#from.value = from > 0 ? from + BORDER : -1;
    this.#to.value = to < 1 ? to - BORDER : 2;
  }

  /** Rows in which nothing else is seen, whatever the share; null: none. */
  set lost(rows: Known | null) {
    this.#lost = rows;
    this.#lostFrom.value = rows ? rows[0] - BORDER : 3;
    this.#lostTo.value = rows ? rows[1] + BORDER : -2;
  }

  dispose(): void {
    this.kept.dispose();
    this.over.dispose();
  }
}

type Rows = readonly [from: Node<'float'>, to: Node<'float'>];

function overMaterial(
  kept: RenderTarget,
  share: Node<'float'>,
  [from, to]: Rows,
  [lostFrom, lostTo]: Rows,
): NodeMaterial {
  const within = min(screenUV.y.sub(from), to.sub(screenUV.y)).div(SOFT).saturate();
  const without = max(lostFrom.sub(screenUV.y), screenUV.y.sub(lostTo)).div(SOFT).saturate();
  const opacity = mix(float(1), share, min(within, without));
  const material = new NodeMaterial();
  material.name = 'the picture before';
  material.depthTest = false;
  material.depthWrite = false;
  material.transparent = true;
  // premultiplied
  material.blending = CustomBlending;
  material.blendSrc = OneFactor;
  material.blendDst = OneMinusSrcAlphaFactor;
  material.fragmentNode = vec4(texture(kept.texture, screenUV).xyz.mul(opacity), opacity);
  return material;
}
