#import kernel/change
#import record/bound
#import record/segment
#import skeleton/taylor
#import table/sources

// A segment as a few point sources, Gauss points with the weight there. Twin of src/skeleton/gaussSources.ts.

struct Sources {
  // of them
  count: u32,
  // by how much they are off, in parts of most · l · k(near)
  off: f32,
}

// As few as `enough` allows, at all places that are `near` or farther.
fn sources_for(bound: Bound, near: f32, enough: f32) -> Sources {
  let x = bound.size * inverseSqrt(bound.core + near * near);
  // c_m x^m: of m = 2 count, and of the two and one before
  var terms = vec4f(1.0, 0.0, 0.0, 0.0);
  var found = Sources(1u, 0.0);
  for (var count = 1u; count <= MOST_SOURCES; count++) {
    let m = 2.0 * f32(count);
    let odd = terms.x * x * (m - 2.0 + bound.power) / (m - 1.0);
    let even = odd * x * (m - 1.0 + bound.power) / m;
    terms = vec4f(even, odd, terms.xy);
    found = Sources(count, SOURCE_SHARES[count] * dot(bound.bends, terms));
    if (found.off <= enough) {
      break;
    }
  }
  return found;
}

// `factor` times the polynomial of `count` sources about p, mm.
fn sources_taylor(bound: Bound, skel: Segment, count: u32, p: vec3f, factor: f32) -> Taylor {
  let per2 = skel.scale * skel.scale;
  let from_a = p - skel.a;
  var sum = Taylor(0.0, vec3f(0.0), vec3f(0.0), vec3f(0.0));
  let start = count * (count - 1u) / 2u;
  for (var i = start; i < start + count; i++) {
    let source = SOURCES[i];
    let t = skel.length * source.x;
    let d = from_a - (t / skel.scale) * skel.u;
    let q = 1.0 / (bound.core + per2 * dot(d, d));
    let w = skel.weights;
    let weight = w.x + t * (w.y + t * (w.z + t * w.w));
    let value = factor * skel.length * source.y * weight * half_power(1.0 / q, bound.power);
    let first = -0.5 * bound.power * q * value * per2;
    let one = source_taylor(value, first, -(0.5 * bound.power + 1.0) * q * first * per2, d);
    sum.constant += one.constant;
    sum.linear += one.linear;
    sum.squares += one.squares;
    sum.mixed += one.mixed;
  }
  return sum;
}
