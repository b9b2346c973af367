/** The image that surfaces are drawn from, on the device, and what is told of the items in it. */
import { texture, uniform } from 'three/tsl';
import {
  DataTexture,
  FloatType,
  NearestFilter,
  NoColorSpace,
  RGBAFormat,
  type TextureNode,
  Vector2,
} from 'three/webgpu';
import type { Vec3 } from '../math/vec.ts';
import type { FinishVectors } from './finish.ts';
import type { Seam } from './seam.ts';
import { CHANNELS, type SurfaceImage } from './surfaceImage.ts';

/** items that can have a colour or be selected; those beyond count as the last */
export const MOST_ITEMS = 4096;

/** Bits of what is told of an item. */
export const FLAGS = { coloured: 1, selected: 2 } as const;

/** Rows of the table. */
export const FACTS = { colour: 0, light: 1, peak: 2 } as const;

export interface ItemFacts {
  /** display values, in place of the image's own; null: as the image has it */
  readonly colour: Vec3 | null;
  readonly selected: boolean;
  readonly finish: FinishVectors;
}

export class ImageInputs {
  readonly size = uniform(new Vector2(1, 1));
  /** z of the pivot's plane in view space, mm */
  readonly pivot = uniform(0);
  readonly surface = texture(floats(1, 1)) as TextureNode;
  readonly colours = texture(floats(1, 1)) as TextureNode;
  readonly facts = texture(floats(MOST_ITEMS, 3)) as TextureNode;

  put({ camera, surface, colours, stride }: SurfaceImage, seam: Seam): void {
    const { width, height } = camera;
    this.size.value.set(width, height);
    for (const [node, pixels] of [
      [this.surface, surface],
      [this.colours, colours],
    ] as const) {
      const sized = fitting(node, width, height);
      if (pixels instanceof Float32Array) {
        sized.image.data = pixels;
        sized.needsUpdate = true;
      } else seam.fill(sized, pixels, stride ?? width);
    }
  }

  /** Of the items of the image, in its order. */
  tell(items: readonly ItemFacts[]): void {
    const table = this.facts.value as DataTexture;
    const data = table.image.data as Float32Array;
    for (const [i, { colour, selected, finish }] of items.slice(0, MOST_ITEMS).entries()) {
      const flags = (colour ? FLAGS.coloured : 0) + (selected ? FLAGS.selected : 0);
      const put = (row: number, values: readonly number[]) =>
        data.set(values, CHANNELS * (MOST_ITEMS * row + i));
      put(FACTS.colour, [...(colour ?? [0, 0, 0]), flags]);
      put(FACTS.light, finish.light);
      put(FACTS.peak, finish.peak);
    }
    table.needsUpdate = true;
  }

  /** The memory of the image goes. */
  rest(): void {
    for (const node of [this.surface, this.colours]) fitting(node, 1, 1);
  }

  dispose(): void {
    for (const { value } of [this.surface, this.colours, this.facts]) value.dispose();
  }
}

function fitting(node: TextureNode, width: number, height: number): DataTexture {
  const old = node.value as DataTexture;
  if (old.image.width === width && old.image.height === height) return old;
  old.dispose();
  const made = floats(width, height);
  node.value = made;
  return made;
}

function floats(width: number, height: number): DataTexture {
  const made = new DataTexture(
    new Float32Array(CHANNELS * width * height),
    width,
    height,
    RGBAFormat,
    FloatType,
  );
  made.minFilter = made.magFilter = NearestFilter;
  made.colorSpace = NoColorSpace;
  made.needsUpdate = true;
  return made;
}
