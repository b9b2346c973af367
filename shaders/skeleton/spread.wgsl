#import kernel/change
#import kernel/most
#import record/bound
#import record/point
#import record/segment
#import record/term
#import skeleton/gaussSources
#import skeleton/look
#import skeleton/taylor

// What a skel's field may be within a ball. Twin of src/skeleton/spread.ts, whose bounds float32 keeps by margins: what is computed
// is good to a hundredth of them.

// of the largest field that the skel can have there
const MARGIN = 1e-4;
// of what is added up in polynomials
const ROUNDING = 1e-6;
// √floor over distance times n and a safe 2: what the clamp of singular lines changes beyond their ends
const CLAMPED = 12.0;
// what sources may be off by, in parts of what their polynomial leaves out
const SOURCE_PART = 0.1;

struct StandIn {
  // a bound on what it leaves out, HUGE where none is known
  missed: f32,
  // sources of a segment
  count: u32,
}

// What stands for the skel from afar; `most`: what may be missed at all.
fn stand_in(bound: Bound, look: Look, most: f32) -> StandIn {
  if (look.is_nothing) {
    return StandIn(0.0, 0u);
  }
  if (HAS_SLOPES && bound.change != CHANGE_POWER) {
    let most_there = select(0.0, most_at(bound, look.near), look.near < bound.support);
    return StandIn(SAFE * most_there + look.slack, 0u);
  }
  let theta = look_theta(bound, look);
  if (!look.is_clear || look.near < bound.least || theta >= 1.0) {
    return StandIn(HUGE, 0u);
  }
  let whole = most_at(bound, look.r);
  let is_plate = HAS_PLATES && bound.dimension == 2u;
  let bend = power_rest(theta, bound.power, select(3u, 2u, is_plate));
  if (!(whole * bend <= most)) {
    return StandIn(HUGE, 0u);
  }
  var off = 0.0;
  var count = 1u;
  if (HAS_LINES && bound.dimension == 1u) {
    let field = bound.most * bound.size * kernel_at(bound, look.near * look.near);
    let sources = sources_for(bound, look.near, SOURCE_PART * bend * whole / field);
    off = field * sources.off;
    count = sources.count;
  }
  return StandIn(SAFE * ((whole + off) * bend + off) + ROUNDING * whole + look.slack, count);
}

// Whether that is made of the field itself, value and gradient.
fn stands_for_itself(bound: Bound) -> bool {
  return HAS_PLATES && bound.dimension == 2u && bound.change == CHANGE_POWER;
}

// Its polynomial about p, mm, where `field` is the term's; nothing of kernels that are no powers.
fn stand_in_taylor(bound: Bound, term: Term, count: u32, p: vec3f, field: vec4f) -> Taylor {
  if (stands_for_itself(bound)) {
    return Taylor(field.x, field.yzw, vec3f(0.0), vec3f(0.0));
  }
  if (count == 0u) {
    return Taylor(0.0, vec3f(0.0), vec3f(0.0), vec3f(0.0));
  }
  if (HAS_LINES && bound.dimension == 1u) {
    return sources_taylor(bound, load_segment(term.skel), count, p, term.factor);
  }
  let skel = load_point(term.skel);
  let d = p - skel.at;
  let per2 = skel.scale * skel.scale;
  let r2 = per2 * dot(d, d);
  let value = term.factor * skel.weight * half_power(bound.core + r2, bound.power);
  let q = 1.0 / (bound.core + r2);
  let first = -0.5 * bound.power * q * value * per2;
  return source_taylor(value, first, -(0.5 * bound.power + 1.0) * q * first * per2, d);
}

// F is from low to high, and |F − middle − ∂·v| ≤ rest, v from the centre of the ball.
struct Spread {
  // middle and gradient
  centre: vec4f,
  rest: f32,
  low: f32,
  high: f32,
}

