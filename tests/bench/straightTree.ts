/**
 * What src/gpu/program.ts was measured against: WGSL generated for one structure, straight-line code with a line or two a
 * step, so that no stack, no loop over steps and no choice between leaves or operations is left. Numbers stay data.
 */
import { type Program, ROLE, type Step, TAKE } from '../../src/gpu/program.ts';

/** Takes the place of the module field/tree. */
export function straightTree({ steps }: Program): string {
  const stack: string[] = [];
  let result = '';
  const lines = steps.flatMap((step, i) => {
    const isStack = step.take === TAKE.STACK;
    const early = isStack ? stack.pop()! : result;
    const late = isStack ? result : `leaf${i}`;
    const load = `let step${i} = load_step(first + ${i}u * STEP_STRIDE);`;
    const leaf = isStack ? [] : leafLines(step, i);
    if (step.role === ROLE.PUSH) stack.push(result);
    result = step.role === ROLE.JOIN ? `joined${i}` : late;
    return [load, ...leaf, ...(step.role === ROLE.JOIN ? [joinLine(step, i, early, late)] : [])];
  });
  return `#import field/combined
#import field/place
#import field/sum
#import operation
#import record/program
#import record/step
#import shape
fn tree_field(p: vec3f) -> vec4f {
  let first = load_program(0u).first;
  ${lines.join('\n  ')}
  return ${result};
}
`;
}

function leafLines({ take, place }: Step, i: number): string[] {
  const q = place === 0 ? 'p' : `to_local(place${i}, p)`;
  const local =
    take === TAKE.SUM ? `sum_field(step${i}.at, ${q}, false)` : `shape_field(load_shape(step${i}.at), ${q})`;
  if (place === 0) return [`let leaf${i} = ${local};`];
  return [`let place${i} = load_place(step${i}.place);`, `let leaf${i} = to_world(place${i}, ${local});`];
}

/** The operation and the order of its operands are known; what only negates is data in both. */
function joinLine({ operation, swapped }: Step, i: number, early: string, late: string): string {
  const [a, b] = swapped ? [late, early] : [early, late];
  const s = `step${i}`;
  const united = `operation(${operation}u, ${s}.outer * ${a}.x, ${s}.sign * ${b}.x, ${s}.amounts)`;
  return `let joined${i} = ${s}.outer * combined(${s}.outer * ${a}, ${s}.sign * ${b}, ${united});`;
}
