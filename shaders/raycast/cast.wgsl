#import raycast/camera
#import raycast/tree
#import raycast/walk

// A ray a pixel onto the surface itself: through the bricks, in each in steps that surely do not go through it; where these are shorter than a
// part of a pixel the sign decides. Twin of src/field/raycast.ts. A thread is a pixel.

// normal in the model, mm before the pivot's plane
@group(0) @binding(2) var<storage, read_write> surface: array<vec4f>;
@group(0) @binding(3) var<storage, read_write> colours: array<vec4f>;
// sixteenths of the terms that were asked, rounded up for each ray; rays that were given up
@group(0) @binding(4) var<storage, read_write> work: array<atomic<u32>, 2>;

// of a pixel: shorter steps are none
const FINEST = 0.015625;
// looks at most, or looks and terms, so that cheap trees may be looked at more often; who needs more grazes a surface all along
const MOST_LOOKS = 1024u;
const MOST_WORK = 4096u;
const NARROWINGS = 12u;
const POLISHES = 3u;
// of what is left, and of the lattice: a step that short leaves nothing to be seen; float32 knows no less
const CLOSE = 1e-3;
const CLOSE_TO_SIZE = 1e-6;
// of the lattice: what near lists miss may move the hit so far along the ray before all skels are asked
const MISSED = 3e-4;

const MARCH = 0u;
const NARROW = 1u;
const POLISH = 2u;
const NORMAL = 3u;
const PAINT = 4u;
const NOTHING = 5u;

// One place after the other, whatever for: one call, for compilers put the whole field in the place of each.
struct Caster {
  mode: u32,
  // what is looked at: where the brick's entries begin, or WHOLE
  list: u32,
  error: f32,
  t: f32,
  // the last place before, and the value there; the first behind
  before: f32,
  at_before: f32,
  behind: f32,
  rounds: u32,
  // how far polishing may go
  most: f32,
  is_inside: bool,
  knows_side: bool,
  normal: vec3f,
}

@compute @workgroup_size(8, 8)
fn cast_pixels(@builtin(global_invocation_id) id: vec3u) {
  let x = id.x + camera.first.x;
  let y = id.y + camera.first.y;
  if (x >= camera.end.x || y >= camera.end.y) {
    return;
  }
  let pixel = x + camera.stride * y;
  let ray = pixel_ray(x, y);
  var span = lattice_span(ray.start, ray.along, ray.nearest);
  span.y = min(span.y, reach_to(surface[pixel].w, ray));
  if (span.x >= span.y || lattice.bricks.w == 0u) {
    return;
  }
  // places are counted from where the lattice begins: there float32 is fine
  let start = ray.start + span.x * ray.along;
  let finest = FINEST * (ray.pixel + ray.growth * span.x);
  var walk = walk_begin(start, ray.along, 0.0, span.y - span.x);
  var c: Caster;
  c.knows_side = span.z >= 0.0;
  find_brick(&c, &walk, true);
  var asked = 0u;
  for (var looks = 0u; (looks < MOST_LOOKS || looks + asked < MOST_WORK) && c.mode != NOTHING; looks++) {
    let p = start + c.t * ray.along;
    let is_paint = c.mode == PAINT;
    asked_terms = 0u;
    let reach = select(0.0, max(walk.leave - c.t, 0.0), c.mode == MARCH);
    if (is_paint && camera.colour.w == 1.0) {
      put_pixel(pixel, c.normal, dot(p - camera.pivot, camera.back), camera.colour.xyz);
      break;
    }
    let seen = seen_tree(c.list, camera.leaves, p, ray.along, reach, is_paint);
    asked += asked_terms;
    if (is_paint) {
      put_pixel(pixel, c.normal, dot(p - camera.pivot, camera.back), seen.field.yzw);
      break;
    }
    let slope = dot(seen.field.yzw, ray.along);
    switch c.mode {
      case MARCH: {
        march(&c, &walk, seen, finest + FINEST * ray.growth * c.t);
      }
      case NARROW: {
        narrow(&c, seen.field.x, slope);
      }
      case POLISH: {
        polish(&c, seen.field.x, slope);
      }
      default: {
        c.mode = PAINT;
      }
    }
    if (c.mode == PAINT) {
      c.normal = outward(seen.field.yzw);
      // where the lattice cuts the body off
      if (c.t == 0.0 && span.z >= 0.0) {
        c.normal = -sign(ray.along) * vec3f(vec3u(0u, 1u, 2u) == vec3u(u32(span.z)));
      }
    }
  }
  atomicAdd(&work[0], (asked + 15u) / 16u);
  // a hit leaves the loop with its mode
  atomicAdd(&work[1], u32(c.mode != NOTHING && c.mode != PAINT));
}

