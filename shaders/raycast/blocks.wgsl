#import polygonize/lattice

// What blocks of 4³ bricks hold: OUTSIDE, INSIDE, or 0 where that is mixed. A thread is a block.

@group(0) @binding(0) var<storage, read> grid: array<i32>;
@group(0) @binding(1) var<storage, read_write> blocks: array<i32>;

@compute @workgroup_size(64)
fn blocks_of_bricks(@builtin(global_invocation_id) id: vec3u) {
  if (id.x >= arrayLength(&blocks)) {
    return;
  }
  let bricks = lattice.bricks.xyz;
  let along = (bricks + 3u) / 4u;
  let first = 4u * vec3u(id.x % along.x, id.x / along.x % along.y, id.x / along.x / along.y);
  let end = min(first + 4u, bricks);
  let kind = grid[first.x + bricks.x * (first.y + bricks.y * first.z)];
  var state = min(kind, 0);
  for (var z = first.z; z < end.z; z++) {
    for (var y = first.y; y < end.y; y++) {
      for (var x = first.x; x < end.x; x++) {
        state = select(state, 0, grid[x + bricks.x * (y + bricks.y * z)] != kind);
      }
    }
  }
  blocks[id.x] = state;
}
