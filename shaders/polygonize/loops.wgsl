#import table/loops

// The pieces of surface in a cell, from a table of all cases (src/gpu/polygonize/loopTable.ts).

// the row of a cell: `mask` of corners inside, values of all; open faces are decided by their saddle as in src/field/cubeLoops.ts
fn loop_case(mask: u32, values: array<f32, 8>) -> u32 {
  var corner_values = values;
  var choice = 0u;
  var open = 0u;
  for (var face = 0u; face < 6u; face++) {
    let c = FACE_CORNERS[face];
    let inside = (vec4u(mask) >> c) & vec4u(1u);
    if (inside.x != inside.z || inside.y != inside.w || inside.x == inside.y) {
      continue;
    }
    let ac = corner_values[c.x] * corner_values[c.z];
    let bd = corner_values[c.y] * corner_values[c.w];
    choice |= u32(select(bd > ac, ac > bd, inside.x == 1u)) << open;
    open++;
  }
  return loop_table[mask].w + choice;
}

fn loop_count(row: vec4u) -> u32 {
  return row.z & 15u;
}

fn is_twisted(row: vec4u, loop_number: u32) -> bool {
  return ((row.z >> (4u + loop_number)) & 1u) == 1u;
}

fn loop_triangles(row: vec4u) -> u32 {
  return (row.z >> 8u) & 255u;
}

fn loop_middles(row: vec4u) -> u32 {
  return row.z >> 16u;
}

fn loop_end(row: vec4u, loop_number: u32) -> u32 {
  return (row.y >> (16u + 4u * loop_number)) & 15u;
}

fn loop_start(row: vec4u, loop_number: u32) -> u32 {
  return select(loop_end(row, max(loop_number, 1u) - 1u), 0u, loop_number == 0u);
}

// the i-th edge of all loops: the corner it begins at, and its axis
fn loop_edge(row: vec4u, i: u32) -> vec4u {
  let word = select(row.x, row.y, i >= 8u);
  let packed = (word >> (4u * (i & 7u))) & 15u;
  let axis = packed >> 2u;
  let below = packed & ((1u << axis) - 1u) & 3u;
  let corner = below | (((packed & 3u) >> axis) << (axis + 1u));
  return vec4u(corner & 1u, (corner >> 1u) & 1u, corner >> 2u, axis);
}
