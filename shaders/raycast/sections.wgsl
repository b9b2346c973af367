#import field/warped
#import raycast/terms

// What a term with a cross section is ahead: by what derivatives and bends of its map come to, up to half the way to its axis. Twin of `ahead`
// in src/field/warped.ts. Rounding, which `Seen` counts among bends, bends nothing here.

// `local`: value and gradient of the plain skel where the map takes p; `reach`: mm of the sum
fn add_section_ahead(ahead: ptr<function, Ahead>, bound: Bound, term: Term, local: vec4f, p: vec3f, reach: f32) {
  let warp = load_warp(term.warp);
  let at = seen_from(bound, term, p, 0.0);
  let r = min(reach, 0.5 * length(at.q) * min(warp.scale.x, warp.scale.y));
  let seen = seen_from(bound, term, p, r);
  let bend = max(seen.bend - WARP_ROUNDING * (dot(abs(p - warp.origin), vec3f(1.0)) + r), 0.0);
  let by = SAFE * (steepest(seen, warp.scale) + bend / r);
  if (!(r > 0.0 && by < MOST_STRETCH)) {
    (*ahead).width = 0.0;
    return;
  }
  var own = Ahead(0.0, FREE, 0.0, 4.0);
  add_ahead(&own, bound, term, local.x, at.place, by * r);
  (*ahead).loose += own.loose * by * by;
  (*ahead).bend += own.bend * by * by + 2.0 * length(local.yz) * bend / (r * r);
  (*ahead).width = min((*ahead).width, min(own.width / by, select(FREE, r, r < reach)));
  if (own.loose > 0.0) {
    (*ahead).power = own.power;
  }
}

// more than any section stretches whose map is smooth
const MOST_STRETCH = 1e6;

// how far the map stretches at the place, at most
fn steepest(seen: Seen, scale: vec2f) -> f32 {
  let x = vec2f(seen.stretch.x + seen.q.x * seen.stretch.y, seen.q.x * seen.stretch.z) / scale;
  let y = vec2f(seen.q.y * seen.stretch.y, seen.stretch.x + seen.q.y * seen.stretch.z) / scale;
  return max(sqrt(dot(x, x) + dot(y, y)), 1.0);
}