// of a term, whose value and gradient in the middle are `centre`
fn term_spread(bound: Bound, look: Look, centre: vec4f) -> Spread {
  if (look.is_nothing) {
    return Spread(vec4f(0.0), 0.0, 0.0, 0.0);
  }
  var spread: Spread;
  let cap = select(0.0, most_at(bound, look.near), look.near < bound.support);
  if (!HAS_SLOPES || bound.change == CHANGE_POWER) {
    spread = power_spread(bound, look, centre, cap);
  } else {
    spread = slope_spread(bound, look, centre);
  }
  let margin = MARGIN * min(cap, 1e25) + look.slack;
  spread.low = max(spread.low, select(-cap, 0.0, bound.sign > 0.0)) - margin;
  spread.high = min(spread.high, select(cap, 0.0, bound.sign < 0.0)) + margin;
  spread.rest += margin;
  return tighter(spread);
}

fn power_spread(bound: Bound, look: Look, centre: vec4f, cap: f32) -> Spread {
  let whole = most_at(bound, look.r);
  let factors = power_factors(bound.core, bound.power, look.r, look.by) * vec2f(1.0 / SAFE, SAFE);
  let theta = look_theta(bound, look);
  // computed gradients are off too
  var bend = HUGE;
  if (theta < 1.0) {
    bend = SAFE * power_rest(theta, bound.power, 2u) + MARGIN * bound.power * theta;
  }
  if (look.r * look.r < BENT_UP_TO * bound.core) {
    let bent = power_bent(bound.core, bound.power, look.r, look.by);
    bend = min(bend, SAFE * bent + MARGIN * bound.power * theta);
  }
  if (!look.is_clear || look.near < bound.least) {
    let is_beyond = bound.dimension == 1u && look.near > bound.least;
    bend = select(HUGE, bend, is_beyond);
  }
  var spread = Spread(centre, 0.0, 0.0, 0.0);
  if (bound.sign == 0.0) {
    // whatever the signs, both parts of the field are within this
    let swing = min(whole * max(factors.y - 1.0, 1.0 - factors.x), HUGE);
    spread.low = centre.x - swing;
    spread.high = centre.x + swing;
    spread.rest = whole * bend;
  } else {
    let size = max(bound.sign * centre.x, 0.0);
    let margin = MARGIN * whole + look.slack;
    let low = max(size - margin, 0.0) * factors.x;
    let high = min((size + margin) * factors.y, HUGE);
    spread.low = select(-high, low, bound.sign > 0.0);
    spread.high = select(-low, high, bound.sign > 0.0);
    spread.rest = (size + margin) * bend;
  }
  if (!look.is_clear) {
    spread.rest += CLAMPED * cap * bound.least / max(look.near, bound.least);
  }
  return spread;
}

fn slope_spread(bound: Bound, look: Look, centre: vec4f) -> Spread {
  var slopes = slopes_of(bound, look.near, 0u);
  if (bound.dimension > 0u) {
    slopes = min(bound.size * slopes, bound.turns * slopes_of(bound, look.near, bound.dimension));
  }
  // weights of both signs may add up what both parts come to
  let by = select(1.0, 2.0, bound.sign == 0.0) * bound.most * look.by * SAFE;
  let swing = by * slopes.x;
  let rest = 0.5 * by * look.by * slopes.y + MARGIN * swing;
  return Spread(centre, rest, centre.x - swing, centre.x + swing);
}

fn slopes_of(bound: Bound, near: f32, dimension: u32) -> vec2f {
  if (HAS_GAUSSIAN && bound.change == CHANGE_GAUSSIAN) {
    return gaussian_slopes(near, dimension);
  }
  return quartic_slopes(near, dimension);
}

// A form whose rest is larger than half the interval says less: the middle, no gradient.
fn tighter(spread: Spread) -> Spread {
  let half = 0.5 * (spread.high - spread.low);
  if (spread.rest < half) {
    return spread;
  }
  return Spread(vec4f(spread.low + half, 0.0, 0.0, 0.0), half, spread.low, spread.high);
}
