#import record/sum
#import record/term
#import skeleton/taylor
#import table/entries

// What the cube around knows of its sums: entries as polygonize/nearList.wgsl reads them, with the error so far in place of a number
// that entries of sums have no use for. Large cubes know nothing yet: all terms, none of them far.

@group(0) @binding(0) var<storage, read> outer: array<vec4u>;

const WHOLE = 0xffffffffu;

struct Outer {
  kind: u32,
  // terms, and where their numbers are
  count: u32,
  at: u32,
  // what stands for the others, about where, and by how much that is off
  far: Taylor,
  centre: vec3f,
  error: f32,
  // their colour times its weight, and that
  colour: vec4f,
}

fn whole_sum(sum: Sum) -> Outer {
  let far = Taylor(-sum.threshold, vec3f(0.0), vec3f(0.0), vec3f(0.0));
  let count = (sum.end - sum.first) / TERM_STRIDE;
  return Outer(LISTED, count, WHOLE, far, vec3f(0.0), 0.0, vec4f(0.0));
}

fn outer_sum(cursor: u32, head: vec4u) -> Outer {
  let centre = bitcast<vec4f>(outer[cursor + 1u]);
  let linear = bitcast<vec4f>(outer[cursor + 2u]);
  let squares = bitcast<vec4f>(outer[cursor + 3u]);
  let mixed = bitcast<vec4f>(outer[cursor + 4u]);
  let far = Taylor(bitcast<f32>(head.w), linear.xyz, squares.xyz, mixed.xyz);
  let colour = vec4f(linear.w, squares.w, mixed.w, centre.w);
  return Outer(LISTED, head.z, cursor + 5u, far, centre.xyz, bitcast<f32>(head.y), colour);
}

// the number of the i-th
fn outer_term(at: u32, i: u32) -> u32 {
  if (at == WHOLE) {
    return i;
  }
  return outer[at + (i >> 2u)][i & 3u];
}
