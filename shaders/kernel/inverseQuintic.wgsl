#import kernel/oddMoments
#import kernel/oddEdge

// f = 1/r⁵; over a polygon from the solid angle by recurrence (oddEdge.wgsl).

fn inverse_quintic_value(r2: f32, exponent: f32) -> vec2f {
  return inverse_power_value(r2, 5.0);
}

fn inverse_quintic_line(f: LineFrame) -> vec3f {
  let m2 = floored(f);
  if (is_far(f, m2)) {
    return inverse_power_far(f, m2, 5.0);
  }
  let e = ends_of(f, m2);
  let third = odd_3(e);
  let mean = averages(e);
  let fifth = odd_5(e, third, mean);
  return from_moments(f, e, 5.0, fifth, -2.5 * odd_7(e, third, fifth, mean));
}

fn inverse_quintic_edge(f: EdgeFrame) -> vec3f {
  return odd_edge_5(f, odd_edge(f, max(f.z * f.z, f.floor2)));
}
