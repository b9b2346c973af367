#import kernel/oddMoments
#import kernel/oddEdge

// f = 1/r³; over a polygon its solid angle by the height.

fn inverse_cubic_value(r2: f32, exponent: f32) -> vec2f {
  return inverse_power_value(r2, 3.0);
}

fn inverse_cubic_line(f: LineFrame) -> vec3f {
  let m2 = floored(f);
  if (is_far(f, m2)) {
    return inverse_power_far(f, m2, 3.0);
  }
  let e = ends_of(f, m2);
  let third = odd_3(e);
  return from_moments(f, e, 3.0, third, -1.5 * odd_5(e, third, averages(e)));
}

fn inverse_cubic_edge(f: EdgeFrame) -> vec3f {
  return odd_edge_3(f, odd_edge(f, max(f.z * f.z, f.floor2)));
}
