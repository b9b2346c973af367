#import bricks/level

// Active bricks in each run of sixteen; how many there are before each is scanned next.

const RUN = 16u;

@group(0) @binding(3) var<storage, read> grid: array<i32>;
@group(0) @binding(6) var<storage, read_write> runs: array<vec4u>;

@compute @workgroup_size(64)
fn count(@builtin(global_invocation_id) id: vec3u) {
  if (id.x >= arrayLength(&runs)) {
    return;
  }
  var found = 0u;
  for (var i = RUN * id.x; i < min(RUN * (id.x + 1u), arrayLength(&grid)); i++) {
    found += u32(grid[i] >= 0);
  }
  runs[id.x] = vec4u(found, 0u, 0u, 0u);
}
