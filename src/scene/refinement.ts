/** The mean of pictures whose pixels were looked at in different places: what rays, one a pixel, leave jagged becomes smooth. */
import { screenUV, texture, uniform, vec4 } from 'three/tsl';
import {
  CustomBlending,
  HalfFloatType,
  NodeMaterial,
  OneMinusSrcAlphaFactor,
  type RenderTarget,
  SrcAlphaFactor,
  type Texture,
} from 'three/webgpu';
import { makeOutput } from './targets.ts';

export class Refinement {
  /** pictures in the mean */
  count = 0;
  /** the picture that is seen through it is kept */
  isBegun = false;
  readonly sample: RenderTarget = makeOutput();
  readonly mean: RenderTarget = makeOutput(HalfFloatType);
  readonly shown: NodeMaterial;
  readonly #weight = uniform(1);
  readonly #adding: NodeMaterial;

  constructor() {
    this.shown = picture('the mean of pictures', this.mean.texture);
    this.#adding = picture('one more picture', this.sample.texture);
    this.#adding.fragmentNode = vec4(texture(this.sample.texture, screenUV).xyz, this.#weight);
    this.#adding.transparent = true;
    this.#adding.blending = CustomBlending;
    this.#adding.blendSrc = SrcAlphaFactor;
    this.#adding.blendDst = OneMinusSrcAlphaFactor;
  }

  /** What brings the sample into the mean. */
  add(): NodeMaterial {
    this.count++;
    this.#weight.value = 1 / this.count;
    return this.#adding;
  }

  resize(width: number, height: number): void {
    for (const target of [this.sample, this.mean]) target.setSize(width, height);
  }

  /** The next one begins anew. */
  end(): void {
    if (this.count > 0) this.resize(1, 1);
    this.count = 0;
    this.isBegun = false;
  }

  dispose(): void {
    for (const each of [this.sample, this.mean, this.shown, this.#adding]) each.dispose();
  }
}

function picture(name: string, of: Texture): NodeMaterial {
  const material = new NodeMaterial();
  material.name = name;
  material.depthTest = false;
  material.depthWrite = false;
  material.fragmentNode = vec4(texture(of, screenUV).xyz, 1);
  return material;
}
