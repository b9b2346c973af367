#import kernel/frame
#import lib/atan
#import table/gauss

// f = (1 − r²)², 0 beyond r = 1, r in units of R. Gauss on the clipped line is exact (degree 7); polygons by signed
// angles instead of clipping lists (Zhu (12) gives the same numbers).

fn quartic_value(r2: f32, exponent: f32) -> vec2f {
  let q = max(1.0 - r2, 0.0);
  return vec2f(q * q, -2.0 * q);
}

fn quartic_line(f: LineFrame) -> vec3f {
  let g = sqrt(max(1.0 - f.rho2, 0.0));
  let lo = clamp(f.alpha, -g, g);
  let hi = clamp(f.beta, -g, g);
  var sum = vec3f(0.0);
  for (var i = 0u; i < 4u; i++) {
    let tau = mix(lo, hi, GAUSS_4[i].x);
    let q = (g - tau) * (g + tau);
    let w = weight_at(f, tau - f.alpha) * GAUSS_4[i].y;
    sum += w * vec3f(q * q, -2.0 * q, 4.0 * tau * q);
  }
  return (hi - lo) * sum;
}

fn quartic_edge(f: EdgeFrame) -> vec3f {
  let r2 = 1.0 - f.z * f.z;
  if (r2 <= 0.0) {
    return vec3f(0.0);
  }
  let g = sqrt(max(r2 - f.d * f.d, 0.0));
  let lo = clamp(f.alpha, -g, g);
  let hi = clamp(f.beta, -g, g);
  var inside = vec3f(0.0);
  for (var i = 0u; i < 3u; i++) {
    let tau = mix(lo, hi, GAUSS_3[i].x);
    let u = f.d * f.d + tau * tau;
    let value = (3.0 * r2 * (r2 - u) + u * u) / 6.0;
    inside += GAUSS_3[i].y * vec3f(f.d * value, -(r2 - u) * (r2 - u), f.d * (2.0 * r2 - u));
  }
  inside *= hi - lo;
  let angle = angle_outside(f, lo, hi);
  return vec3f(inside.x + r2 * r2 * r2 / 6.0 * angle, inside.y, -f.z * (inside.z + r2 * r2 * angle));
}

// signed angle at which the part of the edge outside the disc is seen: that of the complex product of its two parts
fn angle_outside(f: EdgeFrame, lo: f32, hi: f32) -> f32 {
  if (lo == f.alpha && hi == f.beta) {
    return 0.0;
  }
  let d2 = f.d * f.d;
  let before = vec2f(d2 + f.alpha * lo, f.d * (lo - f.alpha));
  let after = vec2f(d2 + f.beta * hi, f.d * (f.beta - hi));
  return angle_of(before.x * after.y + before.y * after.x, before.x * after.x - before.y * after.y);
}
