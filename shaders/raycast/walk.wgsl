#import polygonize/lattice

// The bricks that a ray comes through, blocks of 4³ of one kind at once. Twin of src/field/rayWalk.ts.

@group(0) @binding(0) var<storage, read> grid: array<i32>;
// OUTSIDE, INSIDE, or 0 where it is mixed; of 4³ bricks each
@group(0) @binding(1) var<storage, read> blocks: array<i32>;

const BLOCK = 4;
const OUTSIDE = -1;
const INSIDE = -2;

struct Walk {
  start: vec3f,
  ray: vec3f,
  // bricks of the brick or block that one is in, both ends included
  first: vec3i,
  last: vec3i,
  // mm along the ray: where it is entered and left, and where the lattice ends
  enter: f32,
  leave: f32,
  end: f32,
  // the axis across which it is left
  out: u32,
  // number among the active bricks, OUTSIDE or INSIDE
  state: i32,
}

// (from, to, axis across which one comes in, or −1), from > to where the lattice is not met; half a cell at its border is cut off
fn lattice_span(start: vec3f, ray: vec3f, nearest: f32) -> vec3f {
  let low = lattice.origin + 0.5 * lattice.step - start;
  let high = low + lattice.step * vec3f(4u * lattice.bricks.xyz - 1u);
  var span = vec3f(nearest, 3e38, -1.0);
  for (var axis = 0u; axis < 3u; axis++) {
    if (ray[axis] == 0.0) {
      if (low[axis] > 0.0 || high[axis] < 0.0) {
        return vec3f(1.0, 0.0, -1.0);
      }
      continue;
    }
    let a = low[axis] / ray[axis];
    let b = high[axis] / ray[axis];
    if (min(a, b) > span.x) {
      span.x = min(a, b);
      span.z = f32(axis);
    }
    span.y = min(span.y, max(a, b));
  }
  return span;
}

fn walk_begin(start: vec3f, ray: vec3f, enter: f32, end: f32) -> Walk {
  var walk: Walk;
  walk.start = start;
  walk.ray = ray;
  walk.enter = enter;
  walk.end = end;
  walk_look(&walk, brick_at(start + enter * ray, vec3i(0), vec3i(lattice.bricks.xyz) - 1));
  return walk;
}

// false at the end
fn walk_next(walk: ptr<function, Walk>) -> bool {
  if ((*walk).leave >= (*walk).end) {
    return false;
  }
  let axis = (*walk).out;
  // in a block the other axes have gone on
  let reached = (*walk).start + (*walk).leave * (*walk).ray;
  var at = brick_at(reached, (*walk).first, (*walk).last);
  at[axis] = select((*walk).first[axis] - 1, (*walk).last[axis] + 1, (*walk).ray[axis] > 0.0);
  if (at[axis] < 0 || at[axis] >= i32(lattice.bricks[axis])) {
    return false;
  }
  (*walk).enter = (*walk).leave;
  walk_look(walk, at);
  return true;
}

fn brick_at(p: vec3f, low: vec3i, high: vec3i) -> vec3i {
  return clamp(vec3i(floor((p - lattice.origin) / (4.0 * lattice.step))), low, high);
}

fn walk_look(walk: ptr<function, Walk>, at: vec3i) {
  let along = (vec3i(lattice.bricks.xyz) + BLOCK - 1) / BLOCK;
  let block_at = at / BLOCK;
  let block = blocks[block_at.x + along.x * (block_at.y + along.y * block_at.z)];
  let is_mixed = block == 0;
  let bricks = vec3i(lattice.bricks.xyz);
  (*walk).state = block;
  (*walk).first = block_at * BLOCK;
  (*walk).last = min((*walk).first + BLOCK, bricks) - 1;
  if (is_mixed) {
    (*walk).state = grid[at.x + bricks.x * (at.y + bricks.y * at.z)];
    (*walk).first = at;
    (*walk).last = at;
  }
  (*walk).leave = (*walk).end;
  for (var axis = 0u; axis < 3u; axis++) {
    let along_axis = (*walk).ray[axis];
    if (along_axis == 0.0) {
      continue;
    }
    let wall = select((*walk).first[axis], (*walk).last[axis] + 1, along_axis > 0.0);
    let t = (lattice.origin[axis] + 4.0 * lattice.step * f32(wall) - (*walk).start[axis]) / along_axis;
    if (t < (*walk).leave) {
      (*walk).leave = max(t, (*walk).enter);
      (*walk).out = axis;
    }
  }
}
