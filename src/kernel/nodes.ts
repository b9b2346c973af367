/**
 * Integrals as sums: nodes along a line with what a kernel is there. Made once, filled again for each evaluation.
 */
import { exp } from '../math/exp.ts';
import { GAUSS, type GaussRule } from '../math/gaussLegendre.ts';
import { log1p } from '../math/log.ts';
import type { Integral, LineFrame } from './kernel.ts';

const MOST = 256;
const FINE = GAUSS[16];
/** of a panel in the sinh variable: 16 nodes leave 1e-14 of (1 + r²)^−5 (3 long: 5e-10) */
const SINH_PANEL = 2;

export class Nodes {
  count = 0;
  /** where, from the foot */
  readonly tau = new Float64Array(MOST);
  readonly weight = new Float64Array(MOST);
  /** the kernel there, and df/d(r²); filled by the kernel */
  readonly value = new Float64Array(MOST);
  readonly slope = new Float64Array(MOST);

  /** One Gauss rule on [low, high]. */
  gauss(rule: GaussRule, low: number, high: number): void {
    this.count = 0;
    this.#add(rule, low, high);
  }

  /** As many equal panels of 16 nodes as keep each below `longest`. */
  panels(low: number, high: number, longest: number): void {
    const panels = Math.min(Math.ceil((high - low) / longest), MOST / 16);
    const step = (high - low) / panels;
    this.count = 0;
    for (let i = 0; i < panels; i++) this.#add(FINE, low + i * step, low + (i + 1) * step);
  }

  /**
   * The same in x, τ = scale sinh x: for integrands whose nearest singularities are at τ = ±i scale, however long the line.
   */
  sinhPanels(scale: number, low: number, high: number): void {
    this.panels(asinh(low / scale), asinh(high / scale), SINH_PANEL);
    for (let i = 0; i < this.count; i++) {
      const e = 0.5 * scale * exp(this.tau[i]!);
      const inverse = (0.25 * scale * scale) / e;
      this.tau[i] = e - inverse;
      this.weight[i] = this.weight[i]! * (e + inverse);
    }
  }

  #add({ nodes, weights }: GaussRule, low: number, high: number): void {
    const middle = 0.5 * (low + high);
    const half = 0.5 * (high - low);
    for (let i = 0; i < nodes.length; i++) {
      this.tau[this.count] = middle + half * nodes[i]!;
      this.weight[this.count] = half * weights[i]!;
      this.count++;
    }
  }
}

/** The contract's integral over a line. */
export function sumLine(frame: LineFrame, nodes: Nodes, out: Integral): void {
  const { alpha, weights, slopes } = frame;
  const [w0, w1, w2, w3] = [weights[0]!, weights[1]!, weights[2]!, weights[3]!];
  let value = 0;
  let across = 0;
  let along = 0;
  for (let i = 0; i < nodes.count; i++) {
    const tau = nodes.tau[i]!;
    const t = tau - alpha;
    const w = (w0 + t * (w1 + t * (w2 + t * w3))) * nodes.weight[i]!;
    value += w * nodes.value[i]!;
    if (!slopes) continue;
    const slope = w * nodes.slope[i]!;
    across += slope;
    along -= 2 * tau * slope;
  }
  out[0] = value;
  if (!slopes) return;
  out[1] = across;
  out[2] = along;
}

function asinh(t: number): number {
  const a = Math.abs(t);
  const x = log1p(a + (a * a) / (1 + Math.sqrt(1 + a * a)));
  return t < 0 ? -x : x;
}
