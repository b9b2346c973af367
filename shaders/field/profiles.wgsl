#import field/records

// The two inner radii of segment k of 12 of the profile that begins at `profile` (PROFILE in src/gpu/structs.ts).
fn profile_radii(profile: u32, k: u32) -> vec2f {
  let four = records[profile + (k >> 1u)];
  return bitcast<vec2f>(select(four.xy, four.zw, (k & 1u) == 1u));
}
