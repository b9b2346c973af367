#import bricks/level
#import polygonize/lattice

// All bricks are outside until something else is known, and all cubes of the first level are looked at.

@group(0) @binding(3) var<storage, read_write> grid: array<i32>;

@group(0) @binding(4) var<storage, read_write> dispatches: array<vec4u>;

@compute @workgroup_size(64)
fn begin(@builtin(global_invocation_id) id: vec3u, @builtin(num_workgroups) groups: vec3u) {
  for (var i = id.x; i < arrayLength(&grid); i += 64u * groups.x) {
    grid[i] = OUTSIDE;
  }
  if (id.x == 0u) {
    let along = (lattice.bricks.xyz + level.size - 1u) / level.size;
    dispatches[0] = vec4u(0u, 0u, 0u, along.x * along.y * along.z);
  }
}
