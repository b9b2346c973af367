#import polygonize/lattice

// The brick of a group: those that an edit reaches (src/gpu/polygonize/liveLists.ts).

@group(0) @binding(5) var<storage, read> chosen: array<u32>;

fn own_brick(group: vec3u, groups: vec3u) -> u32 {
  let at = brick_of(group, groups);
  if (at >= arrayLength(&chosen)) {
    return lattice.bricks.w;
  }
  return chosen[at];
}
