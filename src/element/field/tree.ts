/** State → tree. FieldError, with the place, where the kernel at hand has no weight for a radius. */
import type { Affine } from '../../field/affine.ts';
import type { AnySkel } from '../../field/expand.ts';
import type { FieldNode, SkelsNode, Term } from '../../field/node.ts';
import type { Warp } from '../../field/warp.ts';
import { kernelNamed } from '../../kernel/index.ts';
import type { Kernel, KernelParams } from '../../kernel/kernel.ts';
import { cos, PI, sin } from '../../math/trig.ts';
import { kindOf, type Shape, shapes } from '../../shape/index.ts';
import { at } from '../../skeleton/place.ts';
import { weightPieces } from '../../skeleton/profile.ts';
import { hasRadii, type RoundSkel, weighted } from '../../skeleton/radii.ts';
import { FieldError } from '../../skeleton/skeleton.ts';
import { pointWeight, widthFor } from '../../skeleton/weight.ts';
import type { FieldState } from './fieldState.ts';
import { PAINT } from './palette.ts';
import { profileNamed } from './profiles.ts';
import { NOMINAL, type Piece, SKELETONS } from './skeletons.ts';
import { type Body, type Weigh, weighByRadius, weighByWeight } from './weigh.ts';

export function treeOf(state: FieldState): FieldNode {
  const body = bodyOf(state);
  const { operation } = state;
  if (operation === 'none') return body;
  const shape = shapeOf(state);
  const { a0, a1, a2, t } = state;
  if (operation === 'blend') return { type: 'blend', a: body, b: shape, a0, a1, a2 };
  if (operation === 'morph') return { type: 'morph', from: body, to: shape, t };
  const type = operation as 'union' | 'intersection' | 'subtraction';
  return { type, form: state.form as 'hard' | 'smooth', parts: [body, shape] };
}

function bodyOf(state: FieldState): SkelsNode {
  const kernel = kernelOf(state);
  const params = paramsOf(state);
  const weigh = weigher(state, { kernel, params, threshold: state.T, parts: partsOf(state) });
  const skels = piecesOf(state).map((piece, i) => at(`skels[${i}]`, () => termOf(piece, weigh, state)));
  const carving = at(`skels[${skels.length}]`, () => carver(state, kernel, params));
  return { type: 'skels', kernel: kernel.name, params, threshold: state.T, skels: [...skels, ...carving] };
}

/** How much wider than the largest radius a kernel that ends must be: at its very end its weight would be infinite. */
const WITHIN_SUPPORT = 1.3;

/** Parameters of the state's kernel: those of its sliders, or fitted to the smallest radius. */
export function paramsOf(state: FieldState): KernelParams {
  const kernel = kernelOf(state);
  const set = Object.fromEntries(kernel.params.map(({ name }) => [name, state[name]]));
  if (state.width === 'own') return set;
  const radii = piecesOf(state).flatMap((piece) => ('radii' in piece ? piece.radii : [piece.radius]));
  const fitted = at('params', () => widthFor(kernel, set, Math.min(...radii)));
  if (kernel.support === Infinity || fitted.R === undefined) return fitted;
  return { ...fitted, R: Math.max(fitted.R, (WITHIN_SUPPORT * Math.max(...radii)) / kernel.support) };
}

/** The weight with which the first piece stays as it is by its radius. */
export function firstWeight(state: FieldState): number {
  const [kernel, params, piece] = [kernelOf(state), paramsOf(state), piecesOf(state)[0]!];
  const skel = weighByRadius({ kernel, params, threshold: state.T, parts: partsOf(state) })(piece);
  const first = firstOf(hasRadii(skel) ? weighted(skel, kernel, params, state.T) : skel);
  return (first * state.radius) / ('radii' in piece ? piece.radii[0]! : piece.radius);
}

function firstOf(skel: Exclude<AnySkel, RoundSkel>): number {
  if ('weight' in skel) return skel.weight;
  return 'weights' in skel ? skel.weights[0]! : weightPieces(skel.curve)[0]!.coefficients[0];
}

/** Ordinates after the first of a weight that has its own sliders; null: the radii say how it changes. */
export function ordinatesOf({ skeleton, by, degree }: FieldState): number | null {
  if (skeleton === 'profile') return 3;
  if (by === 'radius') return null;
  return skeleton === 'arc' ? 1 : skeleton === 'segment' ? Number(degree) : null;
}

