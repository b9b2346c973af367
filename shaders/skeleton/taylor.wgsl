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
