#import record/sum
#import record/term
#import table/entries

// What of a sum is asked in a brick (src/gpu/polygonize/lists.ts). Sums are met in the order of the program, and the brick's
// entries are in that order too: a cursor goes along them.

// headers of all bricks, then their entries
@group(1) @binding(1) var<storage, read> lists: array<vec4u>;

struct List {
  // what need not be asked, less T: value and gradient
  rest: vec4f,
  // its colour, and how much that weighs
  colour: vec3f,
  weight: f32,
  // where the numbers of the terms are, and how many
  at: u32,
  count: u32,
}

// in place of a list: all terms of all sums
const WHOLE = 0xffffffffu;

// the entry that comes next, or WHOLE, and how many sums were met
var<private> cursor: u32;
var<private> met: u32;

// before each evaluation
fn begin_list(at: u32) {
  cursor = at;
  met = 0u;
}

fn list_of(sum: Sum, p: vec3f) -> List {
  if (cursor == WHOLE) {
    let count = (sum.end - sum.first) / TERM_STRIDE;
    return List(vec4f(-sum.threshold, 0.0, 0.0, 0.0), sum.colour, 0.0, WHOLE, count);
  }
  // kind, up to which sum it holds, terms, constant
  let head = lists[cursor];
  met += 1u;
  if (head.x != LISTED) {
    cursor += select(0u, 1u, met == head.y);
    let value = select(-1e30, 1e30, head.x == DROPPED_HIGH);
    return List(vec4f(value, 0.0, 0.0, 0.0), sum.colour, 0.0, 0u, 0u);
  }
  let centre = bitcast<vec4f>(lists[cursor + 1u]);
  let linear = bitcast<vec4f>(lists[cursor + 2u]);
  let squares = bitcast<vec4f>(lists[cursor + 3u]);
  let mixed = bitcast<vec4f>(lists[cursor + 4u]);
  let at = cursor + 5u;
  cursor = at + (head.z + 3u) / 4u;
  let v = p - centre.xyz;
  // half the gradient of the squares and mixed products
  let bent = squares.xyz * v + 0.5 * (mixed.xyz * v.yzx + mixed.zxy * v.zxy);
  let value = bitcast<f32>(head.w) + dot(linear.xyz + bent, v);
  let colour = vec3f(linear.w, squares.w, mixed.w);
  let painted = select(sum.colour, colour / centre.w, centre.w > 0.0);
  return List(vec4f(value, linear.xyz + 2.0 * bent), painted, centre.w, at, head.z);
}

fn list_term(list: List, i: u32) -> u32 {
  if (list.at == WHOLE) {
    return i;
  }
  return lists[list.at + (i >> 2u)][i & 3u];
}
