// What an ellipsoid's value may be within `radius` of p. Twin of `spread` in src/shape/ellipsoid.ts.

// of what values are made of
const ELLIPSOID_ROUNDING = 1e-5;

fn ellipsoid_range(p: vec3f, radius: f32, radii: vec3f) -> vec2f {
  let grown = radius + ELLIPSOID_ROUNDING * dot(abs(p), vec3f(1.0));
  let q0 = max(abs(p) - grown, vec3f(0.0)) / radii;
  let q1 = (abs(p) + grown) / radii;
  let least = min(radii.x, min(radii.y, radii.z));
  let e = least / radii;
  let flattest = min(e.x, min(e.y, e.z));
  let far2 = dot(q1, q1);
  let least2 = dot(q0 * e, q0 * e);
  let most2 = dot(q1 * e, q1 * e);
  let margin = ELLIPSOID_ROUNDING * (1.0 + far2);
  let low = 1.0 - far2 - margin;
  let high = 1.0 - dot(q0, q0) + margin;
  // f rises with g; with |n|² it falls where g > 0 and rises where g < 0, where |n| ≥ |q| times the least of e
  let thin2 = max(least2, far2 * flattest * flattest);
  let bottom = select(4.0 * thin2, 4.0 * most2 + low, low > 0.0);
  let top = select(4.0 * most2, 4.0 * least2 + high, high > 0.0);
  let ends = least * vec2f(low * inverseSqrt(bottom), high * inverseSqrt(top));
  let rounding = ELLIPSOID_ROUNDING * (least + abs(ends));
  return ends + vec2f(-rounding.x, rounding.y);
}
