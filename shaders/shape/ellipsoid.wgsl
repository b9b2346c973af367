// Ellipsoid about the origin: m g / sqrt(4 |n|² + max(g, 0)). Twin of src/shape/ellipsoid.ts, which says why.

fn ellipsoid_field(p: vec3f, radii: vec3f) -> vec4f {
  let least = min(radii.x, min(radii.y, radii.z));
  let e = least / radii;
  let q = p / radii;
  let n = q * e;
  // 1 - |q|² without the cancellation near the surface
  let size = length(q);
  let g = (1.0 - size) * (1.0 + size);
  let d = 4.0 * dot(n, n) + max(g, 0.0);
  let root = sqrt(d);
  let slope = g / (2.0 * d);
  let inner = select(0.0, slope, g > 0.0);
  return vec4f(least * g / root, (n / root) * (-2.0 + 2.0 * inner - 8.0 * slope * e * e));
}
