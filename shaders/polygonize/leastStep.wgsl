// The shortest step onto several planes at once, as far as they agree: (JᵀJ + λ)⁻¹ Jᵀ F. Twin of leastStep in src/field/crease.ts; λ is larger, for
// float32 knows determinants to 1e-7 only.

// of the unit slopes' squares: directions that are known less do not count
const LEAST = 1e-4;

struct Planes {
  // Σ x², y², z²
  squares: vec3f,
  // Σ yz, zx, xy
  mixed: vec3f,
  // Σ of the normals by how far they are off
  off: vec3f,
}

// n · v = off
fn with_plane(planes: Planes, n: vec3f, off: f32) -> Planes {
  return Planes(planes.squares + n * n, planes.mixed + n.yzx * n.zxy, planes.off + off * n);
}

fn least_step(planes: Planes) -> vec3f {
  let s = planes.squares + LEAST;
  let m = planes.mixed;
  // cofactors
  let diagonal = s.yzx * s.zxy - m * m;
  let other = m.yzx * m.zxy - s * m;
  let det = dot(vec3f(s.x, m.z, m.y), vec3f(diagonal.x, other.z, other.y));
  let inverse = mat3x3f(
    vec3f(diagonal.x, other.z, other.y),
    vec3f(other.z, diagonal.y, other.x),
    vec3f(other.y, other.x, diagonal.z),
  );
  return inverse * planes.off / det;
}
