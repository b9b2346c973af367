#import record/polygon
#import skeleton/rim

// How near its plane a point may come to a plate of a singular kernel, squared. Over the plate that is as near as the kernel
// allows. Beside it terms of size z^(2−n) cancel: a twentieth of the distance from its rim changes the field by 0.3 % there,
// and leaves r⁻³ and r⁻⁵ two digits, which would all be lost. Slower kernels do better without.
const BESIDE = 0.05;
// between those of r⁻² and r⁻³ (PLATE_FLOOR2 in src/kernel/floor.ts)
const SLOW = 1e-10;

fn plate_floor2(skel: Polygon, foot: vec2f, z: f32) -> f32 {
  let most = BESIDE * (length(foot) + skel.radius);
  if (skel.floor2 < SLOW || z * z >= most * most) {
    return skel.floor2;
  }
  let rim = rim_of(skel, foot);
  return max(skel.floor2, select(0.0, BESIDE * BESIDE * rim.distance2, rim.turns == 0));
}
