#import field/warp
#import record/bound
#import record/term
#import record/warp
#import section
#import skeleton/spread
#import table/change
#import table/numbers

// A ball in the frame of a skel that has a cross section, and what its field may be there, brought back. Twin of src/field/warped.ts.

// of coordinates, and of lengths that sections compute
const WARP_ROUNDING = 1e-5;

struct Seen {
  // the centre, and how far the ball's points are from there at most
  place: vec3f,
  reach: f32,
  // how far they are from where the derivatives take them
  bend: f32,
  is_linear: bool,
  // across the skel, before the section
  q: vec2f,
  stretch: vec3f,
}

fn seen_from(bound: Bound, term: Term, p: vec3f, radius: f32) -> Seen {
  if (!HAS_SECTIONS || term.warp == 0u) {
    return Seen(p, radius, 0.0, true, p.xy, vec3f(1.0, 0.0, 0.0));
  }
  let warp = load_warp(term.warp);
  let q = warp_place(p, warp.origin, warp.axes, warp.scale);
  let stretch = section_stretch(warp.section, q.xy, warp);
  let off = WARP_ROUNDING * (dot(abs(p - warp.origin), vec3f(1.0)) + radius);
  let by = radius + off;
  let r = by / warp.scale;
  let place = warp_mapped(q, stretch);
  if (warp.section == ROUND) {
    return Seen(place, max(max(r.x, r.y), by), off, true, q.xy, stretch);
  }
  let across = section_move(bound, warp, q.xy, stretch.x, r);
  let reach = sqrt(across * across + by * by) * (1.0 + WARP_ROUNDING);
  let rho = length(q.xy);
  let most = max(r.x, r.y);
  let bend = select(HUGE, 0.5 * bound.section.x * most * most / max(rho - most, 1e-30), most < rho);
  return Seen(place, reach, min(bend + off, HUGE), false, q.xy, stretch);
}

// The way of a place across the skel, when it goes by at most r, on the section's own radius: q is at m |q|.
fn section_move(bound: Bound, warp: Warp, q: vec2f, m: f32, r: vec2f) -> f32 {
  let rho = length(q);
  let by = max(r.x, r.y);
  if (warp.section == POLAR) {
    let sine = min(by / max(rho, 1e-30), 1.0);
    let swing = select(HUGE, bound.section.y * sine * inverseSqrt(max(1.0 - sine * sine, 0.1)), sine < 0.9);
    let least = max(bound.section.z, 1.0 / m - swing);
    let most = min(bound.section.w, 1.0 / m + swing);
    return radial_move(rho, by, m * rho, max(rho - by, 0.0) / most, (rho + by) / least);
  }
  // lengths that rise with both coordinates
  let low = section_length(warp, max(abs(q) - r, vec2f(0.0)));
  return radial_move(rho, by, m * rho, low, section_length(warp, abs(q) + r));
}

fn section_length(warp: Warp, q: vec2f) -> f32 {
  return section_stretch(warp.section, q, warp).x * length(q);
}

// Twin of radialMove in src/field/section.ts.
fn radial_move(rho: f32, radius: f32, at: f32, low: f32, high: f32) -> f32 {
  let sine = select(1.0, radius / max(rho, 1e-30), radius < rho);
  let square = sine * sine;
  // of the chord on the unit circle
  let chord2 = select(4.0, 2.0 * square / (1.0 + sqrt(1.0 - square)), sine < 1.0);
  let along = max(high - at, at - low);
  return sqrt(along * along + at * high * chord2) * (1.0 + WARP_ROUNDING) + WARP_ROUNDING * high;
}

// The map keeps quadratics only where it is linear; elsewhere nothing stands for the skel.
fn seen_stand_in(bound: Bound, look: Look, seen: Seen, most: f32) -> StandIn {
  var found = stand_in(bound, look, most);
  if (!seen.is_linear && found.missed > 0.0) {
    found.missed = HUGE;
  }
  return found;
}

fn seen_taylor(term: Term, seen: Seen, local: Taylor) -> Taylor {
  if (!HAS_SECTIONS || term.warp == 0u) {
    return local;
  }
  let warp = load_warp(term.warp);
  let stretch = seen.stretch.x / warp.scale;
  return mapped_taylor(local, mat3x3f(warp.axes[0] * stretch.x, warp.axes[1] * stretch.y, warp.axes[2]));
}

// with its gradient brought back, or where the map bends too much for that without one
fn seen_spread(term: Term, seen: Seen, local: Spread) -> Spread {
  if (!HAS_SECTIONS || term.warp == 0u) {
    return local;
  }
  let g = local.centre.yzw;
  let swing = seen.reach * length(g) * SAFE + local.rest;
  let low = max(local.low, local.centre.x - swing);
  let high = min(local.high, local.centre.x + swing);
  let half = 0.5 * (high - low);
  let across = length(g.xy);
  let rest = local.rest + across * min(seen.bend, 1e6) + MARGIN * seen.reach * across;
  if (rest >= half) {
    return Spread(vec4f(low + half, 0.0, 0.0, 0.0), half, low, high);
  }
  let warp = load_warp(term.warp);
  let gradient = warp_gradient(vec3f(seen.q, 0.0), seen.stretch, g, warp.axes, warp.scale);
  return Spread(vec4f(local.centre.x, gradient), rest, low, high);
}