// how far along the ray it is to what is there already, and a pixel farther
fn reach_to(before: f32, ray: PixelRay) -> f32 {
  let slope = dot(ray.along, camera.back);
  if (before == NOWHERE || slope >= 0.0) {
    return 3e38;
  }
  let t = (before - dot(ray.start - camera.pivot, camera.back)) / slope;
  return t + ray.pixel + ray.growth * t;
}

// On to the next brick that may hold surface, or to what is surely on the other side.
fn find_brick(c: ptr<function, Caster>, walk: ptr<function, Walk>, is_first: bool) {
  var is_there = is_first || walk_next(walk);
  while (is_there && (*walk).state < 0) {
    if (!(*c).knows_side) {
      (*c).knows_side = true;
      (*c).is_inside = (*walk).state == INSIDE;
    } else if ((*c).is_inside != ((*walk).state == INSIDE)) {
      (*c).mode = NORMAL;
      (*c).list = WHOLE;
      (*c).t = (*walk).enter;
      return;
    }
    is_there = walk_next(walk);
  }
  if (!is_there) {
    (*c).mode = NOTHING;
    return;
  }
  let header = lists[u32((*walk).state)];
  (*c).mode = MARCH;
  (*c).list = header.y;
  (*c).error = bitcast<f32>(header.z);
  (*c).t = (*walk).enter;
  (*c).before = (*walk).enter;
}

fn march(c: ptr<function, Caster>, walk: ptr<function, Walk>, seen: Sighted, finest: f32) {
  let value = seen.field.x;
  let is_positive = value > 0.0;
  if (!(*c).knows_side) {
    (*c).knows_side = true;
    (*c).is_inside = is_positive;
  }
  if (is_positive != (*c).is_inside) {
    if ((*c).t == (*c).before) {
      (*c).mode = NORMAL;
      return;
    }
    (*c).mode = NARROW;
    (*c).behind = (*c).t;
    (*c).rounds = 0u;
    (*c).t = mix((*c).before, (*c).t, (*c).at_before / ((*c).at_before - value));
    return;
  }
  (*c).before = (*c).t;
  (*c).at_before = value;
  (*c).t = min((*c).t + max(seen.sight.clear, finest), (*walk).leave);
  if ((*c).before + seen.sight.clear >= (*walk).leave || (*c).t <= (*c).before) {
    find_brick(c, walk, false);
  }
}

fn narrow(c: ptr<function, Caster>, value: f32, slope: f32) {
  let step = -value / slope;
  let close = max(CLOSE * ((*c).behind - (*c).before), CLOSE_TO_SIZE * camera.size);
  (*c).rounds += 1u;
  if (abs(step) <= close || (*c).rounds >= NARROWINGS) {
    (*c).t += select(0.0, step, abs(step) <= close);
    (*c).mode = PAINT;
    if ((*c).error > MISSED * camera.size * abs(slope)) {
      (*c).mode = POLISH;
      (*c).list = WHOLE;
      (*c).rounds = 0u;
      (*c).most = 2.0 * (*c).error / abs(slope);
    }
    return;
  }
  if ((value > 0.0) == (*c).is_inside) {
    (*c).before = (*c).t;
  } else {
    (*c).behind = (*c).t;
  }
  let next = (*c).t + step;
  (*c).t = select(0.5 * ((*c).before + (*c).behind), next, next > (*c).before && next < (*c).behind);
}

// onto the surface of all skels
fn polish(c: ptr<function, Caster>, value: f32, slope: f32) {
  let step = -value / slope;
  (*c).rounds += 1u;
  let is_within = abs(step) <= (*c).most;
  (*c).t += select(0.0, step, is_within);
  if (!is_within || abs(step) < CLOSE_TO_SIZE * camera.size || (*c).rounds >= POLISHES) {
    (*c).mode = PAINT;
  }
}

fn outward(gradient: vec3f) -> vec3f {
  let most = max(abs(gradient.x), max(abs(gradient.y), abs(gradient.z)));
  if (!(most > 0.0 && most < 3e38)) {
    return vec3f(0.0);
  }
  return -normalize(gradient / most);
}

// bodies are cast one after the other: the nearest stays
fn put_pixel(at: u32, normal: vec3f, before: f32, colour: vec3f) {
  if (before > surface[at].w) {
    surface[at] = vec4f(camera.turn * normal, before);
    colours[at] = vec4f(colour, camera.number);
  }
}
