#import kernel/moments

// Moments J_0…J_3 of q^(−n/2), n = 1, 3, 5, 7, as in oddMoments.ts.

// ((ra + rb)² − length²)/2 without the difference
fn ellipse(e: Ends) -> f32 {
  let ends = e.alpha * e.beta;
  if (ends > 0.0) {
    return e.ra * e.rb + ends + e.m2;
  }
  let squares = e.m2 + e.alpha * e.alpha + e.beta * e.beta;
  return e.m2 * (1.0 + squares / (e.ra * e.rb - ends));
}

fn odd_1(e: Ends) -> vec4f {
  let sum = e.ra + e.rb;
  let j0 = log_1p(e.length * (sum + e.length) / ellipse(e));
  let j1 = e.area / sum;
  let j2 = 0.5 * (e.beta * e.rb - e.alpha * e.ra - e.m2 * j0);
  let j3 = (e.beta * e.beta * e.rb - e.alpha * e.alpha * e.ra - 2.0 * e.m2 * j1) / 3.0;
  return vec4f(j0, j1, j2, j3);
}

fn odd_3(e: Ends) -> vec4f {
  let lower = odd_1(e);
  let i = 1.0 / (e.ra * e.rb);
  let j0 = e.length * (e.ra + e.rb) * i / ellipse(e);
  let j1 = e.area * i / (e.ra + e.rb);
  return vec4f(j0, j1, lower.x - e.m2 * j0, lower.y - e.m2 * j1);
}

// With S = τ/r, dS = m2/r³ dτ: averages over S of polynomials of degree 4, for which three Gauss nodes are exact.
struct Averages { c: f32, cc: f32, ss: f32, ssc: f32 }

fn averages(e: Ends) -> Averages {
  let beyond = e.alpha * e.beta > 0.0;
  let flip = select(1.0, -1.0, beyond && e.alpha < 0.0);
  let sa = flip * e.alpha / e.ra;
  let sb = flip * e.beta / e.rb;
  // (1 − S)/m2, which beyond an end is known better than S
  let ga = select((1.0 - sa) / e.m2, 1.0 / (e.ra * (e.ra + abs(e.alpha))), beyond);
  let gb = select((1.0 - sb) / e.m2, 1.0 / (e.rb * (e.rb + abs(e.beta))), beyond);
  var sum = vec4f(0.0);
  for (var i = 0u; i < 3u; i++) {
    let node = GAUSS_3[i];
    let s = mix(sa, sb, node.x);
    let g = mix(ga, gb, node.x);
    let c = g * (2.0 - e.m2 * g);
    sum += node.y * vec4f(c, c * c, s * s, s * s * c);
  }
  return Averages(sum.x, sum.y, sum.z, sum.w);
}

fn odd_5(e: Ends, third: vec4f, mean: Averages) -> vec4f {
  let ra = sqrt(e.ia);
  let rb = sqrt(e.ib);
  let j1 = third.y * (e.ia + ra * rb + e.ib) / 3.0;
  return vec4f(third.x * mean.c, j1, third.x * mean.ss, third.y - e.m2 * j1);
}

fn odd_7(e: Ends, third: vec4f, fifth: vec4f, mean: Averages) -> vec4f {
  let ab = sqrt(e.ia * e.ib);
  let fourth = e.ia * e.ia + e.ib * e.ib + ab * (e.ia + e.ib) + ab * ab;
  let j1 = third.y * fourth / 5.0;
  return vec4f(third.x * mean.cc, j1, third.x * mean.ssc, fifth.y - e.m2 * j1);
}
