/** What the passes draw into. Memory is taken when a target is first drawn to, so unused passes cost nothing. */
import {
  HalfFloatType,
  LinearFilter,
  NearestFilter,
  NoColorSpace,
  RenderTarget,
  type RenderTargetOptions,
  RGBAFormat,
  RGFormat,
  type TextureDataType,
  UnsignedByteType,
} from 'three/webgpu';

/** Samples a pixel of what has edges of triangles in it. */
const SAMPLES = 4;

export type Targets = ReturnType<typeof makeTargets>;

export function makeTargets() {
  return {
    // normals and depth: 11 bits are finer than any threshold, and nearest texels only
    lines: target('normals and depth', {
      type: HalfFloatType,
      format: RGBAFormat,
      minFilter: NearestFilter,
      magFilter: NearestFilter,
    }),
    edges: target('line coverage', {
      type: UnsignedByteType,
      format: RGFormat,
      depthBuffer: false,
      minFilter: LinearFilter,
      magFilter: LinearFilter,
    }),
    // display values, premultiplied: 8 bits are what the screen has
    colour: target('colour', { type: UnsignedByteType, samples: SAMPLES }),
    preview: target('preview', { type: UnsignedByteType, samples: SAMPLES }),
    selection: target('selection', {
      type: UnsignedByteType,
      format: RGFormat,
      samples: SAMPLES,
      minFilter: LinearFilter,
      magFilter: LinearFilter,
    }),
  };
}

/** Stands in for the canvas: a picture that is read back and never shown. */
export function makeOutput(type: TextureDataType = UnsignedByteType): RenderTarget {
  return target('picture', { type, format: RGBAFormat, depthBuffer: false });
}

function target(name: string, options: RenderTargetOptions): RenderTarget {
  const made = new RenderTarget(1, 1, { colorSpace: NoColorSpace, generateMipmaps: false, ...options });
  made.texture.name = name;
  return made;
}
