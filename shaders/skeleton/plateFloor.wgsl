#import record/polygon
#import record/edge

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
  var turns = 0;
  var rim2 = 1e30;
  for (var k = skel.first; k < skel.end; k += EDGE_STRIDE) {
    let edge = load_edge(k);
    let a = edge.start - foot;
    let b = edge.end - foot;
    let nearest = a + clamp(-dot(a, edge.u), 0.0, edge.length) * edge.u;
    rim2 = min(rim2, dot(nearest, nearest));
    turns += crossing(a, b);
  }
  return max(skel.floor2, select(0.0, BESIDE * BESIDE * rim2, turns == 0));
}

// 1 where the edge crosses the ray from the origin along x upwards, −1 downwards
fn crossing(a: vec2f, b: vec2f) -> i32 {
  if ((a.y > 0.0) == (b.y > 0.0)) {
    return 0;
  }
  let upwards = b.y > a.y;
  let is_right = (a.x * b.y - a.y * b.x > 0.0) == upwards;
  return select(0, select(-1, 1, upwards), is_right);
}
