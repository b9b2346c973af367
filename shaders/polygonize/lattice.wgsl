#import record/lattice

// Bricks of 4³ cells over a lattice. A brick has 125 places for nodes, 5 along x, then y, then z, in arrays 128 a brick, and
// 64 cells.

@group(0) @binding(8) var<uniform> lattice: Lattice;

// of the header of a brick
fn brick_place(header: vec4u) -> vec3u {
  return vec3u(header.x & 1023u, (header.x >> 10u) & 1023u, header.x >> 20u);
}

fn node_place(node: u32) -> vec3u {
  return vec3u(node % 5u, (node / 5u) % 5u, node / 25u);
}

fn cell_place(cell: u32) -> vec3u {
  return vec3u(cell & 3u, (cell >> 2u) & 3u, cell >> 4u);
}

// mm
fn node_position(n: vec3u) -> vec3f {
  return lattice.origin + lattice.step * vec3f(n);
}

// −1, 0 or 1 along each axis: which sides of the lattice a node lies on
fn node_side(n: vec3u) -> vec3i {
  let last = 4u * lattice.bricks.xyz;
  return select(select(vec3i(0), vec3i(-1), n == vec3u(0u)), vec3i(1), n == last);
}

// The border counts as outside, and so does what is no number.
fn is_inside(n: vec3u, value: f32) -> bool {
  return value > 0.0 && all(node_side(n) == vec3i(0));
}

fn unit_along(axis: u32) -> vec3u {
  return select(vec3u(0u), vec3u(1u), vec3u(0u, 1u, 2u) == vec3u(axis));
}

// bricks go along x first, and on in y, for a dispatch has 65 535 groups along an axis
fn brick_of(group: vec3u, groups: vec3u) -> u32 {
  return group.x + groups.x * group.y;
}

// of dispatches of 64 threads a group, which go on in y too
fn item_of(group: vec3u, groups: vec3u, thread: u32) -> u32 {
  return 64u * (group.x + groups.x * group.y) + thread;
}
