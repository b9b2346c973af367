#import polygonize/lattice

// The brick of a group: one after the other.
fn own_brick(group: vec3u, groups: vec3u) -> u32 {
  return brick_of(group, groups);
}
