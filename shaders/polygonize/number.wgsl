#import polygonize/loops
#import polygonize/lattice

// What is crossed in a brick, numbered from 0 on; how many there are is scanned next. A thread is a brick: barriers, which several
// threads would need, cost software adapters more than the rest of the mesh.

// of each place for a node, four at a time: crossed axes as classify.wgsl left them, then + 8 · vertices before
@group(0) @binding(1) var<storage, read_write> crossings: array<vec4u>;
// of each cell, two at a time: row of the loop table, then + 65536 · cells before; triangles before + 65536 · middles before
@group(0) @binding(2) var<storage, read_write> cells: array<vec4u>;
// of each brick: vertices on edges, crossed cells, triangles, vertices in the middle of loops
@group(0) @binding(3) var<storage, read_write> counts: array<vec4u>;

@compute @workgroup_size(64)
fn number(@builtin(global_invocation_id) id: vec3u) {
  let brick = id.x;
  if (brick >= arrayLength(&counts)) {
    return;
  }
  var before = vec4u(0u);
  // where no brick is active there is one count all the same
  if (brick < lattice.bricks.w) {
    for (var i = 32u * brick; i < 32u * (brick + 1u); i++) {
      before.x = number_nodes(i, before.x);
    }
    for (var i = 32u * brick; i < 32u * (brick + 1u); i++) {
      let two = cells[i];
      if (any(two.xz != vec2u(0u))) {
        let after = before + counted(two.x);
        cells[i] = vec4u(numbered(two.x, before), numbered(two.z, after));
        before = after + counted(two.z);
      }
    }
  }
  counts[brick] = before;
}

// returns the vertices before the next four nodes
fn number_nodes(i: u32, before: u32) -> u32 {
  let axes = crossings[i];
  let ones = countOneBits(axes);
  let two = ones.x + ones.y;
  crossings[i] = axes | ((vec4u(0u, ones.x, two, two + ones.z) + before) << vec4u(3u));
  return before + two + ones.z + ones.w;
}

fn counted(row: u32) -> vec4u {
  let pieces = loop_table[row];
  return vec4u(0u, u32(loop_count(pieces) != 0u), loop_triangles(pieces), loop_middles(pieces));
}

fn numbered(row: u32, before: vec4u) -> vec2u {
  return vec2u(row | (before.y << 16u), before.z | (before.w << 16u));
}
