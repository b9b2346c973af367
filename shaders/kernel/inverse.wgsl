#import kernel/oddMoments
#import kernel/oddEdge

// f = 1/r. Finite on a plate, logarithmic on a line.

fn inverse_value(r2: f32, exponent: f32) -> vec2f {
  return inverse_power_value(r2, 1.0);
}

fn inverse_line(f: LineFrame) -> vec3f {
  let m2 = floored(f);
  if (is_far(f, m2)) {
    return inverse_power_far(f, m2, 1.0);
  }
  let e = ends_of(f, m2);
  return from_moments(f, e, 1.0, odd_1(e), -0.5 * odd_3(e));
}

fn inverse_edge(f: EdgeFrame) -> vec3f {
  return odd_edge_1(f, odd_edge(f, max(f.z * f.z, f.floor2)));
}
