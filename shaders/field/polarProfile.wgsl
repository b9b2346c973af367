#import lib/atan
#import field/profiles

// Drawn section, m = 1/R(θ): m, ∂m/∂x, ∂m/∂y at q. Twin of src/field/polarProfile.ts.

const PER_SEGMENT = 12.0 / (2.0 * PI);

fn polar_profile(q: vec2f, profile: u32) -> vec3f {
  let large = max(abs(q.x), abs(q.y));
  if (large < 1e-30) {
    return vec3f(1.0, 0.0, 0.0);
  }
  let u = q / large;
  // half and quarter turns are exact: the angle that is left keeps its digits
  let half = select(u, -u, u.y < 0.0);
  let v = select(half, vec2f(half.y, -half.x), half.x < 0.0);
  let turn = PER_SEGMENT * angle_of(v.y, v.x);
  let within = min(u32(turn), 2u);
  let k = select(0u, 6u, u.y < 0.0) + select(0u, 3u, half.x < 0.0) + within;
  let t = turn - f32(within);
  let s = 1.0 - t;
  let r = profile_controls(profile, k);
  let m = 1.0 / (s * s * (s * r.x + 3.0 * t * r.y) + t * t * (3.0 * s * r.z + t * r.w));
  let slope = 3.0 * PER_SEGMENT * dot(vec3f(s * s, 2.0 * s * t, t * t), r.yzw - r.xyz);
  return vec3f(m, slope * m * m / (dot(u, u) * large) * vec2f(u.y, -u.x));
}

// the joints are halfway between their neighbours
fn profile_controls(profile: u32, k: u32) -> vec4f {
  let own = profile_radii(profile, k);
  let before = profile_radii(profile, (k + 11u) % 12u).y;
  let after = profile_radii(profile, (k + 1u) % 12u).x;
  return vec4f(0.5 * (before + own.x), own, 0.5 * (own.y + after));
}
