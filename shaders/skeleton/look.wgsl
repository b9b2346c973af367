#import kernel/most
#import record/bound
#import record/point
#import record/polygon
#import record/segment
#import record/term
#import skeleton/rim

// How far a skel is from a ball, and whether singular kernels are clamped there. Twin of what each skel brings to src/skeleton/sight.ts.

// of bounds that are products of positive numbers
const SAFE = 1.0001;
// of distances, and of the length of a segment from whose line they are taken
const BLUR = 2e-6;
// what sums over edges leave, in parts of the largest field at the point's height, and from afar of the field times the distance
const RESIDUE = 1e-5;

// A skel seen from the centre of a ball, kernel units.
struct Look {
  // of the skel, not more than it is
  r: f32,
  // of the ball
  by: f32,
  // at least what the skel is away from the ball
  near: f32,
  // the ball is where singular kernels are not clamped
  is_clear: bool,
  // beyond the support, or of weight 0
  is_nothing: bool,
  // of values: what sums over edges leave of the field elsewhere
  slack: f32,
}

fn look_at(bound: Bound, term: Term, p: vec3f, radius: f32) -> Look {
  if (HAS_PLATES && bound.dimension == 2u) {
    return look_at_plate(bound, load_polygon(term.skel), p, radius * bound.per * SAFE);
  }
  var distance: f32;
  var axis = 0.0;
  if (!HAS_LINES || bound.dimension == 0u) {
    let skel = load_point(term.skel);
    distance = length((p - skel.at) * skel.scale);
    axis = distance;
  } else {
    let skel = load_segment(term.skel);
    let v = (p - skel.a) * skel.scale;
    let t = dot(v, skel.u);
    let from_line = length(v - t * skel.u);
    distance = length(v - clamp(t, 0.0, skel.length) * skel.u);
    axis = from_line - BLUR * (skel.length + abs(t));
    distance = max(distance - BLUR * skel.length, 0.0);
  }
  let by = radius * bound.per * SAFE;
  let is_clear = bound.least == 0.0 || axis - by >= 2.0 * bound.least;
  return look_from(bound, distance, by, is_clear, 0.0);
}

fn look_from(bound: Bound, distance: f32, by: f32, is_clear: bool, slack: f32) -> Look {
  let near = max(distance - by - BLUR * (distance + by), 0.0);
  let r = max(distance * (1.0 - BLUR), bound.least);
  let is_nothing = bound.most == 0.0 || (near >= bound.support && slack == 0.0);
  return Look(r, by, near, is_clear, is_nothing, slack);
}

// Plates of singular kernels, which are clamped over all of their planes, are the CPU's.
fn look_at_plate(bound: Bound, skel: Polygon, p: vec3f, by: f32) -> Look {
  let v = (p - skel.origin) * skel.scale;
  let foot = vec2f(dot(v, skel.u), dot(v, skel.v));
  let height = abs(dot(v, skel.n) - skel.lift);
  let blur = BLUR * (skel.radius + length(v));
  let low = max(height - by - blur, 0.0);
  let far = max(length(v) - by - blur, 0.0);
  // nothing at all is left beyond the circle around it
  if (length(foot) - by - blur > skel.radius + bound.support || low > bound.support) {
    return look_from(bound, max(max(length(foot) - skel.radius, height) - blur, 0.0), by, true, 0.0);
  }
  let rim = rim_of(skel, foot);
  let across = select(0.0, sqrt(rim.distance2), rim.turns == 0);
  var slack = most_at(bound, low);
  if (bound.power > 2.0 || bound.change != CHANGE_POWER) {
    slack += (1.0 + far / skel.radius) * most_at(bound, max(far - skel.radius, low));
  } else {
    // planes of these have no end: in parts of what edges come to
    slack = 6.2831853 * bound.turns * bound.most * pow(1.0 + far, max(2.0 - bound.power, 0.0));
  }
  return look_from(bound, max(length(vec2f(across, height)) - blur, 0.0), by, true, RESIDUE * slack);
}

// θ of the ball, above 1 where nothing is known
fn look_theta(bound: Bound, look: Look) -> f32 {
  return look.by * inverseSqrt(max(bound.core + look.r * look.r, 1e-30)) * (1.0 + BLUR);
}
