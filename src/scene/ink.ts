/**
 * The ink wash under the lines of hbed-ink (thesis 7.2.4, figure 7.9 a): toon's bands as washes of thinned ink. The
 * lightest band is bare paper. A wash dries darker at its border and is never even; the blotches are noise in the
 * model's space, so that they turn with the form.
 *
 * A finish that is darker or lighter than the default makes washes darker or lighter by what toon's light would be; its highlight stays bare.
 *
 * On dark paper the drawing is heightened with chalk: the lit bands are painted, the shade is bare.
 */
import { float, mx_noise_float, uniform, vec3, vec4 } from 'three/tsl';
import { type Node, type NodeMaterial, Vector3 } from 'three/webgpu';
import { LIGHT } from './light.ts';
import type { Surface } from './surface.ts';
import { BAND_STEP, bandOf, highlightOf, LOWEST_BAND, THRESHOLDS } from './toon.ts';

/** opacity of the washes for the bands .1 .3 .5 .7 */
const WASH = [0.52, 0.33, 0.16, 0];
const CHALK = [0, 0.16, 0.33, 0.62];
/** toon's light in grey, of which washes are what is missing: .43 + .83 · band is 1 less the wash within .04 */
const GREY = { ambient: 0.43, gain: 0.83 } as const;
/** blotches: share of a wash that comes and goes, and how many of them span the scene's radius */
const BLOTCH = 0.22;
const BLOTCHES = 7;
/** added to the opacity on the dried border of a wash, about 1.2 pixels wide */
const BORDER = 0.16;

export class InkUniforms {
  readonly colour = uniform(new Vector3());
  readonly chalk = uniform(0);
  /** radius of the scene, mm */
  readonly radius = uniform(100);
}

export function inkMaterial(surface: Surface, uniforms: InkUniforms): NodeMaterial {
  return surface.material('ink wash', () => {
    const band = bandOf(surface).toVar();
    const bare = uniforms.chalk.oneMinus();
    const lighter = lighterBy(surface, band).toVar();
    const highlight = highlightOf(surface).toVar();
    const ink = perBand(band, WASH)
      .sub(lighter)
      .clamp(0, 1)
      .mul(highlight.mul(surface.finish.white).oneMinus());
    const chalk = perBand(band, CHALK).add(lighter).add(highlight.mul(surface.finish.chalk)).clamp(0, 1);
    const wash = ink.mul(bare).add(chalk.mul(uniforms.chalk));
    const border = driedBorder(surface).mul(bare);
    const opacity = wash.mul(blotches(surface, uniforms)).add(border).clamp(0, 1);
    // premultiplied; what lies behind the form is hidden, not seen through the wash
    return vec4(uniforms.colour.mul(opacity), opacity);
  });
}

/** How much more light the finish gives than the default one does. */
function lighterBy({ finish }: Surface, band: Node<'float'>): Node<'float'> {
  const ambient = finish.ambient.sub(1).mul(GREY.ambient);
  return ambient.add(finish.diffuse.sub(1).mul(GREY.gain).mul(band));
}

/** Piecewise linear through the four bands, so that a border smoothed in `band` is smoothed here too. */
function perBand(band: Node<'float'>, values: readonly number[]): Node<'float'> {
  const place = band.sub(LOWEST_BAND).div(BAND_STEP);
  let result: Node<'float'> = float(values[0] ?? 0);
  for (let i = 1; i < values.length; i++) {
    const step = (values[i] ?? 0) - (values[i - 1] ?? 0);
    result = result.add(
      place
        .sub(i - 1)
        .clamp(0, 1)
        .mul(step),
    );
  }
  return result;
}

function blotches(surface: Surface, uniforms: InkUniforms): Node<'float'> {
  const place = surface.place.mul(float(BLOTCHES).div(uniforms.radius)).toVar();
  // Stretched along the diagonal, the way a brush is led.
  const led = vec3(place.x.add(place.y).mul(0.5), place.x.sub(place.y), place.z);
  const noise = mx_noise_float(led)
    .mul(0.65)
    .add(mx_noise_float(led.mul(2.3)).mul(0.35));
  return noise.mul(BLOTCH).add(1);
}

function driedBorder(surface: Surface): Node<'float'> {
  const facing = surface.normal.dot(LIGHT).toVar();
  const width = surface.change(LIGHT).toVar();
  let border: Node<'float'> = float(0);
  for (const threshold of THRESHOLDS) {
    border = border.max(facing.sub(threshold).abs().div(width).oneMinus().clamp(0, 1));
  }
  return border.mul(BORDER);
}
