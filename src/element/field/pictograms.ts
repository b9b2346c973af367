/** Small pictures: skeletons as strokes, kernels as their own curves. */
import { html, svg, type TemplateResult } from 'lit';
import { kernelNamed } from '../../kernel/index.ts';

const SKELETONS: Readonly<Record<string, string>> = {
  animal: 'M5 27c-3-3-3-9 1-12M9 21h15l4-9M28 12l5-1M11 21l-1 10M13 21v10M22 21l1 10M24 21l2 10M27 11l-1-5',
  point: 'M17.500 18h1',
  segment: 'M6 24L30 12',
  crossed: 'M6 25L30 11M6 11l24 14',
  tree: 'M18 31V18L8 7M18 18L29 9',
  ring: 'M18 7a11 11 0 1 0 .01 0z',
  curve: 'M5 24c3-16 11-18 13-6s10 10 13-6',
  spline: 'M4 22Q12 0 18 18T32 14',
  arc: 'M27 12A11 11 0 1 1 17 7',
  profile: 'M4 10C12 17 22 22 32 9V27C22 16 12 20 4 26z',
  concave: 'M18 5l3.500 9 9.500.500-7.500 6 2.500 9.500-8-5.500-8 5.500 2.500-9.500-7.500-6 9.500-.500z',
  holed: 'M11 6h14l7 12-7 12H11L4 18zM18 12.500a5.500 5.500 0 1 0 .01 0z',
};

const FILLED: ReadonlySet<string> = new Set(['profile', 'concave', 'holed']);

/** The panel is drawn at every step of a slider: each picture is made once. */
function once(make: (id: string) => TemplateResult): (id: string) => TemplateResult {
  const made = new Map<string, TemplateResult>();
  return (id) => {
    const picture = made.get(id) ?? make(id);
    made.set(id, picture);
    return picture;
  };
}

export const skeletonPicture = once((id) => {
  const heavy = id === 'point' ? 5 : 2;
  return html`<svg class="pictogram ${FILLED.has(id) ? 'filled' : ''}" viewBox="0 0 36 36" aria-hidden="true">
    <path d=${SKELETONS[id] ?? ''} stroke-width=${heavy} />
  </svg>`;
});

/** kernel units across the picture, to both sides */
const REACH = 2.6;
/** singular kernels are cut off above */
const MOST = 1.25;

export const kernelPicture = once((id) => {
  const kernel = kernelNamed(id);
  const points = Array.from({ length: 61 }, (_, i) => {
    const r = ((i - 30) / 30) * REACH;
    const value = kernel && Math.abs(r) <= kernel.support ? kernel.value(r * r, 3) : 0;
    return `${(3 + i / 2).toFixed(1)} ${(31 - 20 * Math.min(value, MOST)).toFixed(1)}`;
  });
  return html`<svg class="pictogram" viewBox="0 0 36 36" aria-hidden="true">
    ${svg`<path d="M3 31h30" class="faint" /><path d="M${points.join('L')}" />`}
  </svg>`;
});

/** Short names under the kernels' pictures; their full ones are told as well. */
export const KERNEL_CAPTIONS: Readonly<Record<string, string>> = {
  cauchy: 'Cauchy',
  gaussian: 'Gauss',
  quartic: 'Quartic',
  inverse: '1/r',
  inverseSquared: '1/r²',
  inverseCubic: '1/r³',
  inverseQuintic: '1/r⁵',
  power: 'Power n',
};