function partsOf(state: FieldState): Body['parts'] {
  const count = ordinatesOf(state);
  return count === null ? null : [1, state.weight1, state.weight2, state.weight3].slice(0, count + 1);
}

function kernelOf({ kernel }: FieldState): Kernel {
  const found = kernelNamed(kernel);
  if (!found) throw new FieldError(`unknown kernel '${kernel}'`);
  return found;
}

/** Of the preset, at the state's radius. */
function piecesOf(state: FieldState): readonly Piece[] {
  const pieces = SKELETONS[state.skeleton]!();
  const scale = state.radius / NOMINAL;
  return pieces.map((piece): Piece => {
    if ('radius' in piece) return { ...piece, radius: scale * piece.radius };
    const radii = piece.radii.map((radius) => scale * radius);
    return { ...piece, radii: hasTwoEnds(state) ? [radii[0]!, state.radiusEnd] : radii };
  });
}

/** Whether the radius at the other end has its own slider. */
export function hasTwoEnds({ skeleton }: FieldState): boolean {
  return skeleton === 'segment' || skeleton === 'arc';
}

function weigher(state: FieldState, body: Body): Weigh {
  return state.by === 'radius' ? weighByRadius(body) : weighByWeight(state.weight, state.radius, body);
}

function termOf(piece: Piece, weigh: Weigh, state: FieldState): Term {
  const warp = warpOf(piece, state);
  const term = { skel: weigh(piece), colour: piece.colour };
  return warp ? { ...term, warp } : term;
}

/** Lines lie about in the plane of the page: their sections stand with y towards the viewer. Points show theirs. */
function warpOf({ type }: Piece, state: FieldState): Warp | null {
  const { section, alpha, edge, profile, betaX, betaY, thickness } = state;
  const isPlain = section === 'round' && betaX === 1 && betaY === 1;
  if (isPlain) return null;
  const scale = [betaX, section === 'extrusion' ? thickness : betaY] as const;
  const frame =
    type === 'point'
      ? ({ up: [0, 1, 0], along: [0, 0, 1] } as const)
      : type === 'plate'
        ? {}
        : ({ up: [0, 0, 1] } as const);
  switch (section) {
    case 'superQuadric':
      return { section: { type: section, exponent: alpha }, scale, ...frame };
    case 'extrusion':
      return { section: { type: section, exponent: edge }, scale, ...frame };
    case 'polar':
      return { section: profileNamed(profile), scale, ...frame };
    default:
      return { section: { type: 'round' }, scale, ...frame };
  }
}

/** A point in front of the body that takes away. */
function carver(state: FieldState, kernel: Kernel, params: KernelParams): readonly Term[] {
  const { carve, carveRadius, carveX, carveY, radius, T } = state;
  if (carve === 0) return [];
  const weight = pointWeight(kernel, params, carveRadius, T);
  return [{ skel: { type: 'point', at: [carveX, carveY, radius], weight }, factor: carve }];
}

function shapeOf(state: FieldState): FieldNode {
  const { examples } = kindOf({ type: state.shape } as Shape) as (typeof shapes)['sphere'];
  const shape: Shape = examples[Math.min(state.example, examples.length - 1)]!;
  return { type: 'affine', matrix: placement(state), node: { type: 'shape', shape, colour: PAINT.teal } };
}

/** How many examples the shape has. */
export function examplesOf({ shape }: FieldState): readonly Shape[] {
  return (shapes as Readonly<Record<string, { readonly examples: readonly Shape[] }>>)[shape]!.examples;
}

/** Scaled, turned about x, then about z, and moved along x. */
function placement({ shapeSize: k, shapeTilt, shapeTurn, shapeX }: FieldState): Affine {
  const [tilt, turn] = [(shapeTilt * PI) / 180, (shapeTurn * PI) / 180];
  const [c, s] = [k * cos(turn), k * sin(turn)];
  const [d, e] = [cos(tilt), sin(tilt)];
  return [c, -s * d, s * e, shapeX, s, c * d, -c * e, 0, 0, k * e, k * d, 0];
}
