// Polynomials of the second degree about a place: constant; x, y, z; x², y², z²; xy, yz, zx. Twin of src/skeleton/taylor.ts.

struct Taylor {
  constant: f32,
  linear: vec3f,
  squares: vec3f,
  mixed: vec3f,
}

// A point source's: its kernel's value and derivatives in r², and the vector from it to the centre.
fn source_taylor(value: f32, first: f32, second: f32, d: vec3f) -> Taylor {
  return Taylor(value, 2.0 * first * d, first + 2.0 * second * d * d, 4.0 * second * d * d.yzx);
}

// about a centre that is v away
fn shifted_taylor(c: Taylor, v: vec3f) -> Taylor {
  let bent = c.squares * v + 0.5 * (c.mixed * v.yzx + c.mixed.zxy * v.zxy);
  return Taylor(c.constant + dot(c.linear + bent, v), c.linear + 2.0 * bent, c.squares, c.mixed);
}

// of l(v) = transposed rows · v
fn mapped_taylor(local: Taylor, rows: mat3x3f) -> Taylor {
  let s = 2.0 * local.squares;
  let m = local.mixed;
  let bent = rows * mat3x3f(s.x, m.x, m.z, m.x, s.y, m.y, m.z, m.y, s.z) * transpose(rows);
  let squares = 0.5 * vec3f(bent[0].x, bent[1].y, bent[2].z);
  return Taylor(local.constant, rows * local.linear, squares, vec3f(bent[0].y, bent[1].z, bent[2].x));
}
