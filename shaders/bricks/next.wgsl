#import bricks/level

// After a level: whether all that was kept found room, and how many groups take what comes next: 32 of the eighths of its cubes, or after
// the last one a brick.

@group(0) @binding(2) var<storage, read> counters: array<u32>;
@group(0) @binding(4) var<storage, read_write> dispatches: array<vec4u>;
// Lattice as numbers; the eighth: active bricks
@group(0) @binding(5) var<storage, read_write> lattice_words: array<u32>;

@compute @workgroup_size(1)
fn next() {
  let cubes = counters[cubes_of(level.number)];
  let rows = counters[rows_of(level.number)];
  let fits = cubes <= level.room && level.entries + rows <= level.end;
  let kept = select(0u, cubes, fits);
  let is_last = level.size == 1u;
  let wanted = select((8u * kept + 31u) / 32u, kept, is_last);
  let lines = max((wanted + 65534u) / 65535u, 1u);
  dispatches[level.number + 1u] = vec4u((wanted + lines - 1u) / lines, lines, 1u, select(8u * kept, kept, is_last));
  if (is_last) {
    lattice_words[7] = kept;
  }
}
